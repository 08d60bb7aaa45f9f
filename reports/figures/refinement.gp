# SPDX-License-Identifier: MIT
# Sup-norm errors of the stick state against the time step, with what theory predicts. Both ordinates have four decades, so
# that slopes can be compared.
width = 16
height = 7.5
load 'style.gp'
file = folder.'refinement.csv'
set logscale xy
set format '10^{%T}'
set xlabel 'time step Δt / s'
set xrange [1e-6:3e-4]
set key left top
set multiplot layout 1, 2 margins 0.105, 0.985, 0.165, 0.92 spacing 0.125
set title 'Displacement y(L/2, t)'
set ylabel 'largest error / m'
set yrange [1e-10:1e-6]
plot file using 2:4 with lines linestyle 1 title 'predicted bound', \
     '' using 2:3 with points linestyle 2 pointtype 7 pointsize 0.6 title 'measured (ratio)', \
     '' using 2:3:(sprintf('%.2f', $3 / $4)) with labels left offset 0.8, -0.1 notitle
set title 'Static friction force f(t)'
set ylabel 'largest error / N'
set yrange [1e-3:1e1]
plot file using 2:6 with lines linestyle 1 title 'predicted bound', \
     '' using 2:5 with points linestyle 2 pointtype 7 pointsize 0.6 title 'measured (ratio)', \
     '' using 2:5:(sprintf('%.2f', $5 / $6)) with labels left offset 0.8, -0.1 notitle
