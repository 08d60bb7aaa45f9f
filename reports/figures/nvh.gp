# SPDX-License-Identifier: MIT
# Read-outs of `nvh`: the history of one window and, beside it, peak to peak of the tip on the wall in each window with slips over the
# time between these (E-line diagram).
width = 22
height = 10
columns = 2
load 'history.gp'
windows = folder.'history-windows.csv'
eval upper
eval lower
top_rows = 2
set tmargin at screen 1 - title_share - up(0.8 + 1.2 * top_rows)
set lmargin at screen right + across(6)
set rmargin at screen 1 - across(1.5)
set xlabel fitted('time between slips / s', (1 - right) * width - 4.5 * em)
set ylabel fitted('peak to peak, tip on wall / mm', 2 * panel)
highest = longest > 0 ? 1.2 * longest : 1
set xrange [0:highest]
set xtics x_step(highest, (1 - right) * width - 7.5 * em)
set yrange [0:widest > 0 ? 1.2e3 * widest : 1]
set ytics y_step(1.2e3 * widest, 2 * panel)
key_place = 0.5 * (right + 1) + 0.5 * across(4.5)
eval upper_key
if (longest == 0) { set label 'no slips' at graph 0.5, 0.5 center }
plot windows using ($2 > 0 ? window / $2 : NaN):($3 * 1e3) with points pointtype 6 pointsize 0.8 linecolor rgb blue title 'windows', \
     '' using ($4 > 0 && $2 > 0 ? window / $2 : NaN):($3 * 1e3) with points pointtype 7 pointsize 0.8 linecolor rgb vermillion title 'at left'
unset multiplot
