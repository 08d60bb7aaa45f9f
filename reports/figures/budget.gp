# SPDX-License-Identifier: MIT
# What each cause (row) takes from the critical amplitude and adds to it, on a log axis; a panel for each frequency. The last row
# has the falls one on top of the other, with its value, and the rises; those beyond the axis stand at its end.
width = 16
height = 8.2
load 'style.gp'
file = folder.'budget.csv'
stats file using 3 name 'all' nooutput
panels = 4
causes = int(all_records) / panels
set xtics ('0.1' 0.1, '' 1, '10' 10, '' 100, '1000' 1000)
set xrange [0.05:4e3]
shown(x) = x > 2e3 ? 2e3 : x
set yrange [causes - 0.4:-0.6]
set label 1 'change of the critical amplitude / %' at screen 0.64, 0.025 center
set key at screen 0.29, 0.9 right bottom vertical samplen 1.2 spacing 1.1
set arrow from graph 0, first causes - 1.5 to graph 1, first causes - 1.5 nohead linecolor rgb black linewidth 0.6
set multiplot
do for [k = 0:panels - 1] {
  rows = sprintf(' every ::%d::%d ', k * causes, (k + 1) * causes - 1)
  unset logscale
  eval 'stats [*:*] [*:*] file using 3'.rows."name 'panel' nooutput"
  set title sprintf('%g Hz', panel_min)
  set logscale x
  set margins screen 0.31 + 0.172 * k, screen 0.462 + 0.172 * k, screen 0.13, screen 0.88
  if (k == 1) { set ytics format ''; unset label 1; unset key }
  dots = 'file using (shown($%d)):($0 + %g)'.rows."with points pointtype %d pointsize 0.7 linewidth 1.5 linecolor rgb %s title '%s'"
  sum = ", '' using 4:($0 + causes - 1):(sprintf('%.0f', $4))".sprintf(' every ::%d::%d ', (k + 1) * causes - 1, (k + 1) * causes - 1).'with labels right offset -1, 0 notitle'
  labels = k == 0 ? ', file using (1e-9):0:ytic(1)'.rows.'with points notitle' : ''
  eval 'plot '.sprintf(dots, 4, -0.13, 11, 'vermillion', 'falls by').', '.sprintf(dots, 5, 0.13, 8, 'blue', 'rises by').sum.labels
}
