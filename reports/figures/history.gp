# SPDX-License-Identifier: MIT
# A history of `respond`, or the force that would hold the contact: displacements of base, wall, tip and midspan, and below them the force
# with its limit, +-mu_s P, where the tip slips thick and on a band, and a line at the first slip of what does not follow it.
# nvh.gp sets size and place, as it has a third panel.
if (!exists('width')) { width = 16; height = 10; left = 0.11; right = 0.98; is_whole = 1 } else { is_whole = 0 }
load 'style.gp'
values = folder.'history-values.csv'
load 'values.gp'
file = folder.'history.csv'
slips = folder.'history-slips.csv'
array sizes[8]  # of the columns
do for [i = 2:7] { stats file using i name 's' nooutput; sizes[i] = s_max > -s_min ? s_max : -s_min }
stats file using 1 name 'time' nooutput
highest = limit > sizes[6] ? limit : sizes[6]
if (sizes[7] > highest) { highest = sizes[7] }
set multiplot title heading noenhanced
unset title
set lmargin at screen left
set rmargin at screen right
set xrange [time_min:time_max] noextend
set tmargin at screen 0.92 - title_share
set bmargin at screen 0.54
set format x ''
set ylabel 'displacement / mm'
set key at screen is_whole ? 0.5 : 0.5 * (left + right), 0.985 - title_share center top horizontal maxrows 1
if (sizes[2] + sizes[3] + sizes[4] + sizes[5] == 0) { set yrange [-1:1] }
# The key leaves room for the title of an empty iteration, so that the command is put together.
curves = 'plot '
if (has_base) { curves = curves."file using 1:($2 * 1e3) with lines linecolor rgb grey linewidth 1 dashtype 2 title base_name, " }
if (has_wall) { curves = curves."file using 1:($5 * 1e3) with lines linecolor rgb green linewidth 1 dashtype 4 title 'wall', " }
if (wall_speed != 0) { set label 1 sprintf('wall at %g mm/s', 1e3 * wall_speed) at screen right, 0.962 - title_share right }
if (sizes[4] > 0) { curves = curves."file using 1:($4 * 1e3) with lines linecolor rgb blue linewidth 1 title 'midspan', " }
eval curves."file using 1:($3 * 1e3) with lines linecolor rgb vermillion linewidth 1.6 title 'tip'"

unset label
set tmargin at screen 0.50
set bmargin at screen 0.17
set xlabel 'time / s'
set format x '%g'
set yrange [-1.06 * highest:1.06 * highest]
set ylabel force_name.' / N'
set key at screen is_whole ? 0.5 : 0.5 * (left + right), 0.01 center bottom horizontal maxrows 1
set style fill solid noborder
curves = "plot slips using (0.5 * ($1 + $2)):(0):1:2:(-2 * highest):(2 * highest) with boxxyerror linecolor rgb slip_band notitle"
if (has_load) { curves = curves.", file using 1:7 with lines linecolor rgb black linewidth 0.8 dashtype 4 title 'load'" }
curves = curves.", file using 1:6 with lines linecolor rgb blue linewidth 0.8 title follows_slip ? 'stick' : 'held'"
if (follows_slip) { curves = curves.", '' using 1:(strcol(8) eq 'slip' ? $6 : NaN) with lines linecolor rgb vermillion linewidth 2 title 'slip'" }
if (has_first_slip) { curves = curves.", '+' using (first_slip):(-2 * highest):(0):(4 * highest) every ::0::0 with vectors nohead \
    linecolor rgb vermillion linewidth 1.2 title 'first slip'" }
eval curves.", limit with lines linestyle 3 title has_load ? 'limit' : 'friction limit', -limit with lines linestyle 3 notitle"
if (is_whole) { unset multiplot }
