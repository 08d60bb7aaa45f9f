# SPDX-License-Identifier: MIT
# The rig of the case `rig`, from above, and the tip that its other test needs. Not to scale; the numbers are those of the case.
width = 16
height = 6.6
load 'style.gp'
values = folder.'rig-values.csv'
load 'values.gp'
unset border
unset tics
unset grid
unset key
set xrange [-0.35:1.9]
set yrange [-0.6:0.4]
set margins 0, 0, 0, 0
set style line 5 linecolor rgb black linewidth 0.9
set style arrow 1 head filled size screen 0.012, 18 linestyle 5 front
set style arrow 2 heads filled size screen 0.012, 18 linestyle 5
set style arrow 3 head filled size screen 0.016, 18 linecolor rgb vermillion linewidth 2.5 front
set object 1 rectangle from -0.1, -0.12 to 0, 0.12 fillstyle solid border rgb black fillcolor rgb '#BBBBBB'
set label "clamp on\na shaker" at -0.13, 0.3 center
set arrow from -0.05, -0.2 to -0.05, -0.36 arrowstyle 2
set label "h(t): measured on\nthe clamp" at -0.01, -0.25 left
set object 2 rectangle from 0, -0.012 to 1, 0.012 fillstyle solid noborder fillcolor rgb blue
set label sprintf("strip of spring steel, %g mm × %g mm", 1e3 * section_width, 1e3 * section_height) at 0.5, 0.06 center
set arrow from 0, -0.1 to 1, -0.1 arrowstyle 2
set label sprintf('%g mm (and 400 mm)', 1e3 * beam_length) at 0.5, -0.15 center
set object 3 rectangle from 1, -0.3 to 1.06, 0.3 fillstyle pattern 5 border rgb black fillcolor rgb grey
set label sprintf("plate, μ_s about %g: onset of slip", static_coefficient) at 1.03, 0.36 center
set object 4 rectangle from 1.06, -0.05 to 1.2, 0.05 fillstyle solid border rgb black fillcolor rgb slip_fill
set label "load cell: axial\nand friction force" at 1.22, -0.1 left
set arrow from 1.45, 0 to 1.21, 0 arrowstyle 3
set label sprintf("P = %g N (and 0.5,\n1, 3, 4 N) by a\nsoft spring", axial_force) at 1.47, 0.08 left
set arrow from 0.93, -0.4 to 0.93, -0.02 linestyle 5 dashtype 3 nohead
set label "laser: motion of the tip" at 0.91, -0.36 right
# The other tip, with rollers between a block and the plate.
set object 5 rectangle from 0.97, -0.08 to 1.09, 0.08 fillstyle empty border rgb vermillion dashtype 2 front
set arrow from 1.09, -0.08 to 1.16, -0.26 linecolor rgb vermillion dashtype 2 nohead
set object 6 rectangle from 1.12, -0.56 to 1.86, -0.26 fillstyle empty border rgb vermillion dashtype 2
set object 7 rectangle from 1.14, -0.42 to 1.28, -0.4 fillstyle solid noborder fillcolor rgb blue
set object 8 rectangle from 1.28, -0.47 to 1.32, -0.35 fillstyle solid border rgb black fillcolor rgb '#BBBBBB'
do for [i = 0:2] { set object 9 + i circle at 1.337, -0.45 + 0.04 * i radius 0.017 fillstyle solid border rgb black fillcolor rgb 'white' }
set object 12 rectangle from 1.354, -0.54 to 1.39, -0.28 fillstyle pattern 5 border rgb black fillcolor rgb grey
set label "for the sliding\nfrequency: rollers\nor an air film" at 1.43, -0.35 left
plot NaN
