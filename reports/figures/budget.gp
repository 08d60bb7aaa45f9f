# SPDX-License-Identifier: MIT
# What each cause (row) takes from the critical amplitude and adds to it, on a log axis; a panel for each frequency.
width = 16
height = 8.2
load 'style.gp'
file = folder.'budget.csv'
stats file using 3 name 'all' nooutput
panels = 4
causes = int(all_records) / panels
set xtics ('0.01' 0.01, '1' 1, '100' 100)
set ytics noenhanced
set tmargin at screen 0.88
set bmargin at screen 0.13
set label 1 'change of the critical amplitude / %' at screen 0.64, 0.025 center
set key at screen 0.27, 0.9 right bottom vertical samplen 1.2 spacing 1.1
set multiplot
do for [k = 0:panels - 1] {
  rows = sprintf(' every ::%d::%d ', k * causes, (k + 1) * causes - 1)
  set autoscale
  unset logscale
  eval 'stats file using 3'.rows."name 'panel' nooutput"
  set title sprintf('%g Hz', panel_min)
  set logscale x
  set xrange [1e-3:3e3]
  set yrange [causes - 0.4:-0.6]
  set lmargin at screen 0.31 + 0.172 * k
  set rmargin at screen 0.462 + 0.172 * k
  if (k == 1) { set ytics format ''; unset label 1; unset key }
  bars = 'file using %d:($0 + %g):(1e-3):%d:($0 + %g):($0 + %g)'.rows."with boxxyerror fillstyle solid noborder linecolor rgb %s title '%s'"
  labels = k == 0 ? ', file using (1e-9):0:ytic(1)'.rows.'with points notitle' : ''
  eval 'plot '.sprintf(bars, 4, -0.2, 4, -0.4, 0, 'vermillion', 'falls').', '.sprintf(bars, 5, 0.2, 5, 0, 0.4, 'blue', 'rises').labels
}
