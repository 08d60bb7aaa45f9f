# SPDX-License-Identifier: MIT
# The damped benchmark: tip histories (top) and differences of event times to the reference (bottom).
width = 16
height = 12
load 'style.gp'
values = folder.'benchmark-values.csv'
load 'values.gp'
histories = folder.'benchmark-histories.csv'
events = folder.'benchmark.csv'
array hz[2] = [hz1, hz2]
# Runs drawn, their colours and shapes; run 0 is the uncertainty of the reference.
array runs[5] = [2, 4, 8, 9, 6]
array colours[5] = [green, purple, vermillion, blue, black]
array shapes[5] = [9, 13, 5, 7, 2]
array titles[5]
do for [k = 1:5] {
  stats events using ($2 == runs[k] ? (method = strcol(3), size = $4) : NaN) nooutput
  titles[k] = sprintf('%s: %d', method, size)
}
set xrange [0:shown]
set xtics 0.1
set multiplot
do for [j = 1:2] {
  left = 0.10 + 0.475 * (j - 1)
  set lmargin at screen left
  set rmargin at screen left + 0.395
  set tmargin at screen 0.94
  set bmargin at screen 0.67
  unset logscale y
  unset key
  set format x ''
  set format y '%g'
  unset xlabel
  set autoscale y
  set title sprintf('%d Hz', hz[j]) offset 0, -0.6
  if (j == 1) { set ylabel 'y(L, t) / mm' offset 1 } else { unset ylabel }
  plot histories using 1:(1e3 * column(j + 1)) with lines linestyle 1
  unset title
  set tmargin at screen 0.62
  set bmargin at screen 0.25
  set logscale y
  set yrange [1e-11:1e-3]
  set format x '%g'
  set format y '10^{%T}'
  set xlabel 'time t / s'
  if (j == 1) { set ylabel 'difference of event time / s' offset 1 }
  if (j == 1) { set key at screen 0.5, 0.01 center bottom maxrows 3 reverse Left samplen 1.5 font typeface.',7' }
  plot for [k = 1:5] events using ($1 == hz[j] && $2 == runs[k] && $9 > 0 ? $6 : NaN):9 with points \
         pointtype shapes[k] pointsize 0.4 linecolor rgb colours[k] title titles[k], \
       events using ($1 == hz[j] && $2 == 0 ? $6 : NaN):9 with lines linecolor rgb black linewidth 1.0 \
         title 'uncertainty of the reference'
}
unset multiplot
