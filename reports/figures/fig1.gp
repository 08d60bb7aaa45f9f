# SPDX-License-Identifier: MIT
# Fig. 1: the model. A drawing that is not to scale; no data.
width = 16
height = 7
load 'style.gp'
unset border
unset tics
unset grid
unset key
set xrange [-0.42:1.38]
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
set arrow from -0.36, 0 to 1.0, 0 nohead linestyle 3
set label "axis at rest" at -0.36, -0.04 left
# The base, moved by h.
set object 1 rectangle from -0.12, lift - 0.2 to 0, lift + 0.2 fillstyle solid border rgb black fillcolor rgb '#BBBBBB'
set label "rigid base" at -0.06, lift + 0.24 center
# The wall, on which the tip rubs.
set object 2 rectangle from 1.003, -0.36 to 1.08, 0.4 fillstyle pattern 5 border rgb black fillcolor rgb grey
set label "fixed wall\nwith friction\nμ_s, μ_m, α" at 1.1, 0.1 left
set label "beam: E, I, ρ, A" at 0.30, 0.21 left
set arrow from -0.36, lift to -0.125, lift arrowstyle 3
set label "axial\nforce P" at -0.36, lift + 0.1 left
set arrow from -0.2, 0 to -0.2, lift - 0.012 arrowstyle 1
set label 'h(t)' at -0.215, 0.45 * lift right
set arrow from 0.25, 0 to 0.25, shape(0.25) - 0.018 arrowstyle 1
set label 'y(x, t)' at 0.235, 0.05 right
set arrow from 0.70, lift to 0.70, shape(0.70) + 0.018 arrowstyle 1
set label 'u(x, t)' at 0.715, 0.07 left
set arrow from 0, lift to 1, lift nohead linecolor rgb grey linewidth 0.8 dashtype 3
set arrow from 0.975, 0.04 to 0.975, 0.26 arrowstyle 1
set label 'tip slides with v_s' at 0.97, 0.3 right
set arrow from 0.975, -0.04 to 0.975, -0.27 arrowstyle 3
set label 'friction force f_d' at 0.95, -0.23 right
set arrow from 0, -0.42 to 1, -0.42 arrowstyle 2
set label 'L' at 0.5, -0.465 center
set arrow from 0, -0.3 to 0.25, -0.3 arrowstyle 1
set label 'x' at 0.27, -0.3 left
set samples 200
plot sample [0:1] "+" using 1:(shape($1)) with lines linecolor rgb blue linewidth 4
