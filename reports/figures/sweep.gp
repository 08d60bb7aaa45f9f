# SPDX-License-Identifier: MIT
# The Poincare section of the tip over one parameter, as it rises (crosses) and as it falls (dots): displacement above,
# friction force below.
width = 16
height = 11
load 'style.gp'
values = folder.'sweep-values.csv'
load 'values.gp'
file = folder.'sweep.csv'
of(direction, y) = strcol(1) eq direction ? y : NaN
x(value) = label_scale * value
set multiplot title heading noenhanced
unset title
set lmargin at screen 0.11
set rmargin at screen 0.98
set xrange [*:*] noextend
set offsets 0, 0, graph 0.06, graph 0.06
set tmargin at screen 0.92 - title_share
set bmargin at screen 0.54
set format x ''
set ylabel 'tip displacement / mm'
set key at screen 0.5, 0.985 - title_share center top horizontal maxrows 1
plot file using (x($2)):(of('down', $3 * 1e3)) with points pointtype 7 pointsize 0.25 linecolor rgb vermillion title 'falling', \
     '' using (x($2)):(of('up', $3 * 1e3)) with points pointtype 1 pointsize 0.35 linecolor rgb blue title 'rising'
set tmargin at screen 0.50
set bmargin at screen 0.12
set format x '%g'
set xlabel label
set ylabel 'friction force / N'
plot file using (x($2)):(of('down', $5)) with points pointtype 7 pointsize 0.25 linecolor rgb vermillion notitle, \
     '' using (x($2)):(of('up', $5)) with points pointtype 1 pointsize 0.35 linecolor rgb blue notitle
unset multiplot
