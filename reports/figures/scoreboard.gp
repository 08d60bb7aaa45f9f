# SPDX-License-Identifier: MIT
# Error over tolerance of each code (columns) in each problem (rows): usual settings on the left, the best on the right. Dot: agrees. Line:
# the code cannot do the problem, or did not end. White: no driver.
width = 16
height = 9
load 'style.gp'
file = folder.'scoreboard.csv'
set tics out nomirror
unset grid
unset key
stats file using 4 name 'code' nooutput
narrow = sprintf('%s,%.2g', font_name, 9 * width / (code_max + 1))  # as wide as a column
set xtics rotate by 90 right font narrow
set yrange [:] reverse
set palette defined (-1 '#EAF4FB', -0.001 '#C3DFF2', 0 '#FBBE7A', 2 '#E07A2F', 4 '#A63A14', 6 '#3D0A05')  # darker throughout
set cbrange [-1:6]
set cbtics ('≤ 0.1' -1, '1' 0, '10' 1, '10^2' 2, '10^3' 3, '10^4' 4, '10^5' 5, '≥ 10^6' 6)
set cblabel 'error / tolerance' offset -0.5
set multiplot
do for [panel = 0:1] {
  set title (panel ? 'best settings' : 'usual settings')
  set margins screen 0.312 + 0.296 * panel, screen 0.589 + 0.296 * panel, screen 0.215, screen 0.92
  if (panel) { set colorbox } else { unset colorbox }
  plot file using 4:3:(0.5):(0.5):6 + panel:xtic(word(strcol(1), words(strcol(1)))):ytic(strcol(2)[1:99 * (1 - panel)]) with boxxyerror fillstyle solid \
         linecolor palette, \
       '' using ($5 == 1 ? $4 - 0.25 : NaN):3:(0.5):(0) with vectors nohead linecolor rgb grey linewidth 1, \
       '' using (column(6 + panel) < 0 ? $4 : NaN):3 with points pointtype 7 pointsize 0.25 linecolor rgb black
}
