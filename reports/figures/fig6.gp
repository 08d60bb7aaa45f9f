# SPDX-License-Identifier: MIT
# Fig. 6: critical amplitude by the paper's search (finite elements with contact) and by one linear run each.
width = 12
height = 7.5
load 'style.gp'
file = folder.'fig6.csv'
set xrange [0:105]
set yrange [0:1.08]
set xtics 20
set xlabel 'excitation frequency / Hz'
set ylabel 'critical amplitude A_0 / mm' offset 1
set key right top reverse Left
plot file using 1:($3 == 0 ? 1e3 * $2 : NaN) with linespoints linestyle 1 pointtype 4 pointsize 0.8 \
       title 'search', \
     '' using 1:($3 == 1 ? 1e3 * $2 : NaN) with points linecolor rgb blue pointtype 8 pointsize 0.9 \
       title 'search ended without slip', \
     '' using 1:(1e3 * $4 < 1.08 ? 1e3 * $4 : NaN) with points linecolor rgb vermillion pointtype 7 pointsize 0.4 \
       title 'one linear run'
