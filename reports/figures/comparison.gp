# SPDX-License-Identifier: MIT
# Somebody's results (thin) against a data set (thick, with its uncertainty), and below the difference with what is
# allowed: uncertainty and tolerance. A column of panels for each of the `quantities`; `smooth` says whether the samples of
# the data set are joined. The first label is that of the abscissa.
values = folder.'comparison-values.csv'
set datafile separator comma
set datafile columnheaders
load 'values.gp'
count = int(quantities)
columns = count
width = count > 1 ? 0.3 + 9.0 * count : 14.5
height = 11
load 'style.gp'
label_file = folder.'comparison-labels.csv'
array labels[count + 1]
do for [i = 0:count] {
  stats label_file every ::i::i using (text = strcol(1), 0) name 'row' nooutput
  labels[i + 1] = text
}
panel_width = (width - em) / count - 9 * em
top_rows = rows_of(2, 9, panel_width)
bottom_rows = rows_of(2, 10, panel_width)
eval two_panels
array differences[count]
left = 0
do for [i = 1:count] {
  differences[i] = fitted('difference'.(strstrt(labels[i + 1], ' / ') ? labels[i + 1][strstrt(labels[i + 1], ' / '):*] : ''), room)
  labels[i + 1] = fitted(labels[i + 1], room)
  if (margin_of(labels[i + 1], differences[i]) > left) { left = margin_of(labels[i + 1], differences[i]) }
}
left = left + across(1)
share = (1 - across(1)) / count
set multiplot title heading noenhanced
unset title
do for [i = 1:count] {
  file = sprintf('%scomparison-%d.csv', folder, i)
  set lmargin at screen (i - 1) * share + left
  set rmargin at screen i * share
  set xrange [*:*] noextend
  stats file using 1 name 'x' nooutput
  spread = x_max > x_min ? x_max - x_min : 1.0
  if (!strstrt(labels[1], ' / ') && spread <= 12) { set xtics round_step(spread * 2 * em / panel_width) }  # they are counted
  set xrange [x_min - 0.03 * spread:x_max + 0.03 * spread]

  set offsets 0, 0, graph 0.05, graph 0.05
  eval upper
  eval upper_key
  unset xlabel
  set ylabel labels[i + 1] offset outwards(labels[i + 1])
  stats file using 2 name 'theirs' nooutput
  set ytics y_step(theirs_max - theirs_min, panel)
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

  eval lower
  eval lower_key
  set xlabel labels[1]
  set ylabel differences[i] offset outwards(differences[i])
  stats file using ($5 > abs($2 - $3) ? $5 : abs($2 - $3)) name 'error' nooutput
  set ytics y_step(2 * error_max, panel)
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
