# SPDX-License-Identifier: MIT
# The margins of the rows of a table of cases, mu_s P over the largest |f|: below 1 the tip slips.
width = 16
height = 8
load 'style.gp'
file = folder.'plan.csv'
set logscale y
set format y '%g'
stats file using 2 name 'margin' nooutput
stats file using 1 name 'row' nooutput
set xrange [row_min - 0.5:row_max + 0.5]
if (row_max < 12) { set xtics 1 }
set yrange [0.8 * (margin_min < 1 ? margin_min : 1):1.25 * (margin_max > 1 ? margin_max : 1)]
set xlabel 'row'
set ylabel 'margin μ_sP / max |f|'
set key above horizontal center
plot 1 with lines linestyle 3 title 'limit', \
     file using 1:($2 >= 1 ? $2 : NaN) with points pointtype 7 pointsize 0.6 linecolor rgb blue title 'sticks', \
     '' using 1:($2 < 1 ? $2 : NaN) with points pointtype 8 pointsize 0.8 linecolor rgb vermillion title 'slips'
