# SPDX-License-Identifier: MIT
# Critical amplitude by finite elements and in other models (rows) over that of the closed form: outside the domain of the margin over the
# line of a row, inside under it, with the largest fall. Cases beyond the axis stand on its ends.
width = 16
height = 7
load 'style.gp'
file = folder.'domain.csv'
stats file using 2 name 'rows' nooutput
cases = int(rows_records / (rows_max + 1))
two_digits_up(x) = x < 10 ? ceil(10 * x) / 10.0 : ceil(x)
do for [row = 0:int(rows_max)] {
  stats file every ::(row * cases)::((row + 1) * cases - 1) using ($5 > 0 ? $4 : NaN) name 'inside' nooutput
  fall = two_digits_up(100 * (1 - inside_min))
  if (fall > 0) { set label sprintf('−%g %%', fall) at inside_min, row + 0.23 right offset -1, 0 front }
}
set logscale x
set xrange [0.18:5.5]
set xtics ('0.2' 0.2, '0.5' 0.5, '0.8' 0.8, '1' 1, '1.25' 1.25, '2' 2, '5' 5)
set yrange [rows_max + 0.55:-0.55]
set xlabel 'critical amplitude over that of the closed form' offset 0, 0.4
set ytics scale 0
unset grid
set grid xtics
set key above horizontal center samplen 1
set arrow 1 from 1, graph 0 to 1, graph 1 nohead linecolor rgb black linewidth 0.8 back
shown(x) = x < 0.2 ? 0.2 : x > 5 ? 5 : x
at(row, n) = row + 0.35 * (n * 0.6180339887 - floor(n * 0.6180339887)) + (column(5) == 0 ? -0.4 : 0.05)
of(place, x) = column(5) == place ? shown(x) : NaN
plot file every cases using (1):2:ytic(1) with dots linecolor rgb 'white' notitle, \
     '' using (of(0, $4)):(at($2, $3)) with points pointtype 6 pointsize 0.25 linecolor rgb '#999999' title 'outside', \
     '' using (of(1, $4)):(at($2, $3)) with points pointtype 7 pointsize 0.3 linecolor rgb blue title 'in the domain of the margin', \
     '' using (of(2, $4)):(at($2, $3)) with points pointtype 2 pointsize 0.6 linecolor rgb black linewidth 1.5 title 'at its corners'
