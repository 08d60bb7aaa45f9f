# SPDX-License-Identifier: MIT
# Read-outs of `nvh`: the history of one window and, beside it, peak to peak of the tip on the wall in each window with slips over the
# time between these (E-line diagram).
width = 22
height = 10
left = 0.085
right = 0.64
load 'history.gp'
if (width < 22 || height < 9.5) { printerr 'difficulty fitting plot titles into key' }  # as gnuplot says, not always
windows = folder.'history-windows.csv'
set lmargin at screen 0.735
set rmargin at screen 0.98
set tmargin at screen 0.92 - title_share
set bmargin at screen 0.17
set xlabel 'time between slips / s'
set ylabel 'peak to peak, tip on wall / mm'
highest = longest > 0 ? 1.2 * longest : 1
set xrange [0:highest]
power = 10.0**floor(log10(0.25 * highest))
step = (highest > 20 * power ? 10 : highest > 8 * power ? 5 : highest > 4 * power ? 2 : 1) * power
set xtics step  # four at most
set yrange [0:widest > 0 ? 1.2e3 * widest : 1]
set key at screen 0.8575, 0.985 - title_share center top horizontal maxrows 1
if (longest == 0) { set label 'no slips' at graph 0.5, 0.5 center }
plot windows using ($2 > 0 ? window / $2 : NaN):($3 * 1e3) with points pointtype 6 pointsize 0.8 linecolor rgb blue title 'windows', \
     '' using ($4 > 0 && $2 > 0 ? window / $2 : NaN):($3 * 1e3) with points pointtype 7 pointsize 0.8 linecolor rgb vermillion title 'at left'
unset multiplot
