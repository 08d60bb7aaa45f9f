# SPDX-License-Identifier: MIT
# Fig. 11: critical amplitude against frequency.
width = 16
height = 8.5
load 'style.gp'
values = folder.'fig11-values.csv'
load 'values.gp'
set xlabel 'excitation frequency / Hz'
set ylabel 'excitation amplitude A_0 / mm' offset 1
stats folder.'fig11.csv' using 1 name 'hz' nooutput
set xrange [hz_min:hz_max]
set yrange [0:1]
set xtics 20
unset grid
set margins screen 0.085, screen 0.98, screen 0.15, screen 0.92
set arrow from natural1, 0 to natural1, 1 nohead linestyle 3 front
set arrow from natural2, 0 to natural2, 1 nohead linestyle 3 front
set label sprintf('ω_1/2π = %.2f Hz', natural1) at natural1, 1.045 center
set label sprintf('ω_2/2π = %.2f Hz', natural2) at natural2, 1.045 center
set label 'stick-slip region' at 62, 0.72 center front
set label 'stick region' at 10, 0.5 center front
set label 'stick region' at 45, 0.25 center front
set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fillcolor rgb slip_fill fillstyle solid noborder
unset key
plot folder.'fig11.csv' using 1:(1e3 * $2) with filledcurves y=0 fillcolor rgb stick_fill, \
     '' using 1:(1e3 * $2) with lines linestyle 1
