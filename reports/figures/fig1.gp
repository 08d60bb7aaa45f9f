# SPDX-License-Identifier: MIT
# Fig. 1: the model with the numbers of its case. A drawing that is not to scale.
width = 16
height = 7
load 'style.gp'
values = folder.'fig1-values.csv'
load 'values.gp'
unset border
unset tics
unset grid
unset key
set xrange [-0.46:1.36]
set yrange [-0.52:0.5]
set margins 0, 0, 0, 0
lift = 0.14                                        # h(t)
deflection(x) = -0.5 * lift * x**2 * (3 - x) - 0.9 * x**2 * (1 - x)
shape(x) = x < 0 || x > 1 ? NaN : lift + deflection(x)
set style line 5 linecolor rgb black linewidth 0.9
set style arrow 1 head filled size screen 0.012, 18 linestyle 5 front
set style arrow 2 heads filled size screen 0.012, 18 linestyle 5
set style arrow 3 head filled size screen 0.016, 18 linecolor rgb vermillion linewidth 2.5 front
# At rest: base and axis.
set arrow from -0.45, 0 to 1.0, 0 nohead linestyle 3 linewidth 1.6
set label "axis at rest" at -0.45, -0.04 left
# The base, moved by h.
set object 1 rectangle from -0.12, lift - 0.2 to 0, lift + 0.2 fillstyle solid border rgb black fillcolor rgb '#BBBBBB'
set label "rigid base" at -0.06, lift + 0.24 center
# The wall, on which the tip rubs.
set object 2 rectangle from 1.003, -0.36 to 1.08, 0.4 fillstyle pattern 5 border rgb black fillcolor rgb grey
set label sprintf("fixed wall\nμ_s = %g\nμ_m = %g\nα = %g s/m\nμ_s P = %g N", static_coefficient, kinetic_coefficient, decay, limit) at 1.1, 0.16 left
set label sprintf("beam: EI = %.0f N m^2, ρA = %g kg/m", stiffness, mass) at 0.2, 0.21 left
set arrow from -0.45, lift to -0.125, lift arrowstyle 3
set label sprintf("axial force\nP = %g N", axial_force) at -0.45, lift + 0.12 left
set arrow from -0.15, 0 to -0.15, lift - 0.012 arrowstyle 1
set label 'h = A_0 sin Ωt' at -0.165, 0.45 * lift right
set arrow from 0.25, 0 to 0.25, shape(0.25) - 0.018 arrowstyle 1
set label 'y(x, t)' at 0.235, 0.05 right
set arrow from 0.70, lift to 0.70, shape(0.70) + 0.018 arrowstyle 1
set label 'u(x, t)' at 0.715, 0.07 left
set arrow from 0, lift to 1, lift nohead linecolor rgb grey linewidth 1.8 dashtype 3
set arrow from 0.975, 0.04 to 0.975, 0.26 arrowstyle 1
set label 'tip slides with v_s' at 0.97, 0.3 right
set arrow from 0.975, -0.04 to 0.975, -0.27 arrowstyle 3
set label 'friction force f_d' at 0.95, -0.23 right
set arrow from 0, -0.42 to 1, -0.42 arrowstyle 2
set label sprintf('L = %g m', length) at 0.5, -0.465 center
set arrow from 0, -0.3 to 0.25, -0.3 arrowstyle 1
set label 'x' at 0.27, -0.3 left
set samples 200
plot sample [0:1] "+" using 1:(shape($1)) with lines linecolor rgb blue linewidth 4
