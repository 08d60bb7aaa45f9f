# SPDX-License-Identifier: MIT
# The damped benchmark: tip histories (top) and the largest difference of an event time to the reference by route (bottom).
width = 16
height = 8.6
load 'style.gp'
values = folder.'benchmark-values.csv'
load 'values.gp'
histories = folder.'benchmark-histories.csv'
events = folder.'benchmark.csv'
array hz[2] = [hz1, hz2]
# Routes drawn, generalised-alpha with the shortest step; run 0 is the uncertainty of the reference.
stats events using ($5 > 0 ? $5 : NaN) name 'step' nooutput
array methods[5] = ['generalised-alpha', 'event-driven on finite elements', 'event-driven on held modes', 'generalised-alpha', 'uncertainty of the reference']
array sizes[5] = [20, 20, 20, 40, 40]
is_route(k) = strcol(3) eq methods[k] && $4 == sizes[k] && ($5 == 0 || $5 == step_min)
array largest[10]  # by route and frequency
do for [k = 1:5] {
  do for [j = 1:2] {
    stats events using ($1 == hz[j] && is_route(k) ? $9 : NaN) name 'difference' nooutput
    largest[2 * k - 2 + j] = difference_max
  }
}
unset key
set multiplot
set xrange [0:shown]
set xtics 0.2
set yrange [-4:6]
set ytics 2
set tmargin at screen 0.935
set bmargin at screen 0.6
set xlabel 'time t / s' offset 0, 0.4
do for [j = 1:2] {
  set lmargin at screen 0.09 + 0.46 * (j - 1)
  set rmargin at screen 0.52 + 0.46 * (j - 1)
  set format y (j == 1 ? '%g' : '')
  set title sprintf('%d Hz', hz[j])
  set ylabel (j == 1 ? 'y(L, t) / mm' : '')
  plot histories using 1:(1e3 * column(j + 1)) with lines linestyle 1 linewidth 1.2
}
unset title
unset ylabel
set lmargin at screen 0.375
set rmargin at screen 0.98
set tmargin at screen 0.4
set bmargin at screen 0.135
set logscale x
set xrange [1e-9:2e-5]
set xtics 10
set format x '10^{%T}'
set yrange [5.5:0.5]
set format y '%g'
set ytics scale 0
set ytics ('' 1)
do for [k = 1:5] { set ytics add (methods[k].(k < 5 ? sprintf(', %d', sizes[k]) : '') k) }
set xlabel 'largest difference of an event time to the reference / s'
set key at screen 0.67, 0.44 center center vertical maxrows 1 samplen 1
do for [i = 1:10] {
  j = 2 - i % 2
  set label i '' at largest[i], (i + 1) / 2 point pointtype (j == 1 ? 7 : 4) pointsize 0.8 linewidth 1.5 linecolor rgb colours[j] front
}
plot NaN with points pointtype 7 pointsize 0.8 linecolor rgb colours[1] title sprintf('%d Hz', hz[1]), \
     NaN with points pointtype 4 pointsize 0.8 linewidth 1.5 linecolor rgb colours[2] title sprintf('%d Hz', hz[2])
unset multiplot
