# SPDX-License-Identifier: MIT
# The criterion over two parameters: |f_max|/(mu_s P) by colour and its contour 1, from a table of x, y, ratio and
# state. An axis has the label x_label or y_label and is scaled by x_scale or y_scale; its values follow each other in equal
# steps, or in equal ratios where x_log or y_log is 1. Blue sticks, orange slips, the lighter the larger the force; hatched has no stick state.
# Where states_only is 1 the table has no ratio, and the regions have one colour each. Where `quantities` is not 0 the table
# has the value and the change of so many, and the first one, quantity_label, is drawn: hatched where it has not converged.
width = 16
height = 10
load 'style.gp'
values = folder.'map-values.csv'
load 'values.gp'
file = folder.'map.csv'
# Cells of an image have one size: axes in equal ratios are drawn over the decadic logarithm.
x_of(x) = x_log ? log10(x_scale * x) : x_scale * x
y_of(y) = y_log ? log10(y_scale * y) : y_scale * y
region(text) = text eq 'stick' ? -0.75 : text eq 'stick-slip' ? 0.75 : NaN
quantity = quantities > 0
ratio(text) = states_only ? region(text) : text eq '' ? NaN : quantity ? real(text) : log10(real(text))
state_column = quantity ? 3 + 2 * int(quantities) : 4 - int(states_only)
# Whether a cell is left empty.
empty(text) = quantity ? text eq '' : text eq 'no stick state'
stats file using (x_of($1)):(y_of($2)) name 'axis' nooutput
stats file using (empty(strcol(quantity ? 3 : state_column)) ? 1 : 0) name 'buckled' nooutput
limit = 'NaN'
cells = 'NaN'
if (buckled_min == 0) {
  if (quantity) { stats file using (ratio(strcol(3))) name 'shown' nooutput }
  if (!quantity) {
    set contour base
    unset surface
    set cntrparam levels discrete 0
    set table $limit
    splot file using (x_of($1)):(y_of($2)):(ratio(strcol(3)))
    unset contour
    set surface
  }
  # A contour's table has blanks between its columns, so that of the cells gets them, too.
  set table $cells
  plot file using (x_of($1)):(y_of($2)):(ratio(strcol(3))) with table
  unset table
  cells = '$cells using 1:2:3 with image'.(format eq 'tex' && buckled_max > 0 ? ' pixels' : '')  # TikZ takes no NaN in an image
  if (!quantity) { if (!states_only && |$limit| > 4) { limit = '$limit using 1:2' } }  # there are four lines of comment where there is no contour
}
set datafile separator whitespace
unset datafile columnheaders

# Decades have a label, and where there are few of them their 2 and 5, too.
few(axis) = value('axis_max_'.axis) - value('axis_min_'.axis) < 2
label(axis, k, m) = few(axis) ? (m == 1 || m == 2 || m == 5 ? sprintf('%g', m * 10.0**k) : '') : \
                    m == 1 ? sprintf('10^{%d}', k) : ''
if (!x_log) { set xtics x_step(axis_max_x - axis_min_x, width - 13.8 * em) }
if (!y_log) { set ytics y_step(axis_max_y - axis_min_y, height - 8 * em) }
do for [axis in 'x y'] {
  if (value(axis.'_log')) {
    eval sprintf("set %stics ()", axis)
    do for [k = floor(value('axis_min_'.axis)):ceil(value('axis_max_'.axis))] {
      do for [m = 1:9] {
        eval sprintf("set %stics add ('%s' %.15g %d)", axis, label(axis, k, m), k + log10(m), label(axis, k, m) eq '')
      }
    }
  }
}
set format xy '%g'
set tics out
unset grid
set xlabel fitted(x_label, 0.7 * width)
set ylabel fitted(y_label, 0.7 * height)
set xrange [axis_min_x:axis_max_x]
set yrange [axis_min_y:axis_max_y]
if (quantity) {
  set palette defined (0 '#440154', 1 '#3B528B', 2 '#21918C', 3 '#5EC962', 4 '#FDE725')
  set cbrange [*:*]
  set format cb '%.3g'
  if (cells ne 'NaN') { if (shown_min == shown_max) { set cbrange [shown_min - 1:shown_max + 1] } }
  set cblabel fitted(quantity_label, 0.7 * height)
} else {
  eval ratio_palette
  set cbrange [-log10(30):log10(30)]
  set cbtics ('≤ 1/30' -log10(30), '1/10' -1, '1/3' -log10(3), '1' 0, '3' log10(3), '10' 1, '≥ 30' log10(30))
  set cblabel '|f_{max}| / (μ_sP)'
}
set key above horizontal center samplen 3
set rmargin at screen 1 - across(9.5)
set colorbox user origin graph 1.03, graph 0 size screen across(1), graph 1
if (states_only) { unset colorbox; set rmargin -1 }
set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fillcolor rgb grey \
    fillstyle pattern 4 noborder
buckled_title = quantity ? 'no value' : 'no stick state'
# The key leaves room for the title of an empty iteration, so that the command is put together.
curves = 'plot '.cells.' notitle'
if (limit ne 'NaN') { curves = curves.', '.limit." with lines linecolor rgb black linewidth 1.2 title '|f_{max}| = μ_sP'" }
if (states_only) { curves = curves.", keyentry with boxes linecolor rgb '#2171B5' fillstyle solid title 'stick', \
    keyentry with boxes linecolor rgb '#FDCB75' fillstyle solid title 'stick-slip'" }
if (buckled_max > 0) { curves = curves.", keyentry with boxes linecolor rgb grey fillstyle pattern 4 title buckled_title" }
eval curves
