# The kill matrix: a dot for each test that fails on a curated mutant. Tests in the order of their kind.
width = 16
height = 13
load 'style.gp'
values = folder.'mutants-values.csv'
load 'values.gp'
unset grid
set xlabel 'curated mutant'
set ylabel 'test'
set xrange [0.5:mutants + 0.5]
set yrange [tests + 0.5:0.5]
set tics out
unset key
set margins screen 0.085, screen 0.925, screen 0.09, screen 0.985
unset ytics
array kinds[4] = ['unit', 'order', 'paper', 'cross']
array ends[4] = [unit_end, order_end, paper_end, cross_end]
begin = 0
do for [i = 1:4] {
  set label i kinds[i] at graph 1.012, first 0.5 * (begin + ends[i]) left
  if (i < 4) {
    set arrow i from graph 0, first ends[i] + 0.5 to graph 1, first ends[i] + 0.5 nohead \
        linecolor rgb grey linewidth 0.6
  }
  begin = ends[i]
}
plot folder.'mutants.csv' using 1:2 with points pointtype 5 pointsize 0.11 linecolor rgb blue
