# SPDX-License-Identifier: MIT
# Fig. 3: snapshots of the beam over one period, coloured by time; the tip says whether it sticks. Needs nothing
# but fig3.csv.
width = 16
height = 11
load 'style.gp'
file = folder.'fig3.csv'
stats file using 1 name 'panel' nooutput
stats file using 3 name 'snapshot' nooutput
stats file using 7 name 'position' nooutput
points = int(position_records / panel_max / snapshot_max)  # per snapshot
rows = points * int(snapshot_max)                          # per panel
first(i, k) = (i - 1) * rows + (k - 1) * points

# Viridis without its pale end: even in lightness, so that the order of the colours can be read by everybody.
set palette defined (0 '#440154', 0.25 '#3B528B', 0.5 '#21918C', 0.75 '#5DC863', 1 '#D8C220')
set cbrange [0:1]
set cbtics 0.25 scale 0.4 offset -0.5
set cblabel 'time since the first snapshot / period' offset 0.2
unset colorbox
set format xy '%g'
set xrange [0:position_max * 1.04]
set xtics 0.5
set ytics autofreq
set multiplot
left(i) = i % 2 == 1 ? 0.085 : 0.525
low(i) = i <= 2 ? 0.575 : 0.095
do for [i = 1:int(panel_max)] {
  set lmargin at screen left(i)
  set rmargin at screen left(i) + 0.35
  set bmargin at screen low(i)
  set tmargin at screen low(i) + 0.37
  row = first(i, 1)
  stats file every ::row::row using 2 name 'hz' nooutput
  stats file every ::row::row using (1e3 * $4) name 'begin' nooutput
  stats file every ::(row + rows - 1)::(row + rows - 1) using (1e3 * $4) name 'end' nooutput
  set title sprintf('(%s) %g Hz, %.1f to %.1f ms', 'abcd'[i:i], hz_min, begin_min, end_min) offset 0, -0.6
  set xlabel (i > 2 ? 'position x / m' : '')
  set ylabel (i % 2 == 1 ? 'y(x, t) / mm' : '') offset 1
  if (i == 2) {
    set colorbox user origin screen 0.9, screen 0.27 size screen 0.016, screen 0.6
    set key at screen 1.015, screen 0.19 right reverse Left samplen 1 font ',6.5'
  } else {
    unset colorbox
    unset key
  }
  tip(k) = first(i, k) + points - 1
  plot for [k = 1:int(snapshot_max)] file every ::first(i, k)::tip(k) \
         using 7:(1e3 * $9):5 with lines linewidth 1.2 linecolor palette notitle, \
       for [k = 1:int(snapshot_max)] file every 6::first(i, k)::(tip(k) - 1) \
         using 7:(1e3 * $8):5 with points pointtype 6 pointsize 0.35 linewidth 0.7 linecolor palette notitle, \
       for [k = 1:int(snapshot_max)] file every ::tip(k)::tip(k) \
         using 7:($6 > 0.5 ? 1e3 * $8 : NaN) with points pointtype 7 pointsize 0.6 linecolor rgb black notitle, \
       for [k = 1:int(snapshot_max)] file every ::tip(k)::tip(k) \
         using 7:($6 < 0.5 ? 1e3 * $8 : NaN) with points pointtype 8 pointsize 0.75 linecolor rgb vermillion notitle, \
       NaN with points pointtype 7 pointsize 0.6 linecolor rgb black title 'tip sticks', \
       NaN with points pointtype 8 pointsize 0.75 linecolor rgb vermillion title 'tip slips', \
       NaN with points pointtype 6 pointsize 0.35 linecolor rgb grey title 'finite el.'
}
unset multiplot
