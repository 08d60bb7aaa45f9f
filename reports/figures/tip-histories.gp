# SPDX-License-Identifier: MIT
# Tip histories of one amplitude, one panel for each frequency hz<i>. All panels have one scale: a panel is as high as what its
# tip covers. Shaded where the tip sticks: where it has moved by less than a micrometre in a step of the table.
set datafile separator comma
set datafile columnheaders
load 'values.gp'
width = 16
height = 1.2 + 2.4 * panels
load 'style.gp'
array hz[4] = [hz1, hz2, exists('hz3') ? hz3 : 0, 0]
array lowest[4]
array highest[4]
all = 0
do for [i = 1:int(panels)] {
  stats file using (1e3 * column(2 * i)) name 'y' nooutput
  all = all + y_max - y_min
  lowest[i] = y_min
  highest[i] = y_max
}
gap = 0.033 * all  # over and below each history
per_mm = (1 - 1.2 / height - 0.65 / height * panels) / (all + 2 * panels * gap)
set xrange [0:shown]
set xtics 0.1
set ytics all > 10 ? 2 : 0.5
unset key
set lmargin at screen 0.095
set rmargin at screen 0.98
set format x ''
top = 1 - 0.65 / height
set multiplot
do for [i = 1:int(panels)] {
  low = lowest[i] - gap
  high = highest[i] + gap
  set yrange [low:high]
  set tmargin at screen top
  bottom = top - per_mm * (high - low)
  set bmargin at screen bottom
  top = bottom - 0.65 / height
  set title sprintf('%g Hz', hz[i])
  if (i == panels) {
    set format x '%g'
    set xlabel 'time t / s'
    set label 'tip displacement y(L, t) / mm' at screen 0.017, 0.53 center rotate
  }
  if (i == 1) { set label 9 'sticks' at graph 0.01, graph 0.85 front } else { unset label 9 }
  last = 0
  rests(y) = (step = abs(y - last), last = y, step < 1e-6)
  plot file using 1:(low):(rests(column(2 * i)) ? high : low) with filledcurves linecolor rgb stick_fill, \
       '' using 1:(1e3 * column(2 * i)) with lines linestyle 1 linewidth 1.0
}
