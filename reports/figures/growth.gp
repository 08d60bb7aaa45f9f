# SPDX-License-Identifier: MIT
# Bound and observation of the growth of a disturbance, and error of undamped histories, against the mesh.
width = 16
height = 10
load 'style.gp'
values = folder.'growth-values.csv'
load 'values.gp'
file = folder.'growth.csv'
array titles[4] = ['resolved in time', 'fixed step', 'filtering step', 'radiating tip']
array colours[4] = [vermillion, purple, blue, green]
array filled[4] = [5, 9, 7, 13]
array open[4] = [4, 8, 6, 12]
set logscale xy
set xrange [4:200]
set xtics (5, 10, 20, 40, 80, 160)
set xlabel 'elements'
set multiplot layout 1, 2 margins 0.1, 0.985, 0.345, 0.94 spacing 0.11
set title 'Growth of a disturbance' offset 0, -0.6
set ylabel 'growth / s^{−1}' offset 1
set yrange [1:2e4]
set key at screen 0.5, 0.02 center bottom maxrows 5 vertical reverse Left samplen 2.5 font typeface.',7'
plot for [k = 1:4] file using ($1 == k ? $2 : NaN):5 with linespoints linecolor rgb colours[k] linewidth 1.2 \
       pointtype filled[k] pointsize 0.6 title 'bound σ*, '.titles[k], \
     beam with lines linestyle 3 linecolor rgb black linewidth 1.2 title 'bound σ*, beam', \
     for [k = 1:4] file using ($1 == k ? $2 : NaN):6 with linespoints linecolor rgb colours[k] linewidth 0.8 \
       dashtype 2 pointtype open[k] pointsize 0.7 title 'observed, '.titles[k]
set title 'Error of the tip' offset 0, -0.6
set ylabel 'largest error / % of the range' offset 1
set yrange [0.1:100]
unset key
plot for [k = 1:4] file using ($1 == k ? $2 : NaN):7 with linespoints linecolor rgb colours[k] linewidth 1.2 \
       pointtype filled[k] pointsize 0.6
unset multiplot
