# SPDX-License-Identifier: MIT
# Undamped tip histories as usually computed (columns), against the converged one, at each frequency (rows).
width = 16
height = 15.5
load 'style.gp'
values = folder.'practice-values.csv'
load 'values.gp'
file = folder.'practice.csv'
array hz[3] = [hz1, hz2, hz3]
array runs[3] = [1, 3, 6]
set xtics 0.2
set multiplot layout 3, 3 margins 0.09, 0.985, 0.12, 0.905 spacing 0.025, 0.065
do for [j = 1:3] {
  set autoscale xy  # what follows counts only rows in range
  stats file using ($1 == hz[j] && ($2 == 0 || $2 == runs[1] || $2 == runs[2] || $2 == runs[3]) ? 1e3 * $9 : NaN) name 'y' nooutput
  gap = 0.05 * (y_max - y_min)
  do for [k = 1:3] {
    set autoscale xy
    stats file using ($1 == hz[j] && $2 == runs[k] ? (method = strcol(3), size = $4, error = $7) : NaN) \
      nooutput
    set xrange [0:shown]
    set yrange [y_min - gap:y_max + gap]
    set title (j == 1 ? sprintf("%s\n%d elements\n", method, size) : '').sprintf('%g Hz, error %.1f %%', hz[j], 0.1 * ceil(10 * error))
    set format x (j == 3 ? '%g' : '')
    set xlabel (j == 3 ? 'time t / s' : '')
    set format y (k == 1 ? '%g' : '')
    unset key
    if (j == 3 && k == 3) {
      set key at screen 0.5, 0.005 center bottom vertical maxrows 1 samplen 4
      set label 'tip displacement y(L, t) / mm' at screen 0.015, 0.53 center rotate
    }
    plot file using ($1 == hz[j] && $2 == 0 ? $8 : NaN):(1e3 * $9) with lines linecolor rgb '#BBBBBB' linewidth 2.5 \
           title 'converged', \
         '' using ($1 == hz[j] && $2 == runs[k] ? $8 : NaN):(1e3 * $9) with lines linecolor rgb vermillion linewidth 0.9 \
           title 'as usually computed'
  }
}
