# SPDX-License-Identifier: MIT
# Fig. 7: mode shapes of finite elements minus those of the closed form, at the nodes. Column 2 i has shape i, by rows of state.
width = 16
height = 5.9
load 'style.gp'
values = folder.'fig7-values.csv'
load 'values.gp'
file = folder.'fig7.csv'
array hz[6] = [hz1, hz2, hz3, hz4, hz5, hz6]
set xrange [0:1]
set xlabel 'position x/L' offset 0, 0.4
set key left bottom
set ytics 1
set multiplot layout 1, 2 margins 0.07, 0.985, 0.18, 0.84 spacing 0.1, 0.1
do for [state = 1:2] {
  unit = sprintf('10^{−%d}', state == 1 ? 4 : 7)
  set title sprintf("%s state, in %s\n%.2f, %.2f, %.2f Hz", word('Stick Slip', state), unit, hz[state], hz[2 + state], hz[4 + state])
  set ylabel 'difference / '.unit offset 0.5
  plot for [mode = 1:3] column = 2 * (2 * mode - 2 + state) file every int(points_per_element) \
      using 1:((state == 1 ? 1e4 : 1e7) * (column(column + 1) - column(column))) with linespoints linecolor rgb colours[mode] \
      pointtype shapes[mode] pointsize 0.5 title (state == 2 ? sprintf('mode %d', mode) : '')
}
