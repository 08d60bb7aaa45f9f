# SPDX-License-Identifier: MIT
# Fig. 12: the runs of finite elements, at each frequency the largest amplitude that sticks and the least that slips, and the closed form.
width = 16
height = 8
load 'style.gp'
values = folder.'fig12-values.csv'
load 'values.gp'
points = folder.'fig12.csv'
set xlabel 'excitation frequency / Hz'
set ylabel 'excitation amplitude A_0 / mm' offset 1
set xrange [1:120]
set yrange [0:1.03]
set xtics 20
unset grid
set key above vertical center maxrows 2 width -2
set label 'sticks' at 10, 0.55 center front
set label 'slips' at 75, 0.75 center front
set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fillcolor rgb slip_fill fillstyle solid noborder
hz = amplitude = 0
verdict = ''
# A row next to which the verdict changes: the amplitude before it, in mm.
before(f, a, v) = (last = f == hz && v ne verdict ? 1e3 * amplitude : NaN, hz = f, amplitude = a, verdict = v, last)
set margins screen 0.085, screen 0.965, screen 0.145, screen 0.86
plot folder.'fig12-curve.csv' using 1:(1e3 * $2) with filledcurves y=0 fillcolor rgb stick_fill notitle, \
     '' using 1:(1e3 * $2) with lines linestyle 1 title 'critical, closed form', \
     points using 1:(before($1, $2, strcol(4))) with points pointtype 5 pointsize 0.6 linecolor rgb blue title 'last that sticks', \
     '' using 1:(column(0) == 0 ? (hz = 0) : 0, before($1, $2, strcol(4)) == last ? 1e3 * $2 : NaN) with points pointtype 6 pointsize 0.6 \
       linecolor rgb vermillion linewidth 1.5 title 'first that slips', \
     '' using 1:($5 == 1 ? 1e3 * $2 : NaN) with points pointtype 6 pointsize 1.3 \
       linecolor rgb black linewidth 1.5 title 'within the predicted error', \
     '' using 1:(strcol(3) ne strcol(4) ? 1e3 * $2 : NaN) with points pointtype 2 pointsize 1.0 \
       linecolor rgb black linewidth 1.5 title 'verdicts differ'
