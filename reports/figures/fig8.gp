# SPDX-License-Identifier: MIT
# Fig. 8: the deflection as the sum of a quasi-static part and the rest. A drawing that is not to scale; no data.
width = 13.6
height = 5.6
load 'style.gp'
unset border
unset tics
unset grid
set xrange [-0.3:1.25]
set yrange [-0.1:0.56]
set margins 0, 0, 0, 0
h = 0.34
# Shape S(x) at P = 0 and something with the same supports on top.
quasi_static(x) = x < 0 || x > 1 ? NaN : h - 0.5 * h * x**2 * (3 - x)
whole(x) = quasi_static(x) - 1.1 * x**2 * (1 - x)
set style line 5 linecolor rgb black linewidth 0.9
set style arrow 1 head filled size screen 0.012, 18 linestyle 5 front
set arrow from -0.2, 0 to 1.15, 0 nohead linestyle 3
set arrow from 0, h to 1.02, h nohead linecolor rgb grey linewidth 0.8 dashtype 3
set object 1 rectangle from -0.1, h - 0.13 to 0, h + 0.13 fillstyle solid border rgb black fillcolor rgb '#BBBBBB'
set object 2 circle at 1, 0 size 0.012 front fillstyle solid fillcolor rgb black
set label "tip, held\nby the wall" at 1.03, 0.07 left
set label 'axis at rest' at -0.2, -0.04 left
set label 'rigid base' at -0.05, h + 0.165 center
set arrow from -0.15, 0 to -0.15, h arrowstyle 1
set label 'h(t)' at -0.165, 0.5 * h right
set arrow from 0.36, h to 0.36, quasi_static(0.36) + 0.005 arrowstyle 1
set label 'u_0 = S(x) h(t)' at 0.375, h - 0.03 left
set arrow from 0.52, quasi_static(0.52) to 0.52, whole(0.52) + 0.01 arrowstyle 1
set label 'Δu(x, t)' at 0.535, 0.35 * quasi_static(0.52) + 0.65 * whole(0.52) left
set arrow from 0.72, h to 0.72, whole(0.72) + 0.01 arrowstyle 1
set label 'u = u_0 + Δu' at 0.735, 0.85 * h left
set key at 1.2, 0.53 right samplen 4
set samples 200
plot sample [0:1] '+' using 1:(whole($1)) with lines linecolor rgb blue linewidth 3.5 title 'beam', \
     [0:1] '+' using 1:(quasi_static($1)) with lines linecolor rgb vermillion linewidth 2 dashtype 2 \
       title 'quasi-static deflection'
