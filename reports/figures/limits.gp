# SPDX-License-Identifier: MIT
# The amplitude of the base from which on the tip slips: at a start-up without and with damping, and in steady vibration.
width = 16
height = 7.5
load 'style.gp'
values = folder.'limits-values.csv'
load 'values.gp'
file = folder.'limits.csv'
set xlabel 'excitation frequency / Hz' offset 0, 0.4
set ylabel 'amplitude of the base A_0 / mm' offset 1
set xrange [2:157]
set yrange [2e-3:20]
set logscale y
set format y '%g'
set xtics 20
unset grid
set key above horizontal center samplen 3 maxrows 2 width -4
set margins screen 0.095, screen 0.965, screen 0.135, screen 0.85
set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fillcolor rgb slip_fill fillstyle solid noborder
set arrow from highest * natural1, graph 0 to highest * natural1, graph 1 nohead linestyle 3 linewidth 1.2 linecolor rgb black front
set label '← domain of the margin' at highest * natural1 + 1, 3.5 left front
do for [hz in sprintf('%.1f %.1f %.1f', natural1, natural2, natural3)] {
  set object rectangle from (1 - distance) * hz, graph 0 to (1 + distance) * hz, graph 1 front fillcolor rgb grey fillstyle transparent solid 0.25 noborder
  if (hz < 157) { set arrow from hz, graph 0 to hz, graph 1 nohead linestyle 3 front; set label hz.' Hz' at hz + 1, 14 left front }
}
set label 'tip slips' at 52, 3.5 center front
set label 'tip sticks' at 52, 0.012 center front
plot file using 1:(1e3 * $2) with filledcurves y=2e-3 fillcolor rgb stick_fill notitle, \
     '' using 1:(1e3 * $5) with lines linecolor rgb green linewidth 1.2 dashtype 2 title 'steady, 0.5 % damping', \
     '' using 1:(1e3 * $4) with lines linecolor rgb vermillion linewidth 1.2 title 'start-up, 0.5 % damping', \
     '' using 1:(1e3 * $2) with lines linestyle 1 linewidth 2 title 'start-up over 10 s: the criterion'
