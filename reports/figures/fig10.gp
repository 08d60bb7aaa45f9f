# SPDX-License-Identifier: MIT
# Fig. 10: largest static friction force over frequency and amplitude, with the limit mu_s P and the excitations A to D.
# |f_max| is proportional to the amplitude: the line of any force is that of 1 N, stretched.
width = 14.7
height = 9
load 'style.gp'
values = folder.'fig10-values.csv'
load 'values.gp'
stats folder.'fig10.csv' using 1:2 name 'grid' nooutput
set table $per_newton  # amplitude in mm
plot folder.'fig10.csv' using 1:(1e3 * $2 / $3) with table if ($2 == grid_max_y)
set table $points
plot folder.'fig10-points.csv' using (strcol(1)):2:(1e3 * $3) with table
unset table
set datafile separator whitespace
unset datafile columnheaders

# Class k of the forces lies under level k; the limit is the middle one.
array levels[7] = [limit / 30, limit / 10, limit / 3, limit, 3 * limit, 10 * limit, 30 * limit]
eval ratio_palette
set palette maxcolors |levels| + 1
set cbrange [0:|levels| + 1]
set cbtics scale 0.4 ('' 0)
do for [k = 1:|levels|] { set cbtics add (sprintf('%g', levels[k]) k) }
set cblabel '|f_{max}| / N'
set xlabel 'excitation frequency / Hz'
set ylabel 'excitation amplitude A_0 / mm' offset 1
set xrange [grid_min_x:grid_max_x]
set yrange [0:1]
set xtics 20
unset grid
set key above horizontal center
set margins screen 0.095, screen 0.845, screen 0.13, screen 0.90
set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fillstyle solid noborder \
    fillcolor palette cb |levels| + 0.5
set label 1 'stick' at 9, 0.75 center front textcolor rgb 'white'
set label 2 'stick' at 42, 0.32 center front
set label 3 'stick-slip' at 60, 0.75 center front
set label 4 'stick-slip' at 105, 0.75 center front
set style textbox opaque noborder margins 0.6, 0.3 fillcolor rgb 'white'
plot for [k = |levels|:1:-1] $per_newton using 1:($2 * levels[k]) with filledcurves y=0 \
       fillcolor palette cb k - 0.5 notitle, \
     $per_newton using 1:($2 * limit) with lines linecolor rgb black linewidth 1.8 \
       title sprintf('|f_{max}| = μ_sP = %g N', limit), \
     $points using 2:3 with points pointtype 7 pointsize 0.9 linecolor rgb black notitle, \
     $points using 2:3 with points pointtype 7 pointsize 0.55 linecolor rgb 'white' notitle, \
     $points using ($2 + 2.2):($3 + 0.045):1 with labels boxed notitle
