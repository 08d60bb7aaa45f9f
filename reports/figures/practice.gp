# SPDX-License-Identifier: MIT
# Undamped tip histories as usually computed (columns), against the converged one, at each frequency (rows).
width = 16
height = 15
load 'style.gp'
values = folder.'practice-values.csv'
load 'values.gp'
file = folder.'practice.csv'
array hz[3] = [hz1, hz2, hz3]
array runs[3] = [1, 3, 6]
set xrange [0:shown]
set xtics 0.1
set multiplot layout 3, 3 margins 0.075, 0.985, 0.075, 0.905 spacing 0.05, 0.08
do for [j = 1:3] {
  do for [k = 1:3] {
    stats file using ($1 == hz[j] && $2 == runs[k] ? (method = strcol(3), size = $4, error = $7) : NaN) \
      nooutput
    set title (j == 1 ? sprintf("%s, %d elements\n", method, size) : '').sprintf('%g Hz, error %.1f %%', hz[j], error) \
      font typeface.',7' offset 0, -0.7
    set xlabel (j == 3 ? 'time t / s' : '')
    set ylabel (k == 1 ? 'y(L, t) / mm' : '') offset 1.5
    if (j == 1 && k == 1) {
      set key at screen 0.99, screen 0.995 right top horizontal samplen 2 maxrows 1
    } else {
      unset key
    }
    plot file using ($1 == hz[j] && $2 == 0 ? $8 : NaN):(1e3 * $9) with lines linecolor rgb black linewidth 1.4 \
           title 'converged', \
         '' using ($1 == hz[j] && $2 == runs[k] ? $8 : NaN):(1e3 * $9) with lines linecolor rgb vermillion linewidth 0.9 \
           title 'as usually computed'
  }
}
unset multiplot
