# SPDX-License-Identifier: MIT
# Computed values against their references (left), and their signed relative differences (right) on an axis that is
# linear within 1e-5 and logarithmic beyond.
width = 16
height = 6
load 'style.gp'
values = folder.'scatter-values.csv'
load 'values.gp'
file = folder.'scatter.csv'
is(reference, erratum) = strcol(2) eq reference && $3 == erratum
squeezed(d) = asinh(1e5 * d)
set multiplot
set tmargin at screen 0.93
set bmargin at screen 0.33
set key at screen 0.5, 0.015 center bottom maxrows 2 vertical reverse Left samplen 1.2

set lmargin at screen 0.09
set rmargin at screen 0.42
set title 'Values' offset 0, -0.6
set logscale xy
set format xy '10^{%T}'
set xrange [1e-5:1e5]
set yrange [1e-5:1e5]
set xtics 100
set ytics 100
set xlabel 'reference (SI units)'
set ylabel 'computed (SI units)' offset 1
plot x with lines linestyle 3 notitle, \
     file using (is('closed form', 0) ? $5 : NaN):4 with points pointtype 4 pointsize 0.7 \
       linecolor rgb blue title sprintf('finite elements against closed form (%d)', exact_count), \
     '' using (is('printed', 0) ? $5 : NaN):4 with points pointtype 6 pointsize 0.6 \
       linecolor rgb vermillion title sprintf('against printed numbers (%d)', printed_count), \
     '' using (is('printed', 1) ? $5 : NaN):4 with points pointtype 2 pointsize 0.6 \
       linecolor rgb black title 'known errata'

set lmargin at screen 0.56
set rmargin at screen 0.98
set title 'Signed relative differences' offset 0, -0.6
unset key
unset logscale y
set format y '%g'
set ylabel 'computed/reference − 1' offset -0.5
set yrange [squeezed(-0.2):squeezed(0.2)]
set ytics ('−10^{−1}' squeezed(-1e-1), '−10^{−2}' squeezed(-1e-2), '−10^{−3}' squeezed(-1e-3), \
    '−10^{−4}' squeezed(-1e-4), '0' 0, '10^{−4}' squeezed(1e-4), '10^{−3}' squeezed(1e-3), '10^{−2}' squeezed(1e-2), \
    '10^{−1}' squeezed(1e-1))
set object 1 rectangle from graph 0, first squeezed(printed_bias - printed_spread) \
    to graph 1, first squeezed(printed_bias + printed_spread) behind fillcolor rgb vermillion fillstyle transparent solid 0.12 noborder
set object 2 rectangle from graph 0, first squeezed(exact_bias - exact_spread) \
    to graph 1, first squeezed(exact_bias + exact_spread) behind fillcolor rgb blue fillstyle transparent solid 0.12 noborder
plot 0 with lines linestyle 3, \
     squeezed(printed_bias) with lines linecolor rgb vermillion linewidth 0.8, \
     squeezed(exact_bias) with lines linecolor rgb blue linewidth 0.8, \
     file using (is('closed form', 0) ? $5 : NaN):(squeezed($6)) with points pointtype 4 pointsize 0.7 \
       linecolor rgb blue, \
     '' using (is('printed', 0) ? $5 : NaN):(squeezed($6)) with points pointtype 6 pointsize 0.6 \
       linecolor rgb vermillion, \
     '' using (is('printed', 1) ? $5 : NaN):(squeezed($6)) with points pointtype 2 pointsize 0.6 \
       linecolor rgb black
unset multiplot
