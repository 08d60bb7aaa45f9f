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
set ylabel 'damping ratio ζ' offset 1
set xrange [*:*] noextend
set yrange [*:*] noextend
set key above horizontal center samplen 3 maxrows 1
set margins screen 0.12, screen 0.97, screen 0.125, screen 0.89 - title_share
unset grid
set tics out
unset colorbox
set cbrange [0:1]
eval sprintf("set palette defined (0 '%s', 1 '%s')", stick_fill, slip_fill)
limit = |$limit| > 4 ? '$limit using 1:2' : 'NaN'  # there are four lines of comment where there is no contour
limit_title = limit eq 'NaN' ? '' : 'limit of stability'
plot $cells using 1:2:3 with image notitle, \
     @limit with lines linecolor rgb black linewidth 1.2 title limit_title, \
     for [i = squeal_min:0] keyentry with boxes linecolor rgb stick_fill fillstyle solid title 'steady', \
     for [i = 1:squeal_max] keyentry with boxes linecolor rgb slip_fill fillstyle solid title 'squeal'
