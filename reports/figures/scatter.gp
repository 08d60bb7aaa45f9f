# SPDX-License-Identifier: MIT
# Computed values against their references (left), and their signed relative differences (right) on an axis that is
# linear within 1e-5 and logarithmic beyond. Behind the values stand bias and spread of either kind.
width = 14.4
height = 7.5
load 'style.gp'
values = folder.'scatter-values.csv'
load 'values.gp'
file = folder.'scatter.csv'
is(reference, erratum) = strcol(2) eq reference && $3 == erratum
squeezed(d) = asinh(1e5 * d)
set multiplot
set tmargin at screen 0.93
set bmargin at screen 0.33
set key at screen 0.5, 0.015 center bottom maxrows 2 vertical

set lmargin at screen 0.125
set rmargin at screen 0.435
set title 'Values'
set logscale xy
set format xy '10^{%T}'
set xrange [1e-5:1e5]
set yrange [1e-5:1e5]
set xtics 100
set ytics 100
set xlabel 'reference (SI units)'
set ylabel 'computed (SI units)'
plot x with lines linestyle 3 notitle, \
     file using (is('mesh-free', 0) ? $5 : NaN):4 with points pointtype 4 pointsize 0.8 linewidth 1.2 \
       linecolor rgb blue title sprintf('finite elements (%d)', exact_count), \
     '' using (is('printed', 0) ? $5 : NaN):4 with points pointtype 7 pointsize 0.5 \
       linecolor rgb vermillion title sprintf('printed numbers (%d)', printed_count), \
     '' using (is('printed', 1) ? $5 : NaN):4 with points pointtype 2 pointsize 0.8 linewidth 1.5 \
       linecolor rgb black title 'known errata', \
     keyentry with yerrorbars linecolor rgb black pointtype 7 pointsize 0.5 title 'bias and spread'

set lmargin at screen 0.58
set rmargin at screen 0.985
set title 'Signed relative differences'
unset key
unset logscale y
set format y '%g'
set ylabel 'computed/reference − 1' offset -1
set xrange [1e-5:1e8]
set xtics (1e-4, 1e-2, 1, 1e2, 1e4)
set yrange [squeezed(-0.2):squeezed(0.2)]
set ytics ('−10^{−1}' squeezed(-1e-1), '−10^{−2}' squeezed(-1e-2), '−10^{−3}' squeezed(-1e-3), \
    '−10^{−4}' squeezed(-1e-4), '0' 0, '10^{−4}' squeezed(1e-4), '10^{−3}' squeezed(1e-3), '10^{−2}' squeezed(1e-2), \
    '10^{−1}' squeezed(1e-1))
set samples 2
plot 0 with lines linestyle 3, \
     file using (is('mesh-free', 0) ? $5 : NaN):(squeezed($6)) with points pointtype 4 pointsize 0.8 linewidth 1.2 \
       linecolor rgb blue, \
     '' using (is('printed', 0) ? $5 : NaN):(squeezed($6)) with points pointtype 7 pointsize 0.5 \
       linecolor rgb vermillion, \
     '' using (is('printed', 1) ? $5 : NaN):(squeezed($6)) with points pointtype 2 pointsize 0.8 linewidth 1.5 \
       linecolor rgb black, \
     '+' every ::0::0 using (1e6):(squeezed(exact_bias)):(squeezed(exact_bias - exact_spread)): \
       (squeezed(exact_bias + exact_spread)) with yerrorbars linecolor rgb blue linewidth 1.5 pointtype 4 pointsize 0.8, \
     '+' every ::0::0 using (1e7):(squeezed(printed_bias)):(squeezed(printed_bias - printed_spread)): \
       (squeezed(printed_bias + printed_spread)) with yerrorbars linecolor rgb vermillion linewidth 1.5 pointtype 7 pointsize 0.5
unset multiplot
