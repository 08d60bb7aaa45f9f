# SPDX-License-Identifier: MIT
# Orders: natural frequencies in the element length (left, middle), generalised-alpha in the time step (right).
width = 16
height = 8
load 'style.gp'
meshes = folder.'convergence.csv'
steps = folder.'convergence-time.csv'
set logscale xy
set format y '10^{%T}'
set multiplot

set xrange [0.05:0.6]
set yrange [1e-9:1]
set xtics ('1/16' 0.0625, '1/8' 0.125, '1/4' 0.25, '1/2' 0.5)
set xlabel 'element length / m'
set key right bottom samplen 1
do for [state in "stick slip"] {
  left = state eq 'stick' ? 0.105 : 0.365
  set margins screen left, screen left + 0.24, screen 0.155, screen 0.92
  set title sprintf('%s state', state eq 'stick' ? 'Stick' : 'Slip')
  set ylabel (state eq 'stick' ? 'relative error of ω^2' : '')
  set format y (state eq 'stick' ? '10^{%T}' : '')
  plot for [k = 1:3] meshes using (strcol(1) eq state && $2 == k ? $4 : NaN):6 with lines \
         linecolor rgb colours[k] linewidth 1.0 notitle, \
       for [k = 1:3] '' using (strcol(1) eq state && $2 == k ? $4 : NaN):5 with points \
         pointtype shapes[k] pointsize 0.6 linewidth 1.5 linecolor rgb colours[k] title sprintf('mode %d', k)
}

array radii[4] = [0.0, 0.5, 0.9, 1.0]
set margins screen 0.715, screen 0.985, screen 0.155, screen 0.92
set title 'Reaction force'
set xrange [1e-3:6e-2]
set yrange [1e-7:1]
set xtics autofreq format '10^{%T}'
set format y '10^{%T}'
set xlabel 'time step Δt / s'
set ylabel 'largest error / N'
set key samplen 2
plot for [k = 1:4] steps using ($1 == radii[k] ? $2 : NaN):5 with linespoints \
       pointtype (k == 4 ? 2 : shapes[k]) pointsize 0.6 linecolor rgb colours[k] linewidth 1.2 \
       title sprintf('ρ_∞ = %g', radii[k])
