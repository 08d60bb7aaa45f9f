# SPDX-License-Identifier: MIT
# Histogram of the margins of the samples, mu_s P over the largest |f|: below 1 the tip slips.
width = 16
height = 8
load 'style.gp'
file = folder.'uncertainty.csv'
stats file using 1 name 'margin' nooutput
# Bins between 1 and 1 plus or minus a whole number of widths, some 40 between the smallest and the largest margin.
bin = (margin_max - margin_min) / 40.0
if (bin == 0) { bin = 0.01 }
middle(x) = 1.0 + bin * (floor((x - 1.0) / bin) + 0.5)
set xrange [(margin_min < 1 ? margin_min : 1) - bin:margin_max + bin] noextend
set yrange [0:*]
set xlabel 'margin μ_sP / max |f|'
set ylabel 'samples'
set boxwidth bin
set style fill solid 0.8 noborder
set arrow 1 from 1, graph 0 to 1, graph 1 nohead linestyle 3 front
set label 1 'slips ' at 1, graph 1.0 right offset 0, 0.7
set label 2 ' sticks' at 1, graph 1.0 left offset 0, 0.7
set tmargin 4
set title offset 0, 0.5
unset key
plot file using (middle($1)):($1 < 1 ? 1 : NaN) smooth frequency with boxes linecolor rgb vermillion, \
     file using (middle($1)):($1 >= 1 ? 1 : NaN) smooth frequency with boxes linecolor rgb blue
