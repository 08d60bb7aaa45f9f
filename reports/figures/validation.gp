# SPDX-License-Identifier: MIT
# The interval E +- 2 u_val in parts of the measured value for every set point, with the line of zero error: one panel for each
# experiment, one colour for each form of the model. What lies beyond the axis is marked at its edge.
width = 16
height = 13
load 'style.gp'
file = folder.'validation.csv'  # experiment,record,quantity,form,D,u_D,S,u_input,u_num,E,u_val,resolved
limit = 100.0                   # per cent
cut(x) = x > limit ? limit : x < -limit ? -limit : x
error(factor) = cut(100.0 * ($10 + factor * $11) / abs($5))
chosen(experiment, form) = strcol(1) eq experiment && strcol(4) eq form
quantity_names = 'period force_range fall_time mean_force rise_ratio slip_force energy peak_force'
place(name) = int(sum [i = 1:words(quantity_names)] (word(quantity_names, i) eq name ? i : 0))
array used[8]
do for [i = 1:8] { used[i] = 0 }
# The points of one quantity stand side by side, in the order of the table.
next(name) = (used[place(name)] = used[place(name)] + 1, place(name) + 0.045 * (used[place(name)] - 1) - 0.3)
set ylabel '(E ± 2u_{val})/|D| in %'
set yrange [-limit:limit]
set xzeroaxis linetype 1 linewidth 1.2 linecolor rgb black
set multiplot layout 2, 1 margins 0.1, 0.985, 0.08, 0.95 spacing 0.02, 0.13
set key bottom right
set title 'Slider on paper'
set xrange [0.5:5.5]
set xtics ('period' 1, 'range of the force' 2, 'fall time' 3, 'mean force' 4, 'rise ratio' 5)
plot file using (chosen('paper-slider', 'rigid') ? next(strcol(3)) : NaN):(error(0)):(error(-2)):(error(2)) \
       with yerrorbars pointtype 7 pointsize 0.4 linecolor rgb vermillion title 'published mass', \
     '' using (chosen('paper-slider', 'lighter') ? next(strcol(3)) : NaN):(error(0)):(error(-2)):(error(2)) \
       with yerrorbars pointtype 5 pointsize 0.4 linecolor rgb blue title 'mass by one fall'
do for [i = 1:8] { used[i] = 0 }
set key bottom left
set title 'Friction damper'
set xrange [5.5:8.5]
set xtics ('slip force' 6, 'energy of a cycle' 7, 'peak of the force' 8)
plot file using (chosen('friction-damper', 'spring') ? next(strcol(3)) : NaN):(error(0)):(error(-2)):(error(2)) \
       with yerrorbars pointtype 7 pointsize 0.4 linecolor rgb vermillion title 'contact spring and friction', \
     '' using (chosen('friction-damper', 'spring-and-play') ? next(strcol(3)) : NaN):(error(0)):(error(-2)):(error(2)) \
       with yerrorbars pointtype 5 pointsize 0.4 linecolor rgb blue title 'with play'
unset multiplot
