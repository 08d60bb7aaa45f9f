# SPDX-License-Identifier: MIT
# Somebody's results (thin) against a data set (thick, with its uncertainty), and below the difference with what is
# allowed: uncertainty and tolerance. A column of panels for each of the `quantities`; `smooth` says whether the samples of
# the data set are joined. The first label is that of the abscissa.
values = folder.'comparison-values.csv'
set datafile separator comma
set datafile columnheaders
load 'values.gp'
count = int(quantities)
left = 2.2
panel = count > 1 ? 6.6 : 11.8
gap = 2.4
width = left + count * panel + (count - 1) * gap + 0.5
height = 11
own_width = width
load 'style.gp'
label_file = folder.'comparison-labels.csv'
array labels[count + 1]
do for [i = 0:count] {
  stats label_file every ::i::i using (text = strcol(1), 0) name 'row' nooutput
  labels[i + 1] = text
}
set multiplot title heading noenhanced
unset title
do for [i = 1:count] {
  file = sprintf('%scomparison-%d.csv', folder, i)
  set lmargin at screen (left + (i - 1) * (panel + gap)) / own_width
  set rmargin at screen (left + (i - 1) * (panel + gap) + panel) / own_width
  set xrange [*:*] noextend
  stats file using 1 name 'x' nooutput
  spread = x_max > x_min ? x_max - x_min : 1.0
  if (!strstrt(labels[1], ' / ') && spread <= 12) { set xtics 1 }  # they are counted
  set xrange [x_min - 0.03 * spread:x_max + 0.03 * spread]

  set offsets 0, 0, graph 0.05, graph 0.05
  set tmargin at screen 0.93 - title_share
  set bmargin at screen 0.50
  unset xlabel
  set format x ''
  set ylabel labels[i + 1]
  set key at screen 0.5, 0.985 - title_share center top horizontal maxrows 1
  if (i > 1) { unset key }
  if (smooth) {
    plot file using 1:($3 - $4):($3 + $4) with filledcurves fillcolor rgb grey fillstyle transparent solid 0.4 noborder \
           notitle, \
         '' using 1:3 with lines linecolor rgb '#BBBBBB' linewidth 3 title 'reference', \
         '' using 1:2 with lines linecolor rgb vermillion linewidth 0.9 title 'yours'
  } else {
    plot file using 1:3:4 with yerrorbars linecolor rgb black pointtype 6 pointsize 0.8 title 'reference', \
         '' using 1:2 with points linecolor rgb vermillion pointtype 7 pointsize 0.4 title 'yours'
  }

  set tmargin at screen 0.46
  set bmargin at screen 0.17
  set xlabel labels[1]
  set format x '%g'
  set ylabel 'difference'.(strstrt(labels[i + 1], ' / ') ? labels[i + 1][strstrt(labels[i + 1], ' / '):*] : '')
  set key at screen 0.5, 0.01 center bottom horizontal maxrows 1
  if (i < count) { unset key }
  if (smooth) {
    plot file using 1:(-$5):5 with filledcurves fillcolor rgb blue fillstyle transparent solid 0.18 noborder \
           title 'allowed', \
         0 with lines linestyle 3 notitle, \
         file using 1:($2 - $3) with lines linecolor rgb vermillion linewidth 0.9 \
           title 'difference'
  } else {
    plot file using 1:(-$5):(0):(2 * $5) with vectors heads size graph 0.006, 90 linecolor rgb blue linewidth 1.2 \
           title 'allowed', \
         0 with lines linestyle 3 notitle, \
         file using 1:($2 - $3) with points linecolor rgb vermillion pointtype 7 pointsize 0.5 title 'difference'
  }
}
unset multiplot
