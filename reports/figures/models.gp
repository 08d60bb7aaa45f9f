# SPDX-License-Identifier: MIT
# Critical amplitude in other models over that of the criterion.
width = 16
height = 6.5
load 'style.gp'
values = folder.'models-values.csv'
load 'values.gp'
file = folder.'models.csv'
set xlabel 'excitation frequency / Hz' offset 0, 0.4
set ylabel 'critical amplitude ratio' offset 1
set xrange [2:120]
set yrange [0.5:2]
set logscale y
set ytics (0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.5, 2)
set key above horizontal center samplen 3
do for [hz in sprintf('%g %g', natural1, natural2)] {
  set object rectangle from 0.9 * hz, graph 0 to 1.1 * hz, graph 1 behind fillcolor rgb '#EEEEEE' fillstyle solid noborder
}
plot 1 with lines linestyle 3 notitle, \
     file using 1:($4 / $2) with lines linecolor rgb green linewidth 1.2 dashtype 2 title 'force of fixed direction', \
     '' using 1:($5 / $2) with lines linecolor rgb vermillion linewidth 1.2 dashtype 4 title 'contact that yields', \
     '' using 1:($3 / $2) with lines linestyle 1 title 'shear and rotary inertia'
