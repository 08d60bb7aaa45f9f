# SPDX-License-Identifier: MIT
# A history of `respond`, or the force that would hold the contact: displacements of base, wall, tip and midspan, and below them the force
# with its limit, +-mu_s P, where the tip slips thick and on a band, and a line at the first slip of what does not follow it.
# nvh.gp sets size and place, as it has a third panel.
if (!exists('width')) { width = 16; height = 10; is_whole = 1 } else { is_whole = 0 }
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
largest = 0
do for [i = 2:5] { if (sizes[i] > largest) { largest = sizes[i] } }
set multiplot title heading noenhanced
unset title
right = is_whole ? 1 - across(1) : 0.6
top_rows = rows_of(has_base + has_wall + 1 + (sizes[4] > 0), 7, right * width - 9 * em)
bottom_rows = rows_of(has_load + follows_slip + has_first_slip + 2, has_first_slip ? 10 : 5, right * width - 9 * em)
eval two_panels
force_label = fitted(force_name.' / N', room)
displacement_label = fitted('displacement / mm', room)
left = margin_of(force_label, displacement_label)
set lmargin at screen left
set rmargin at screen right
key_place = is_whole ? 0.5 : 0.5 * (left + right)
set xrange [time_min:time_max] noextend
set xtics x_step(time_max - time_min, (right - left) * width)
set ylabel displacement_label offset outwards(displacement_label)
eval upper
eval upper_key
set ytics y_step(2e3 * largest, panel)
if (largest == 0) { set yrange [-1:1] }
# The key leaves room for the title of an empty iteration, so that the command is put together.
curves = 'plot '
if (has_base) { curves = curves."file using 1:($2 * 1e3) with lines linecolor rgb grey linewidth 1 dashtype 2 title base_name, " }
if (has_wall) { curves = curves."file using 1:($5 * 1e3) with lines linecolor rgb green linewidth 1 dashtype 4 title 'wall', " }
if (sizes[4] > 0) { curves = curves."file using 1:($4 * 1e3) with lines linecolor rgb blue linewidth 1 title 'midspan', " }
eval curves."file using 1:($3 * 1e3) with lines linecolor rgb vermillion linewidth 1.6 title 'tip'"

unset label
eval lower
eval lower_key
set xlabel 'time / s'.(wall_speed == 0 ? '' : sprintf(', wall at %g mm/s', 1e3 * wall_speed))
set ytics y_step(2 * highest, panel)
set yrange [-1.06 * highest:1.06 * highest]
set ylabel force_label offset outwards(force_label)
set style fill solid noborder
curves = "plot slips using (0.5 * ($1 + $2)):(0):1:2:(-2 * highest):(2 * highest) with boxxyerror linecolor rgb slip_band notitle"
if (has_load) { curves = curves.", file using 1:7 with lines linecolor rgb black linewidth 0.8 dashtype 4 title 'load'" }
curves = curves.", file using 1:6 with lines linecolor rgb blue linewidth 0.8 title follows_slip ? 'stick' : 'held'"
if (follows_slip) { curves = curves.", '' using 1:(strcol(8) eq 'slip' ? $6 : NaN) with lines linecolor rgb vermillion linewidth 2 title 'slip'" }
if (has_first_slip) { curves = curves.", '+' using (first_slip):(-2 * highest):(0):(4 * highest) every ::0::0 with vectors nohead \
    linecolor rgb vermillion linewidth 1.2 title 'first slip'" }
eval curves.", limit with lines linestyle 3 title 'limit', -limit with lines linestyle 3 notitle"
if (is_whole) { unset multiplot }
