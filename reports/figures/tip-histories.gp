# SPDX-License-Identifier: MIT
# Four tip histories. Panel i has hz<i> and slips<i>; the band is the half-width. All panels have one scale: a panel is as high
# as what its tip covers.
width = 16
height = 12
load 'style.gp'
load 'values.gp'
array hz[4] = [hz1, hz2, hz3, hz4]
array slips[4] = [slips1, slips2, slips3, slips4]
array lowest[4]
array highest[4]
all = 0
do for [i = 1:4] {
  stats file using (1e3 * column(2 * i)) name 'y' nooutput
  all = all + y_max - y_min
  lowest[i] = y_min
  highest[i] = y_max
}
gap = 0.033 * all  # over and below each history
per_mm = 0.695 / (all + 8 * gap)
set xrange [0:shown]
set xtics 0.1
mm_per_tic = all > 10 ? 1 : 0.5
set ytics mm_per_tic
unset key
set lmargin at screen 0.095
set rmargin at screen 0.98
set format x ''
top = 0.955
set multiplot
do for [i = 1:4] {
  set yrange [lowest[i] - gap:highest[i] + gap]
  set tmargin at screen top
  bottom = top - per_mm * (highest[i] - lowest[i] + 2 * gap)
  set bmargin at screen bottom
  top = bottom - 0.055
  set title sprintf('(%s) %g Hz%s', 'abcd'[i:i], hz[i], slips[i] ? '' : ': the tip sticks throughout')
  if (i == 4) {
    set format x '%g'
    set xlabel 'time t / s'
    set label 'tip displacement y(L, t) / mm' at screen 0.017, 0.53 center rotate
  }
  y(sign) = 1e3 * (column(2 * i) + sign * column(2 * i + 1))
  plot file using 1:(y(-1)):(y(1)) with filledcurves linecolor rgb grey, \
       '' using 1:(y(0)) with lines linestyle 1 linewidth 1.0
}
unset multiplot
