# SPDX-License-Identifier: MIT
# The shapes of the modes that `modes` lists, each divided by its value of largest modulus.
width = 16
height = 9
load 'style.gp'
file = folder.'modes.csv'
stats file nooutput
count = STATS_columns - 1
set xlabel 'x / m'
set ylabel 'deflection'
set xrange [*:*] noextend
set yrange [-1.1:1.1]
set key above horizontal center samplen 4
plot for [n = 1:count] file using 1:n + 1 with lines linewidth 1.5 linecolor rgb colours[1 + (n - 1) % 4] \
    dashtype 1 + (n - 1) % 5 title columnheader(n + 1)
