# SPDX-License-Identifier: MIT
# Cases (rows) in dimensionless groups (panels): points, and shaded from the least to the greatest of each group.
width = 16
height = 7.4
load 'style.gp'
file = folder.'domain.csv'
array names[6] = ['P/P_{cr}', 'L√(A/I)', 'Ω/ω_1', 'μ_s', 'αA_0Ω', 'ζ_1 / %']
array ranges[6] = ['-0.5:1.3', '5:4000', '0.07:15', '0.2:0.7', '-0.01:0.19', '-0.1:1.2']
array marks[6] = ['0, 0.5, 1', "'10' 10, '10^2' 100, '10^3' 1000", "'0.1' 0.1, '1' 1, '10' 10", '0.3, 0.5', '0, 0.1', '0, 0.5, 1']
set tmargin at screen 0.97
set bmargin at screen 0.15
unset key
set multiplot
do for [k = 1:6] {
  group = sprintf('(column(%d) * %g)', k + 1, k == 6 ? 100 : 1)
  set autoscale
  unset logscale
  eval 'stats file using '.group." name 'group' nooutput"
  set object 1 rectangle from group_min, graph 0 to group_max, graph 1 behind fillcolor rgb stick_fill fillstyle solid noborder
  if (k == 2 || k == 3) { set logscale x }
  eval 'set xrange ['.ranges[k].']'
  set yrange [group_records - 0.5:-0.5]
  eval 'set xtics ('.marks[k].')'
  if (k == 2) { set ytics format '' }
  set xlabel names[k] offset 0, 0.4
  set lmargin at screen 0.205 + 0.132 * (k - 1)
  set rmargin at screen 0.315 + 0.132 * (k - 1)
  eval 'plot file using '.group.':0'.(k == 1 ? ':ytic(1)' : '').' with points pointtype 7 pointsize 0.6 linecolor rgb blue'
}
