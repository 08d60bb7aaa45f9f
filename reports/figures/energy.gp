# SPDX-License-Identifier: MIT
# Energy that the balance does not explain, over the base work, against the step.
width = 16
height = 7
load 'style.gp'
values = folder.'energy-values.csv'
load 'values.gp'
file = folder.'energy.csv'
set logscale xy
set format xy '10^{%T}'
set xrange [4e-7:4e-5]
set yrange [1e-11:1e-2]
set ytics 100
set xlabel 'time step Δt / s'
set ylabel '|unexplained energy| over base work' offset -0.5
set key left top
array elements[3] = [undamped_elements1, undamped_elements2, undamped_elements3]
share(elements, damped) = ($1 > 0) == damped && $2 == elements ? abs($4/$5) : NaN
plot for [k = 3:1:-1] file using 3:(share(elements[k], 0)) with linespoints linecolor rgb colours[k + 1] \
       linewidth 1.2 dashtype 2 pointtype shapes[k + 1] pointsize 0.7 title sprintf('undamped, %d elements', elements[k]), \
     '' using 3:(share(damped_elements, 1)) with linespoints linecolor rgb blue pointtype 7 pointsize 0.5 \
       title sprintf('damped, %d elements', damped_elements)
