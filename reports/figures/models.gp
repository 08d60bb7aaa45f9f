# SPDX-License-Identifier: MIT
# Critical amplitude in other models over that of the criterion: the paper's beam (left) and a stout one (right).
width = 16
height = 6.5
load 'style.gp'
values = folder.'models-values.csv'
load 'values.gp'
array files[2] = [folder.'models.csv', folder.'models-stout.csv']
array first[2] = [natural1, stout1]
array second[2] = [natural2, stout2]
set xlabel 'excitation frequency over ω_1' offset 0, 0.4
set xtics 1
set yrange [0.2:5]
set logscale y
set ytics (0.2, 0.5, 0.8, 1, 1.25, 2, 5)
set arrow from highest, graph 0 to highest, graph 1 nohead linestyle 3 front
set label '← margin holds' at highest + 0.1, graph 0.92 front
set key at screen 0.5, 1 center top vertical maxrows 1 samplen 3
set multiplot
do for [k = 1:2] {
  set xrange [0:(k == 1 ? 6.3 : 4)]
  set margins screen (k == 1 ? 0.095 : 0.645), screen (k == 1 ? 0.615 : 0.9815), screen 0.17, screen 0.84
  do for [n = 1:3] {
    natural = n == 1 ? 1 : n == 2 ? second[k] / first[k] : natural3 / natural1
    set object n rectangle from (1 - distance) * natural, graph 0 to (1 + distance) * natural, graph 1 behind fillcolor rgb '#E4E4E4' fillstyle solid noborder
  }
  set title (k == 1 ? "the paper's beam" : 'a stout beam (soft-short)')
  set ylabel (k == 1 ? 'critical amplitude ratio' : '') offset 1
  plot 1 with lines linestyle 3 notitle, \
       files[k] using ($1 / first[k]):($4 / $2) with lines linecolor rgb vermillion linewidth 1.2 dashtype 2 title 'contact that yields', \
       '' using ($1 / first[k]):($3 / $2) with lines linestyle 1 title 'shear and rotary inertia'
  unset key; unset arrow; unset label; set format y ''
}
