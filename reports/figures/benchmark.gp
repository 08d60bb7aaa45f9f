# SPDX-License-Identifier: MIT
# The damped benchmark: tip histories (top) and differences of event times to the reference (bottom).
width = 16
height = 13
load 'style.gp'
values = folder.'benchmark-values.csv'
load 'values.gp'
histories = folder.'benchmark-histories.csv'
events = folder.'benchmark.csv'
array hz[2] = [hz1, hz2]
# Routes drawn, generalised-alpha with the shortest step; run 0 is the uncertainty of the reference.
stats events using ($5 > 0 ? $5 : NaN) name 'step' nooutput
array methods[4] = ['generalised-alpha', 'event-driven on finite elements', 'generalised-alpha', 'event-driven on held modes']
array sizes[4] = [20, 20, 40, 20]
array points[4] = [4, 2, 6, 9]
is_route(k) = strcol(3) eq methods[k] && $4 == sizes[k] && ($5 == 0 || $5 == step_min)
set xrange [0:shown]
set xtics 0.1
set multiplot
do for [j = 1:2] {
  left = 0.115 + 0.455 * (j - 1)
  set lmargin at screen left
  set rmargin at screen left + 0.415
  set tmargin at screen 0.955
  set bmargin at screen 0.68
  unset logscale y
  unset key
  unset xlabel
  set format x ''
  set format y (j == 1 ? '%g' : '')
  set yrange [-4:6]
  set ytics 2
  set title sprintf('%d Hz', hz[j])
  set ylabel (j == 1 ? 'y(L, t) / mm' : '')
  plot histories using 1:(1e3 * column(j + 1)) with lines linestyle 1 linewidth 1.2
  set title ''
  set tmargin at screen 0.655
  set bmargin at screen 0.225
  set logscale y
  set yrange [1e-11:1e-4]
  set ytics 10
  set format x '%g'
  set format y (j == 1 ? '10^{%T}' : '')
  set xlabel 'time t / s'
  set ylabel (j == 1 ? 'difference of event time / s' : '')
  if (j == 1) { set key at screen 0.5, 0.005 center bottom maxrows 3 vertical samplen 1.5 }
  plot for [k = 1:4] events using ($1 == hz[j] && is_route(k) && $9 > 0 ? $6 : NaN):9 with points \
         pointtype points[k] pointsize (k == 1 ? 0.6 : 0.4) linewidth 0.8 linecolor rgb colours[k] \
         title sprintf('%s: %d', methods[k], sizes[k]), \
       events using ($1 == hz[j] && $2 == 0 ? $6 : NaN):9 with lines linecolor rgb black linewidth 1.0 \
         title 'uncertainty of the reference'
}
unset multiplot
