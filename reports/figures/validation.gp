# SPDX-License-Identifier: MIT
# The interval E +- 2 u_val in parts of the measured value for every set point, and the required accuracy as a band: one panel for each
# experiment, one colour and shape for each form of the model, filled where it was predicted blind. A triangle: it goes on beyond the axis.
width = 16
height = 10.4
columns = 1.4
load 'style.gp'
file = folder.'validation.csv'  # experiment,record,quantity,form,D,u_D,S,u_input,u_num,E,u_val,resolved,unit,blind,required
error(factor) = 100.0 * ($10 + factor * $11) / abs($5)
place(name) = int(sum [i = 1:words(quantities)] (word(quantities, i) eq name ? i : 0))
# The points of one quantity stand side by side, in the order of the table; each curve counts them again.
array used[8]
restart(row) = row > 0 ? 0 : (sum [i = 1:8] (used[i] = 0))
next(name) = (used[place(name)] = used[place(name)] + 1, place(name) + pitch * (used[place(name)] - 1) - 0.38)
at(k, when) = (restart($0), strcol(1) ne experiment ? NaN : (x = next(strcol(3)), \
    strcol(4) eq word(forms, k) && (when eq '' || strcol(14) eq when) ? x : NaN))
beyond(sign) = sign * error(2 * sign) > limit ? sign * limit : NaN
look = "linecolor rgb colours[3 - k] notitle"
curves = "set yrange [-limit:most]; set ytics y_step(limit + most, 0.25 * height); \
    plot file using (strcol(1) eq experiment && $15 > 0 ? place(strcol(3)) : NaN):(0):(0.45):(100 * $15) \
        with boxxyerror fillcolor rgb '#DDDDDD' fillstyle solid noborder notitle, \
    0 with lines linewidth 1.2 linecolor rgb black notitle, for [k = 1:2] file using (at(k, '')):(error(-2)):(0):(error(2) - error(-2)) \
        with vectors heads size screen 0.003, 90 linewidth 1.4 @look, \
    for [k = 1:2] file using (at(k, '1')):(error(0)) with points pointtype 9 - 2 * k pointsize 0.5 @look, \
    for [k = 1:2] file using (at(k, '0')):(error(0)) with points pointtype 9 - 2 * k pointsize 0.5 linecolor rgb 'white' notitle, \
    for [k = 1:2] file using (at(k, '0')):(error(0)) with points pointtype 8 - 2 * k pointsize 0.5 linewidth 1.2 @look, \
    for [k = 1:2] file using (at(k, '')):(beyond(1)) with points pointtype 9 pointsize 0.6 @look, \
    for [k = 1:2] file using (at(k, '')):(beyond(-1)) with points pointtype 11 pointsize 0.6 @look, \
    for [k = 1:2] keyentry with points pointtype 9 - 2 * k pointsize 0.6 linecolor rgb colours[3 - k] title word(titles, k)"
set clip two
set multiplot
set bmargin 2.8
set key above horizontal center
set size 1, 0.48; set origin 0, 0.52; set lmargin at screen across(7)
set ylabel fitted('(E ± 2u)/|D|, %', 0.3 * height)
set title fitted('Slider on paper (filled: predicted blind; open: after)', width)
set xrange [0.5:5.5]
set xtics ('period' 1, "force\nrange" 2, "fall\ntime" 3, "mean\nforce" 4, "rise\nratio" 5)
experiment = 'paper-slider'; forms = 'rigid lighter'; titles = '"published mass" "mass by one fall"'
quantities = 'period force_range fall_time mean_force rise_ratio'
limit = 100.0; most = 100.0; pitch = 0.06  # per cent
@curves
set size 0.5, 0.53; set origin 0, 0
set title 'Friction damper'
set xrange [0.5:3.5]
set xtics ("slip\nforce" 1, 'energy' 2, "peak\nforce" 3)
experiment = 'friction-damper'; forms = 'spring spring-and-play'; titles = '"spring, friction" "with play"'
quantities = 'slip_force energy peak_force'
limit = 65.0; most = 35.0; pitch = 0.044
@curves
set origin 0.5, 0; set lmargin at screen 0.5 + across(4)
unset ylabel
set title fitted('Strip without axial load, tip free', 0.5 * width)
set xrange [0.4:4.6]
set xtics ('f_1' 1, 'f_2' 2, 'f_3' 3, 'f_4' 4)
experiment = 'strip'; forms = 'dimensions first-frequency'; titles = '"by dimensions" "by frequency 1"'
quantities = 'frequency_1 frequency_2 frequency_3 frequency_4'
limit = 20.0; most = 20.0; pitch = 0.3
@curves
unset multiplot
set bmargin 2.8
