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
array largest[10]  # of route (i + 1) / 2, at 25 and 70 Hz by turns
do for [i = 1:10] {
  stats events using ($1 == hz[2 - i % 2] && is_route((i + 1) / 2) ? $9 : NaN) name 'difference' nooutput
  largest[i] = difference_max
}
unset key
set multiplot
set xrange [0:shown]
set xtics 0.2
set yrange [-4:6]
set ytics 2
set xlabel 'time t / s' offset 0, 0.4
do for [j = 1:2] {
  set margins screen 0.46 * j - 0.37, screen 0.46 * j + 0.06, screen 0.6, screen 0.935
  set format y (j == 1 ? '%g' : '')
  set title sprintf('%d Hz', hz[j])
  set ylabel (j == 1 ? 'y(L, t) / mm' : '')
  plot histories using 1:(1e3 * column(j + 1)) with lines linestyle 1 linewidth 1.2
}
unset title
unset ylabel
set margins screen 0.375, screen 0.98, screen 0.135, screen 0.4
set logscale x
set xrange [1e-9:2e-5]
set xtics 10
set format x '10^{%T}'
set yrange [5.5:0.5]
set format y '%g'
set ytics scale 0 ('' 1)
do for [k = 1:5] { set ytics add (methods[k].(k < 5 ? sprintf(', %d', sizes[k]) : '') k) }
set xlabel 'largest difference of an event time to the reference / s'
set key at screen 0.67, 0.44 center center vertical maxrows 1 samplen 1
set samples 2
plot for [i = 1:10] '+' using (largest[i]):((i + 1) / 2) with points pointtype (i % 2 ? 7 : 4) pointsize 0.8 linewidth 1.5 \
       linecolor rgb colours[2 - i % 2] title (i > 2 ? '' : sprintf('%d Hz', hz[i]))
