# SPDX-License-Identifier: MIT
# Fig. 9: midspan displacement and static friction force in the stick state, both implementations.
width = 16
height = 9
load 'style.gp'
file = folder.'fig9.csv'
thinning = 40   # one circle in so many time steps
set xrange [0:0.4]
set multiplot layout 2, 1 margins 0.105, 0.98, 0.125, 0.93 spacing 0.05
set ylabel 'y(L/2, t) / mm' offset 0.5
set format x ''
set yrange [-0.8:0.8]
set ytics 0.4
set key above horizontal right
plot file using 1:(1e3 * $2) with lines linestyle 1 title 'closed form', \
     '' every thinning using 1:(1e3 * $3) with points linestyle 2 title 'finite elements'
set ylabel 'f(t) / N' offset 0.5
set xlabel 'time t / s'
set format x '%g'
set yrange [-50:50]
set ytics 25
unset key
plot file using 1:4 with lines linestyle 1, '' every thinning using 1:5 with points linestyle 2
unset multiplot
