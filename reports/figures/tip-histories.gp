# SPDX-License-Identifier: MIT
# Four tip histories. Panel i has hz<i> and slips<i>; the band is the half-width.
width = 16
height = 10
load 'style.gp'
load 'values.gp'
array hz[4] = [hz1, hz2, hz3, hz4]
array slips[4] = [slips1, slips2, slips3, slips4]
set xrange [0:shown]
set xtics 0.1
unset key
set multiplot layout 2, 2 margins 0.10, 0.98, 0.125, 0.945 spacing 0.085, 0.15
do for [i = 1:4] {
  set title sprintf('(%s) %g Hz', 'abcd'[i:i], hz[i]) offset 0, -0.6
  set xlabel (i > 2 ? 'time t / s' : '')
  set ylabel (i % 2 == 1 ? 'y(L, t) / mm' : '') offset 1
  set ytics autofreq
  unset label
  if (slips[i]) {
    set autoscale y
  } else {
    set yrange [-1:1]
    set label 'sticks throughout' at graph 0.5, 0.6 center
  }
  y(sign) = 1e3 * (column(2 * i) + sign * column(2 * i + 1))
  plot file using 1:(y(-1)):(y(1)) with filledcurves linecolor rgb vermillion, \
       '' using 1:(y(0)) with lines linestyle 1 linewidth 1.0
}
unset multiplot
