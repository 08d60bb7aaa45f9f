# SPDX-License-Identifier: MIT
# Fig. 2: the friction law, coefficient (a) and force on the beam (b) against the sliding velocity.
width = 16
height = 6.5
load 'style.gp'
values = folder.'fig2-values.csv'
load 'values.gp'
file = folder.'fig2.csv'
highest = static_coefficient * axial_force
lowest = kinetic_coefficient * axial_force
set xrange [-5:5]
set xtics 2.5
set xlabel 'sliding velocity v_s / m s^{−1}'
unset key
set multiplot layout 1, 2 margins 0.085, 0.98, 0.185, 0.90 spacing 0.15, 0.1
set title '(a) friction coefficient'
set ylabel 'friction coefficient μ' offset 1
set yrange [0:0.8]
set ytics 0.2
set arrow 1 from -5, kinetic_coefficient to 5, kinetic_coefficient nohead linestyle 3 back
set arrow 2 from 0, static_coefficient to 5, static_coefficient nohead linestyle 3 back
set label 1 sprintf('μ_s = %g', static_coefficient) at 4.8, static_coefficient + 0.035 right
set label 2 sprintf('μ_m = %g', kinetic_coefficient) at 4.8, kinetic_coefficient - 0.04 right
plot file using 1:2 with lines linestyle 1
set title '(b) friction force on the beam'
set ylabel 'friction force f_d / N' offset -0.5
set yrange [-400:400]
set ytics 200
set arrow 1 from -5, lowest to 5, lowest nohead linestyle 3 back
set arrow 2 from 0, highest to 5, highest nohead linestyle 3 back
set arrow 3 from -5, -lowest to 5, -lowest nohead linestyle 3 back
set arrow 4 from -5, -highest to 0, -highest nohead linestyle 3 back
set label 1 sprintf('μ_sP = %g N', highest) at 4.8, highest + 35 right
set label 2 sprintf('μ_mP = %g N', lowest) at 4.8, lowest + 35 right
set label 3 sprintf('−μ_sP = −%g N', highest) at -4.8, -highest - 40 left
set label 4 sprintf('−μ_mP = −%g N', lowest) at -4.8, -lowest - 40 left
set label 5 'sticks: |f_d| ≤ μ_sP' at -0.25, 0 right
plot file using 1:3 with lines linestyle 1
unset multiplot
