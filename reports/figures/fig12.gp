# SPDX-License-Identifier: MIT
# Fig. 12: verdicts of the finite-element runs over the closed form's critical amplitude.
width = 16
height = 9.5
load 'style.gp'
values = folder.'fig12-values.csv'
load 'values.gp'
points = folder.'fig12.csv'
set xlabel 'excitation frequency / Hz'
set ylabel 'excitation amplitude A_0 / mm' offset 1
set xrange [0:122.5]
set yrange [0:1.03]
set xtics 20
unset grid
set key above horizontal center samplen 1.2 maxcols 3 width -1
set margins screen 0.10, screen 0.98, screen 0.125, screen 0.875
plot folder.'fig12-curve.csv' using 1:(1e3 * $2) with lines linestyle 1 title 'closed form', \
     points using 1:(strcol(4) eq 'stick' ? 1e3 * $2 : NaN) with points pointtype 4 pointsize 0.4 \
       linecolor rgb green title 'FE stick', \
     '' using 1:(strcol(4) eq 'stick-slip' ? 1e3 * $2 : NaN) with points pointtype 6 pointsize 0.4 \
       linecolor rgb vermillion title 'FE stick-slip', \
     '' using 1:($5 == 1 ? 1e3 * $2 : NaN) with points pointtype 6 pointsize 1.1 \
       linecolor rgb black linewidth 1.5 title 'in guard band', \
     '' using 1:(strcol(3) ne strcol(4) ? 1e3 * $2 : NaN) with points pointtype 2 pointsize 0.9 \
       linecolor rgb black linewidth 1.5 title 'verdicts differ'
