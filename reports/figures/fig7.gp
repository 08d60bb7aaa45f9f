# SPDX-License-Identifier: MIT
# Fig. 7: mode shapes of the stick (left) and the slip state (right). Panel i, by rows, has the frequency hz<i>.
width = 16
height = 11.5
load 'style.gp'
values = folder.'fig7-values.csv'
load 'values.gp'
file = folder.'fig7.csv'
array hz[6] = [hz1, hz2, hz3, hz4, hz5, hz6]
set xrange [0:1]
set yrange [-1.15:1.15]
set xtics 0.25
set ytics 0.5
set multiplot layout 3, 2 margins 0.10, 0.98, 0.10, 0.955 spacing 0.08, 0.085
do for [i = 1:6] {
  set title sprintf('%s state, mode %d: %.3f Hz', i % 2 ? 'Stick' : 'Slip', (i + 1) / 2, hz[i])
  set format x (i > 4 ? '%g' : '')
  set xlabel (i > 4 ? 'position x/L' : '')
  set ylabel (i % 2 == 1 ? 'shape U' : '') offset 0.5
  unset key
  if (i == 2) { set key right bottom }
  plot 0 with lines linecolor rgb grey linewidth 0.5 notitle, \
       file using 1:2 * i with lines linestyle 1 title 'closed form', \
       '' every int(points_per_element) using 1:2 * i + 1 with points linestyle 2 title 'finite elements'
}
unset multiplot
