# SPDX-License-Identifier: MIT
# Errors through the events of a damped history against the step, with and without location.
width = 16
height = 8
load 'style.gp'
values = folder.'event-order-values.csv'
load 'values.gp'
file = folder.'event-order.csv'
set logscale xy
set format xy '10^{%T}'
set xrange [1e-6:1.5e-4]
set xlabel 'time step Δt / s'
set key left top reverse Left samplen 1.5 font typeface.',7'
set multiplot layout 1, 2 margins 0.105, 0.985, 0.155, 0.93 spacing 0.13
set title 'Times of the events' offset 0, -0.6
set ylabel 'largest error / s' offset 1
set yrange [1e-9:1]
plot x with lines linestyle 3 title 'error = Δt', \
     file using ($1 == radius ? $2 : NaN):4 with linespoints linecolor rgb vermillion pointtype 5 pointsize 0.5 \
       title 'at the end of the step', \
     '' using ($1 == radius ? $2 : NaN):3 with linespoints linecolor rgb blue pointtype 7 pointsize 0.5 \
       title 'located inside the step', \
     '' using ($1 == 1 ? $2 : NaN):3 with points linecolor rgb black pointtype 6 pointsize 0.9 \
       title 'located, ρ_∞ = 1'
set title 'Displacement of the tip' offset 0, -0.6
set ylabel 'largest error / m' offset 1
set yrange [1e-10:1e-1]
plot file using ($1 == radius ? $2 : NaN):6 with linespoints linecolor rgb vermillion pointtype 5 pointsize 0.5 \
       title 'at the end of the step', \
     '' using ($1 == radius ? $2 : NaN):5 with linespoints linecolor rgb blue pointtype 7 pointsize 0.5 \
       title 'located inside the step', \
     '' using ($1 == 1 ? $2 : NaN):5 with points linecolor rgb black pointtype 6 pointsize 0.9 \
       title 'located, ρ_∞ = 1'
unset multiplot
