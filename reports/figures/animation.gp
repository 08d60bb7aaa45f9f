# SPDX-License-Identifier: MIT
# The frames of an animation, one file each or, as gif, one film: the shape of the beam (left), and the friction force between
# its limits (right). All frames have the axes that length, largest_displacement, force_limit and largest_force
# (SI units) set.
width = 16
height = 9
load 'style.gp'
values = folder.'animation-values.csv'
load 'values.gp'
y_end = 1.15e3 * largest_displacement
f_end = 1.15 * largest_force
if (y_end == 0) { y_end = 1 }
if (f_end == 0) { f_end = 1 }
unset key
set format xy '%g'
unset title
point = format eq 'gif' ? 2.5 : 1.0  # its points do not grow with the picture
do for [frame = 1:frames] {
  name = sprintf('frame-%04d.png', frame)
  file = folder.name.'.csv'
  if (format ne 'gif') { set output name }
  set multiplot title heading noenhanced
  set lmargin at screen 0.115
  set rmargin at screen 0.79
  set bmargin at screen 0.13
  set tmargin at screen 0.90
  set xrange [-0.04 * length:1.04 * length]
  set yrange [-y_end:y_end]
  set xtics autofreq
  set ytics autofreq
  set xlabel 'position x / m'
  set ylabel 'displacement y / mm' offset -1
  set object 1 rectangle from 1.006 * length, -y_end to 1.04 * length, y_end fillcolor rgb '#D0D0D0' \
      fillstyle pattern 4 noborder behind
  plot 0 with lines linecolor rgb grey linewidth 0.5, \
       file using 5:(1e3 * $6) with lines linecolor rgb blue linewidth 2.5, \
       file every ::0::0 using (-0.02 * length):(1e3 * $6):(0.02 * length):(0.05 * y_end) \
         with boxxyerror fillcolor rgb '#BBBBBB' fillstyle solid border rgb black, \
       file every ::tip::tip using 5:($3 > 0.5 ? 1e3 * $6 : NaN) with points pointtype 7 pointsize 1.1 * point \
         linecolor rgb black, \
       file every ::tip::tip using 5:($3 < 0.5 ? 1e3 * $6 : NaN) with points pointtype 8 pointsize 1.3 * point \
         linecolor rgb vermillion, \
       file every ::0::0 using (0.03 * length):(0.92 * y_end):(sprintf('t = %.4f s', $2)) with labels left, \
       file every ::0::0 using (0.97 * length):(0.92 * y_end):($3 > 0.5 ? 'tip sticks' : 'tip slips') \
         with labels right
  unset object 1
  set lmargin at screen 0.905
  set rmargin at screen 0.97
  set xrange [-1:1]
  set yrange [-f_end:f_end]
  unset xtics
  set xlabel ' '
  set label 1 'μ_sP' at 0, force_limit center offset 0, 0.6 front
  set label 2 '−μ_sP' at 0, -force_limit center offset 0, -0.6 front
  set ylabel 'friction force f / N' offset -0.5
  plot file every ::0::0 using (0):($4 / 2):(0.5):(abs($4) / 2) with boxxyerror \
         linecolor rgb blue fillstyle solid, \
       0 with lines linecolor rgb grey linewidth 0.5, \
       force_limit with lines linestyle 3 linecolor rgb vermillion, \
       -force_limit with lines linestyle 3 linecolor rgb vermillion
  unset label
  unset multiplot
  set print folder.'drawn'
  print frame
  unset print
}
unset output
