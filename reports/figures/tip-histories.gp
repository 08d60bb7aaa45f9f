# Four tip histories. Panel i has hz<i>, trusted<i> (s) and slips<i>; what follows trusted<i> is drawn pale.
width = 16
height = 10
load 'style.gp'
load 'values.gp'
array hz[4] = [hz1, hz2, hz3, hz4]
array trusted[4] = [trusted1, trusted2, trusted3, trusted4]
array slips[4] = [slips1, slips2, slips3, slips4]
set xrange [0:shown]
set xtics 0.1
unset key
set multiplot layout 2, 2 margins 0.10, 0.98, 0.125, 0.945 spacing 0.085, 0.15
do for [i = 1:4] {
  set title sprintf('(%s) %g Hz', 'abcd'[i:i], hz[i]) offset 0, -0.6
  set xlabel (i > 2 ? 'time t / s' : '')
  set ylabel (i % 2 == 1 ? 'y(L, t) / mm' : '') offset 1
  set ytics autofreq
  unset label
  unset arrow
  if (slips[i]) {
    set autoscale y
    set arrow from trusted[i], graph 0 to trusted[i], graph 1 nohead linestyle 3 back
  } else {
    set yrange [-1:1]
    set label 'sticks throughout' at graph 0.5, 0.6 center
  }
  plot file using 1:(1e3 * column(i + 1)) with lines linecolor rgb pale linewidth 1.0, \
       '' using ($1 <= trusted[i] ? $1 : NaN):(1e3 * column(i + 1)) with lines linestyle 1
}
unset multiplot
