# SPDX-License-Identifier: MIT
# Fig. 11: critical amplitude against frequency.
width = 16
height = 8.5
load 'style.gp'
values = folder.'fig11-values.csv'
load 'values.gp'
set xlabel 'excitation frequency / Hz'
set ylabel 'excitation amplitude A_0 / mm' offset 1
set xrange [0:120]
set yrange [0:1]
set xtics 20
set margins screen 0.10, screen 0.98, screen 0.15, screen 0.92
set arrow from natural1, 0 to natural1, 1 nohead linestyle 3 back
set arrow from natural2, 0 to natural2, 1 nohead linestyle 3 back
set label sprintf('ω_1/2π = %.2f Hz', natural1) at natural1, 1.045 center
set label sprintf('ω_2/2π = %.2f Hz', natural2) at natural2, 1.045 center
set label 'stick-slip region' at 62, 0.72 center
set label 'stick region' at 47, 0.2 center
unset key
plot folder.'fig11.csv' using 1:(1e3 * $2) with lines linestyle 1
