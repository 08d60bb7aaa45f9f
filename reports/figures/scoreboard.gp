# SPDX-License-Identifier: MIT
# Error over tolerance of each code (rows) in each problem (columns): usual settings on the left, the best on the right. White: no
# driver. Grey: the code cannot do the problem, or did not end.
width = 16
height = 13
load 'style.gp'
file = folder.'scoreboard.csv'
set tics out nomirror
unset grid
unset key
set xtics rotate by 90 right
set yrange [:] reverse
set palette defined (-1 '#2166AC', 0 '#92C5DE', 0.001 '#FDDBC7', 3 '#D6604D', 6 '#67001F')
set cbrange [-1:6]
set cbtics ('≤ 0.1' -1, '1' 0, '10' 1, '10^2' 2, '10^3' 3, '10^4' 4, '10^5' 5, '≥ 10^6' 6)
set cblabel 'error / tolerance'
set multiplot
do for [panel = 0:1] {
  set title (panel ? 'best' : 'usual settings')
  set lmargin at screen (panel ? 0.555 : 0.2)
  set rmargin at screen (panel ? 0.875 : 0.52)
  set bmargin at screen 0.39
  set tmargin at screen 0.94
  if (panel) { unset ytics; set colorbox } else { unset colorbox }
  cannot = "file using ($5 == 1 ? $3 : NaN):4:(0.45):(0.45) with boxxyerror fillstyle solid linecolor rgb '#BBBBBB'"
  ratio = sprintf("'' using 3:4:(0.5):(0.5):%d:xtic(2)%s with boxxyerror fillstyle solid linecolor palette", 6 + panel, panel ? '' : ':ytic(1)')
  eval 'plot '.cannot.', '.ratio
}
unset multiplot
