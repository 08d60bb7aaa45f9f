# Separation of undamped histories, largest per period of the load.
width = 16
height = 10.5
load 'style.gp'
values = folder.'predictability-values.csv'
load 'values.gp'
file = folder.'predictability.csv'
array hz[2] = [hz1, hz2]
array range[2] = [range1, range2]
array titles[10]
do for [k = 1:10] {
  stats file using ($2 == k ? (what = strcol(3), $5) : NaN) nooutput
  titles[k] = what
}
array colours[10] = [black, blue, purple, green, grey, vermillion, '#E69F00', '#56B4E9', '#7A5195', '#A05A2C']
array shapes[10] = [7, 5, 9, 11, 13, 4, 6, 8, 10, 12]
set logscale y
set yrange [1e-13:1e-1]
set format y '10^{%T}'
set xrange [0:0.5]
set xtics 0.1
set xlabel 'time t / s'
set multiplot
do for [j = 1:2] {
  left = 0.105 + 0.475 * (j - 1)
  set lmargin at screen left
  set rmargin at screen left + 0.39
  set tmargin at screen 0.935
  set bmargin at screen 0.33
  set title sprintf('%d Hz', hz[j]) offset 0, -0.6
  if (j == 1) { set ylabel 'difference of y(L) / m' offset 0.5 } else { unset ylabel }
  if (j == 1) { set key at screen 0.5, 0.01 center bottom maxrows 5 vertical reverse Left samplen 1.5 font typeface.',7' } else { unset key }
  plot 0.01 * range[j] with lines linestyle 3 notitle, \
       0.1 * range[j] with lines linestyle 3 notitle, \
       for [k = 1:10] file using ($1 == hz[j] && $2 == k ? $4 : NaN):5 with linespoints \
         pointtype shapes[k] pointsize 0.4 linecolor rgb colours[k] linewidth 0.8 title titles[k]
}
unset multiplot
