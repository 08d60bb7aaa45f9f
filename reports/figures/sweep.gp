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
top_rows = 1
bottom_rows = 0
eval two_panels
displacement_label = fitted('tip displacement / mm', room)
force_label = fitted('friction force / N', room)
set lmargin at screen margin_of(displacement_label, force_label)
set rmargin at screen 1 - across(1)
set xrange [*:*] noextend
set offsets 0, 0, graph 0.06, graph 0.06
eval upper
eval upper_key
set ylabel displacement_label offset outwards(displacement_label)
stats file using 3 name 'tip' nooutput
set ytics y_step(1.12e3 * (tip_max - tip_min), panel)
plot file using (x($2)):(of('down', $3 * 1e3)) with points pointtype 7 pointsize 0.25 linecolor rgb vermillion title 'falling', \
     '' using (x($2)):(of('up', $3 * 1e3)) with points pointtype 1 pointsize 0.35 linecolor rgb blue title 'rising'
eval lower
set xlabel label
set ylabel force_label offset outwards(force_label)
stats file using 5 name 'force' nooutput
set ytics y_step(1.12 * (force_max - force_min), panel)
plot file using (x($2)):(of('down', $5)) with points pointtype 7 pointsize 0.25 linecolor rgb vermillion notitle, \
     '' using (x($2)):(of('up', $5)) with points pointtype 1 pointsize 0.35 linecolor rgb blue notitle
unset multiplot
