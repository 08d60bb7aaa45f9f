# SPDX-License-Identifier: MIT
# Growth of a disturbance, bound (left) and observation (middle), and error of undamped histories (right), against the mesh.
width = 16
height = 8.5
load 'style.gp'
values = folder.'growth-values.csv'
load 'values.gp'
file = folder.'growth.csv'
array dashes[4] = [1, 2, 1, 2]
array titles[3] = ["Resolved in time,\nthe bound σ* grows", "The observed growth\nstays below it", "Where both stay low,\nthe error may fall"]
array left[3] = [0.1, 0.365, 0.735]
set logscale xy
set xrange [4:200]
set xtics (5, 10, 20, 40, 80, '160' 160)
set xlabel 'elements'
set multiplot
do for [k = 1:3] {
  set margins screen left[k], screen left[k] + 0.25, screen 0.28, screen 0.89
  set title titles[k]
  set yrange [(k < 3 ? 1 : 0.1):(k < 3 ? 1e4 : 1e2)]
  set format y (k == 2 ? '' : '%g')
  set ylabel (k == 1 ? 'growth / s^{−1}' : k == 3 ? 'largest error / % of the range' : '') offset 1
  if (k == 1) { set key at screen 0.5, 0.005 center bottom maxrows 2 vertical samplen 3 } else { unset key }
  plot for [i = 1:4] file using ($1 == i ? $2 : NaN):4 + k with linespoints linecolor rgb colours[i] linewidth 1.2 \
         dashtype dashes[i] pointtype shapes[i] pointsize 0.8 title value('rule'.i), \
       (k < 3 ? beam : NaN) with lines linecolor rgb black linewidth 1.2 dashtype 3 title 'bound σ* of the beam'
}
