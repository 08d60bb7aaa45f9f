# SPDX-License-Identifier: MIT
# The frames of an animation one after another, 25 a second. A frame has 1280 times 720 dots, as animation.gp and style.gp
# make it.
set datafile separator comma
set datafile columnheaders
values = folder.'animation-values.csv'
load 'values.gp'
set terminal gif animate delay 4 loop 0 size 1280, 720
set output output
unset key
unset tics
unset border
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1
set autoscale fix
do for [frame = 1:last_frame] { plot sprintf('frame-%04d.png', frame) binary filetype=png with rgbimage }
unset output
