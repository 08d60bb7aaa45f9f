# SPDX-License-Identifier: MIT
# A history of `respond`: displacements of base, tip and midspan, and below them the friction force with its limit,
# +-mu_s P; where the tip slips the force is thick.
width = 16
height = 10
load 'style.gp'
values = folder.'history-values.csv'
load 'values.gp'
file = folder.'history.csv'
set multiplot title heading noenhanced
unset title
set lmargin at screen 0.11
set rmargin at screen 0.98
set xrange [*:*] noextend
set tmargin at screen 0.92 - title_share
set bmargin at screen 0.54
set format x ''
set ylabel 'displacement / mm'
set key at screen 0.5, 0.985 - title_share center top horizontal maxrows 1
plot file using 1:($2 * 1e3) with lines linecolor rgb grey linewidth 1 dashtype 2 title 'base', \
     '' using 1:($4 * 1e3) with lines linecolor rgb blue linewidth 1 title 'midspan', \
     '' using 1:($3 * 1e3) with lines linecolor rgb vermillion linewidth 1.6 title 'tip'

set tmargin at screen 0.50
set bmargin at screen 0.17
set xlabel 'time / s'
set format x '%g'
set offsets 0, 0, graph 0.06, graph 0.06
set ylabel 'friction force / N'
set key at screen 0.5, 0.01 center bottom horizontal maxrows 1
plot file using 1:6 with lines linecolor rgb blue linewidth 0.8 title 'stick', \
     '' using 1:(strcol(7) eq 'slip' ? $6 : NaN) with lines linecolor rgb vermillion linewidth 2 title 'slip', \
     limit with lines linestyle 3 title 'friction limit', -limit with lines linestyle 3 notitle
unset multiplot
