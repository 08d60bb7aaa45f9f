# SPDX-License-Identifier: MIT
# Fig. 6: critical amplitude by the paper's search (finite elements with contact) and by one linear run each.
width = 16
height = 8
load 'style.gp'
file = folder.'fig6.csv'
set xrange [0:105]
set yrange [1e-3:1e2]
set logscale y
set xtics 10
set xlabel 'excitation frequency / Hz'
set ylabel 'critical amplitude A_0 / mm' offset 1
set key right top
plot file using 1:($3 == 1 ? NaN : 1e3 * $2) with linespoints linestyle 1 pointtype 4 pointsize 0.9 title 'search', \
     '' using 1:($3 == 1 ? 1e3 * $2 : NaN):(0):(8e2 * $2) with vectors filled size 1.2, 20 linestyle 1 notitle, \
     '' using 1:($3 == 1 ? 1e3 * $2 : NaN) with points linecolor rgb blue linewidth 1.5 pointtype 8 pointsize 0.9 \
       title 'search ended without slip: the value lies over it', \
     '' using 1:(1e3 * $4) with points linecolor rgb vermillion pointtype 7 pointsize 0.4 title 'one linear run'
