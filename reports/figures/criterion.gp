# SPDX-License-Identifier: MIT
# Critical amplitude of a case against the excitation frequency: below the curve the tip sticks, above it slips. The point
# is the case, the dashed lines are the natural frequencies of the stick state.
width = 16
height = 9
load 'style.gp'
values = folder.'criterion-values.csv'
load 'values.gp'
file = folder.'criterion.csv'
set logscale xy
stats file using 1 name 'band' nooutput
set xrange [band_min:band_max] noextend
set format x '%.4g'
set format y '%g'
octaves = log(band_max / band_min) / log(2)
set xtics excitation_frequency / 4.0, width > (octaves + 2) * 5 * em ? 2 : 4
set xlabel 'excitation frequency / Hz'
set ylabel fitted(amplitude_label, 0.7 * height)
stats file using ($2 * amplitude_scale) name 'critical' nooutput
highest = critical_max
if (excitation_amplitude * amplitude_scale > highest) { highest = excitation_amplitude * amplitude_scale }
lowest = critical_min
if (excitation_amplitude > 0 && excitation_amplitude * amplitude_scale < lowest) { lowest = excitation_amplitude * amplitude_scale }
set yrange [lowest / 1.5:highest * 1.5]
set key above horizontal center width -1.5
set style fill solid noborder
plot file using 1:($2 * amplitude_scale):(highest * 2) with filledcurves linecolor rgb slip_fill title 'slips', \
     '' using 1:(lowest / 2):($2 * amplitude_scale) with filledcurves linecolor rgb stick_fill title 'sticks', \
     '' using 1:($2 * amplitude_scale) with lines linecolor rgb black linewidth 1.2 title 'critical amplitude', \
     folder.'criterion-natural.csv' using 1:(lowest / 1.5):(0):(highest / lowest * 10) with vectors nohead linestyle 3 \
         title 'natural frequency', \
     '+' using (excitation_frequency):(excitation_amplitude * amplitude_scale) every ::0::0 with points pointtype 7 pointsize 1 \
         linecolor rgb vermillion title 'this case'
