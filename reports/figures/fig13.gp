# SPDX-License-Identifier: MIT
# Fig. 13: critical amplitude with EI and with EI/2. The upper axis, for EI/2, is scaled so that the first natural
# frequencies stand at one place.
width = 16
height = 8.4
load 'style.gp'
values = folder.'fig13-values.csv'
load 'values.gp'
ratio = half1 / natural1
file = folder.'fig13.csv'
set xlabel 'excitation frequency with EI / Hz'
set x2label sprintf('excitation frequency with EI/2 / Hz (scaled by ω''_1/ω_1 = %.4f)', ratio) offset 0, -0.3
set ylabel 'excitation amplitude A_0 / mm' offset 1
set xrange [1:120]
set x2range [ratio:120 * ratio]
set yrange [0:2]
set xtics 20
set x2tics 20
set ytics 0.5
set margins screen 0.085, screen 0.975, screen 0.14, screen 0.85
set arrow from natural1, graph 0 to natural1, graph 1 nohead linestyle 3 front
set arrow from natural2, graph 0 to natural2, graph 1 nohead linestyle 3 front
set label sprintf("ω_1, ω'_1\n%.2f, %.2f Hz", natural1, half1) at natural1 + 3, graph 0.93 front
set label sprintf("ω_2, ω'_2\n%.2f, %.2f Hz", natural2, half2) at natural2 - 1.5, graph 0.93 right front
set label 'both slip' at 60, graph 0.66 center front
set label "EI/2 sticks\nEI slips" at 38, graph 0.44 center front
set label 'both stick' at 40, graph 0.12 center front
set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fillcolor rgb slip_fill fillstyle solid noborder
unset grid
set key at graph 0.99, graph 0.97 right top samplen 3
plot file using 3:(1e3 * $4) axes x2y1 with filledcurves y=0 fillcolor rgb '#D9E8F3' notitle, \
     '' using 1:(1e3 * $2) with filledcurves y=0 fillcolor rgb stick_fill notitle, \
     '' using 3:(1e3 * $4) axes x2y1 with lines linecolor rgb vermillion linewidth 1.5 dashtype 2 \
       title 'EI/2 (upper axis)', \
     '' using 1:(1e3 * $2) with lines linestyle 1 title 'EI (lower axis)'
