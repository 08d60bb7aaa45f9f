# SPDX-License-Identifier: MIT
# Fig. 10: largest static friction force over frequency and amplitude, with the plane mu_s P and the excitations
# A to D.
width = 16
height = 11
load 'style.gp'
values = folder.'fig10-values.csv'
load 'values.gp'
points = folder.'fig10-points.csv'
set xlabel 'excitation frequency / Hz' rotate parallel offset 0, -0.5
set ylabel 'excitation amplitude A_0 / mm' rotate parallel offset 0, -0.5
set zlabel '|f_{max}| / N' rotate parallel offset 0.5
set xrange [0:120]
set yrange [0:1]
set zrange [0.1:3e5]
set logscale z
set format z '10^{%T}'
set xtics 20 offset 0, -0.3
set ytics 0.25 offset 0, -0.3
set ztics 10
set xyplane at 0.1
set view 62, 28, 1.12, 1.0
set border 31
set hidden3d front
set samples 13
set isosamples 11
set key at screen 0.97, screen 0.955 right width -2
splot folder.'fig10.csv' using 1:(1e3 * $2):3 with lines linecolor rgb blue linewidth 0.5 \
        title '|f_{max}|, closed form', \
      limit with lines linecolor rgb vermillion linewidth 0.8 title sprintf('μ_sP = %g N', limit), \
      points using 2:(1e3 * $3):($4 > limit ? $4 : NaN) with points pointtype 7 pointsize 0.7 \
        linecolor rgb black nohidden3d title 'over the plane', \
      points using 2:(1e3 * $3):($4 > limit ? NaN : $4) with points pointtype 6 pointsize 0.7 linewidth 1.5 \
        linecolor rgb black nohidden3d title 'under the plane', \
      points using 2:(1e3 * $3):($4 * 2.2):1 with labels font ',9' nohidden3d notitle
