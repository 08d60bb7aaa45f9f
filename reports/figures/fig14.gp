# SPDX-License-Identifier: MIT
# Fig. 14: the criterion over beam length and axial force, with what the paper leaves out: the buckling load, over
# which there is no stick state, and the resonances' dependence on P.
width = 16
height = 10
load 'style.gp'
values = folder.'fig14-values.csv'
load 'values.gp'
map = folder.'fig14.csv'
limits = folder.'fig14-limits.csv'
highest = 40000
# The contour |f_max| = mu_s P, found on log P and kept as a table.
set contour base
unset surface
set cntrparam levels discrete 0
set table $criterion
splot map using 1:(log10($2)):(log10($3))
unset contour
set surface
# A contour's table has blanks between its columns, so those of the other lines get them, too.
set table $resonance_1
plot limits using 2:1 with table
set table $resonance_2
plot limits using 3:1 with table
set table $buckling
plot limits using 4:1 with table
unset table

set multiplot
set margins screen 0.085, screen 0.98, screen 0.125, screen 0.90
unset grid
# The stick regions: the surface, cut off at the limit and seen from above.
set xrange [0.4:2]
set yrange [log10(5):log10(highest)]
set zrange [*:0]
set view map
set pm3d clip z border linecolor rgb stick_fill linewidth 0.3
set palette defined (0 stick_fill, 1 stick_fill)
unset colorbox
unset border
unset tics
set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fillcolor rgb slip_fill fillstyle solid noborder
splot map using 1:(log10($2)):(log10($3)) with pm3d notitle
unset object 1

set datafile separator whitespace
unset datafile columnheaders
set border 31 linewidth 0.6
set tics scale 0.6 nomirror
set xlabel 'beam length L / m'
set ylabel 'axial force P / N'
set yrange [5:highest]
set logscale y
set format y '10^{%T}'
set xtics 0.2
set key above horizontal center samplen 4
set label 1 sprintf('L_1: ω_1/2π = %g Hz', hz) at 0.905, 8 front
set label 2 sprintf('L_2: ω_2/2π = %g Hz', hz) at 1.62, 8 front
set label 3 'stick-slip region' at 1.25, 20 center front
set label 4 'stick-slip region' at 0.55, 12 center front
set label 5 'stick region' at 0.62, 400 center front
set label 6 'stick region' at 1.22, 400 center front
set label 7 'stick region' at 1.82, 230 center front
set label 8 sprintf("no stick state: P over the\nbuckling load %.2f EI/L^2", buckling_coefficient) at 1.35, 17000 center front boxed
set label 9 sprintf('case: %g N', case_force) at case_length, case_force right offset -0.8, 0.5 point pointtype 7 pointsize 0.7 front
set style textbox opaque noborder margins 1, 1 fillcolor rgb 'white'
set style fill pattern 4
plot $buckling using 1:2:(highest) with filledcurves fillcolor rgb 'white' fillstyle solid notitle, \
     '' using 1:2:(highest) with filledcurves linecolor rgb grey notitle, \
     $resonance_1 using 1:2 with lines linecolor rgb vermillion linewidth 1.2 dashtype 2 title 'resonance', \
     $resonance_2 using 1:2 with lines linecolor rgb vermillion linewidth 1.2 dashtype 2 notitle, \
     $criterion using 1:(10**$2) with lines linestyle 1 linewidth 1 title '|f_{max}| = μ_sP', \
     $buckling using 1:2 with lines linecolor rgb black linewidth 2.5 dashtype (3, 3) title 'buckling load'
