# SPDX-License-Identifier: MIT
# Fig. 9: midspan displacement and static friction force in the stick state, both implementations (left) and their difference.
width = 16
height = 9
load 'style.gp'
values = folder.'fig9-values.csv'
load 'values.gp'
file = folder.'fig9.csv'
thinning = 70   # one circle in so many time steps
set xrange [0:1]
set xtics 0.2
set multiplot layout 2, 2 margins 0.105, 0.98, 0.125, 0.93 spacing 0.13, 0.05
set format x ''
set ylabel 'y(L/2, t) / mm' offset 0.5
set yrange [-0.8:0.8]
set ytics 0.4
unset key
set title 'line: closed form; circles: finite elements'
plot file using 1:(1e3 * $2) with lines linestyle 1, \
     '' every thinning using 1:(1e3 * $3) with points linestyle 2
set title 'difference; grey: predicted bound'
set ylabel 'difference / µm'
set autoscale y
set ytics autofreq
plot file using 1:(-1e6 * displacement_bound):(1e6 * displacement_bound) with filledcurves fillcolor rgb '#DDDDDD', \
     '' using 1:(1e6 * ($3 - $2)) with lines linecolor rgb vermillion linewidth 0.6
unset title
set ylabel 'f(t) / N'
set xlabel 'time t / s'
set format x '%g'
set yrange [-50:50]
set ytics 25
plot file using 1:4 with lines linestyle 1, '' every thinning using 1:5 with points linestyle 2
set ylabel 'difference / N'
set autoscale y
set ytics autofreq
plot file using 1:(-force_bound):(force_bound) with filledcurves fillcolor rgb '#DDDDDD', \
     '' using 1:($5 - $4) with lines linecolor rgb vermillion linewidth 0.6
