# SPDX-License-Identifier: MIT
# Errors through the events of a damped history against the step, with and without location. Both ordinates have six
# decades, so that slopes can be compared.
width = 16
height = 8.5
load 'style.gp'
values = folder.'event-order-values.csv'
load 'values.gp'
file = folder.'event-order.csv'
set logscale xy
set format xy '10^{%T}'
set xrange [1e-6:1.5e-4]
set xlabel 'time step Δt / s'
set key at screen 0.5, 0.005 center bottom vertical maxrows 1
set multiplot layout 1, 2 margins 0.11, 0.985, 0.23, 0.93 spacing 0.13
set title 'Times of the events'
set ylabel 'largest error / s'
set yrange [1e-9:1e-3]
set label 'error = Δt' at 1.6e-5, 5e-5 right
plot x with lines linestyle 3 linewidth 1.2 notitle, \
     file using ($1 == radius ? $2 : NaN):4 with linespoints linecolor rgb vermillion linewidth 1.2 dashtype 2 \
       pointtype 5 pointsize 0.5 title 'at the end of the step', \
     '' using ($1 == radius ? $2 : NaN):3 with linespoints linecolor rgb blue pointtype 7 pointsize 0.5 \
       title 'located in the step', \
     '' using ($1 == 1 ? $2 : NaN):3 with points linecolor rgb black pointtype 6 pointsize 1.0 \
       title 'located, ρ_∞ = 1'
set title 'Displacement of the tip'
set ylabel 'largest error / m'
set yrange [1e-10:1e-4]
unset key
unset label
plot file using ($1 == radius ? $2 : NaN):6 with linespoints linecolor rgb vermillion linewidth 1.2 dashtype 2 \
       pointtype 5 pointsize 0.5, \
     '' using ($1 == radius ? $2 : NaN):5 with linespoints linecolor rgb blue pointtype 7 pointsize 0.5, \
     '' using ($1 == 1 ? $2 : NaN):5 with points linecolor rgb black pointtype 6 pointsize 1.0
