# SPDX-License-Identifier: MIT
# Stability of steady sliding over the speed of the wall and the damping ratio: the sign of the growth rate by colour, and its
# contour 0. What does not occur is not in the key.
width = 16
height = 10
load 'style.gp'
file = folder.'squeal.csv'
stats file using ($3 > 0 ? 1 : 0) name 'squeal' nooutput
set contour base
unset surface
set cntrparam levels discrete 0
set table $limit
splot file using 1:2:3
unset contour
set surface
# A contour's table has blanks between its columns, so that of the cells gets them, too.
set table $cells
plot file using 1:2:($3 > 0 ? 1 : 0) with table
unset table
set datafile separator whitespace
unset datafile columnheaders
set xlabel 'speed of the wall / (m/s)'
set ylabel 'damping ratio ζ'
set xrange [*:*] noextend
set yrange [*:*] noextend
set key above horizontal center samplen 3
unset grid
set tics out
unset colorbox
set cbrange [0:1]
eval sprintf("set palette defined (0 '%s', 1 '%s')", stick_fill, slip_fill)
limit = |$limit| > 4 ? '$limit using 1:2' : 'NaN'  # there are four lines of comment where there is no contour
# The key leaves room for the title of an empty iteration, so that the command is put together.
curves = 'plot $cells using 1:2:3 with image notitle'
if (limit ne 'NaN') { curves = curves.', '.limit." with lines linecolor rgb black linewidth 1.2 title 'limit of stability'" }
if (squeal_min == 0) { curves = curves.", keyentry with boxes linecolor rgb stick_fill fillstyle solid title 'steady'" }
if (squeal_max == 1) { curves = curves.", keyentry with boxes linecolor rgb slip_fill fillstyle solid title 'squeal'" }
eval curves
