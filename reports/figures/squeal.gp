# SPDX-License-Identifier: MIT
# Stability of steady sliding over the speed of the wall and the damping ratio: the growth rate by colour, its contour 0.
width = 16
height = 10
load 'style.gp'
file = folder.'squeal.csv'
set contour base
unset surface
set cntrparam levels discrete 0
set table $limit
splot file using 1:2:3
unset table
unset contour
set surface
set xlabel 'speed of the wall / (m/s)'
set ylabel 'damping ratio ζ'
set xrange [*:*] noextend
set yrange [*:*] noextend
set key above horizontal center samplen 3
set margins screen 0.105, screen 0.97, screen 0.125, screen 0.90
unset grid
set tics out
limit = |$limit| > 4 ? '$limit using 1:2' : 'NaN'
plot file using 1:2:(strcol(4) eq 'unstable' ? 0.5 : NaN) with points pointtype 5 pointsize 0.5 linecolor rgb '#FDCB75' title 'unstable: squeal', \
     file using 1:2:(strcol(4) eq 'stable' ? 0.5 : NaN) with points pointtype 5 pointsize 0.5 linecolor rgb '#2171B5' title 'stable'
