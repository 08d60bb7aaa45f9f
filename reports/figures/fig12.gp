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
set key above vertical center maxrows 2 width -2
set margins screen 0.085, screen 0.98, screen 0.125, screen 0.875
plot folder.'fig12-curve.csv' using 1:(1e3 * $2) with lines linestyle 1 title 'critical, closed form', \
     points using 1:(strcol(4) eq 'stick' ? 1e3 * $2 : NaN) with points pointtype 5 pointsize 0.4 \
       linecolor rgb blue title 'sticks, finite elements', \
     '' using 1:(strcol(4) eq 'stick-slip' ? 1e3 * $2 : NaN) with points pointtype 6 pointsize 0.45 \
       linecolor rgb vermillion title 'slips, finite elements', \
     '' using 1:($5 == 1 ? 1e3 * $2 : NaN) with points pointtype 6 pointsize 1.3 \
       linecolor rgb black linewidth 1.5 title 'within the predicted error', \
     '' using 1:(strcol(3) ne strcol(4) ? 1e3 * $2 : NaN) with points pointtype 2 pointsize 1.0 \
       linecolor rgb black linewidth 1.5 title 'verdicts differ'
