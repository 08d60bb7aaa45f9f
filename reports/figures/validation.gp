# SPDX-License-Identifier: MIT
# The interval E +- 2 u_val in parts of the measured value for every set point, with the line of zero error: one panel for each
# experiment, one colour for each form of the model. What lies beyond the axis is marked at its edge.
width = 16
height = 9.6
columns = 1.4
load 'style.gp'
file = folder.'validation.csv'  # experiment,record,quantity,form,D,u_D,S,u_input,u_num,E,u_val,resolved,unit
cut(x) = x > limit ? limit : x < -limit ? -limit : x
error(factor) = cut(100.0 * ($10 + factor * $11) / abs($5))
chosen(experiment, form) = strcol(1) eq experiment && strcol(4) eq form
place(name) = int(sum [i = 1:words(quantities)] (word(quantities, i) eq name ? i : 0))
# The points of one quantity stand side by side, in the order of the table.
array used[8]
next(name) = (used[place(name)] = used[place(name)] + 1, place(name) + 0.045 * (used[place(name)] - 1) - 0.3)
at(experiment, form) = chosen(experiment, form) ? next(strcol(3)) : NaN
bars = 'with yerrorbars pointsize 0.4'
set xzeroaxis linetype 1 linewidth 1.2 linecolor rgb black
set multiplot
set bmargin 2.8
set pointintervalbox 0
do for [i = 1:8] { used[i] = 0 }
limit = 100.0  # per cent
quantities = 'period force_range fall_time mean_force rise_ratio'
set size 1, 0.48; set origin 0, 0.52; set lmargin at screen across(7)
set ylabel fitted('(E ± 2u)/|D|, %', 0.3 * height)
set yrange [-limit:limit]
set ytics y_step(2 * limit, 0.25 * height)
set key above horizontal center
set title 'Slider on paper'
set xrange [0.5:5.5]
set xtics ('period' 1, "force\nrange" 2, "fall\ntime" 3, "mean\nforce" 4, "rise\nratio" 5)
plot file using (at('paper-slider', 'rigid')):(error(0)):(error(-2)):(error(2)) \
       @bars pointtype 7 linecolor rgb vermillion title 'published mass', \
     '' using (at('paper-slider', 'lighter')):(error(0)):(error(-2)):(error(2)) \
       @bars pointtype 5 linecolor rgb blue title 'mass by one fall'
do for [i = 1:8] { used[i] = 0 }
limit = 60.0
quantities = 'slip_force energy peak_force'
set size 0.5, 0.53; set origin 0, 0
set yrange [-limit:limit]
set ytics y_step(2 * limit, 0.25 * height)
set title 'Friction damper'
set xrange [0.5:3.5]
set xtics ("slip\nforce" 1, 'energy' 2, "peak\nforce" 3)
plot file using (at('friction-damper', 'spring')):(error(0)):(error(-2)):(error(2)) \
       @bars pointtype 7 linecolor rgb vermillion title 'spring, friction', \
     '' using (at('friction-damper', 'spring-and-play')):(error(0)):(error(-2)):(error(2)) \
       @bars pointtype 5 linecolor rgb blue title 'with play'
do for [i = 1:8] { used[i] = 0 }
limit = 20.0
quantities = 'frequency_1 frequency_2 frequency_3 frequency_4'
set origin 0.5, 0; set lmargin at screen 0.5 + across(4)
unset ylabel
set yrange [-limit:limit]
set ytics y_step(2 * limit, 0.25 * height)
set title fitted('Strip without axial load, tip free', 0.5 * width)
set xrange [0.4:4.5]
set xtics ('f_1' 1, 'f_2' 2, 'f_3' 3, 'f_4' 4)
plot file using (at('strip', 'dimensions')):(error(0)):(error(-2)):(error(2)) \
       @bars pointtype 7 linecolor rgb vermillion title 'by dimensions', \
     '' using (at('strip', 'first-frequency')):(error(0)):(error(-2)):(error(2)) \
       @bars pointtype 5 linecolor rgb blue title 'by frequency 1'
unset multiplot
set bmargin 2.8
