# SPDX-License-Identifier: MIT
# Fig. 3: numbered snapshots of the beam over one period, the first half of it left, the second right; the tip says
# whether it sticks. Of the excitations in fig3.csv those two at which it slips.
width = 16
height = 9.4
load 'style.gp'
file = folder.'fig3.csv'
stats file using 1 name 'panel' nooutput
stats file using 3 name 'snapshot' nooutput
stats file using 7 name 'position' nooutput
stats file using ($6 < 0.5 ? $1 : NaN) name 'slips' nooutput  # the first panel in which the tip slips and the last
points = int(position_records / panel_max / snapshot_max)  # per snapshot
rows = points * int(snapshot_max)                          # per panel
half = (int(snapshot_max) + 1) / 2                         # snapshots of half a period
step_in(k, j) = k - 1 - (j - 1) * (half - 1)               # from the first snapshot of half j
first(i, k) = (i - 1) * rows + (k - 1) * points
tip(i, k) = first(i, k) + points - 1
# Where along the beam the snapshots of a half have their numbers.
array fractions[5] = [0.14, 0.30, 0.53, 0.62, 0.80]
labelled(i, k, j) = first(i, k) + int(fractions[step_in(k, j) + 1] * points)

# From dark to light in the order of time, in each half.
set palette defined (0 '#440154', 0.25 '#3B528B', 0.5 '#21918C', 0.75 '#5DC863', 1 '#D8C220')
shade(k, j) = 0.88 * step_in(k, j) / (half - 1)
set cbrange [0:1]
unset colorbox
set style textbox opaque noborder margins 0.4, 0.3 fillcolor rgb 'white'
set xtics 0.5
set multiplot layout 2, 2 margins 0.09, 0.985, 0.19, 0.945 spacing 0.045, 0.1
do for [i in sprintf('%d %d', slips_min, slips_max)] {
  set autoscale xy  # what follows counts only rows in range
  stats file every ::first(i, 1)::(first(i, 1) + rows - 1) using (1e3 * $8) name 'y' nooutput
  gap = 0.08 * (y_max - y_min)
  stats file every ::first(i, 1)::first(i, 1) using (hz = $2, begin_ms = 1e3 * $4) nooutput
  set xlabel (i == slips_max ? 'position x / m' : '')
  set format x (i == slips_max ? '%g' : '')
  set xrange [0:position_max * 1.03]
  set yrange [y_min - gap:y_max + gap]
  do for [j = 1:2] {
    begin = (j - 1) * (half - 1) + 1
    end = begin + half - 1
    set title sprintf('(%s) %g Hz from %.1f ms: %s half period', 'abcd'[int(i):int(i)], hz, begin_ms, j == 1 ? 'first' : 'second')
    set format y (j == 1 ? '%g' : '')
    unset key
    if (i == slips_max && j == 2) {
      set key at screen 0.5, 0.005 center bottom vertical maxrows 1
      set label 'displacement y(x, t) / mm' at screen 0.017, 0.53 center rotate
    }
    plot for [k = begin:end] file every ::first(i, k)::tip(i, k) \
           using 7:(1e3 * $9):(shade(k, j)) with lines linewidth 1.2 linecolor palette notitle, \
         for [k = begin:end] file every 6::first(i, k)::(tip(i, k) - 1) \
           using 7:(1e3 * $8):(shade(k, j)) with points pointtype 6 pointsize 0.4 linewidth 0.7 linecolor palette notitle, \
         for [k = begin:end] file every ::tip(i, k)::tip(i, k) \
           using 7:(1e3 * $8):($6 > 0.5 ? 7 : 8):($6 > 0.5 ? 0x000000 : 0xD55E00) \
           with points pointtype variable pointsize 0.7 linecolor rgb variable notitle, \
         for [k = begin:end] file every ::labelled(i, k, j)::labelled(i, k, j) \
           using 7:(1e3 * $9):(sprintf('%d', k)) with labels boxed notitle, \
         keyentry with lines linewidth 1.2 linecolor rgb grey title 'continuous beam', \
         keyentry with points pointtype 6 pointsize 0.4 linecolor rgb grey title 'finite elements', \
         keyentry with points pointtype 7 pointsize 0.7 linecolor rgb black title 'tip sticks', \
         keyentry with points pointtype 8 pointsize 0.7 linecolor rgb vermillion title 'tip slips'
  }
}
