# Energy that the books of the time stepper do not explain, over the base work, against the step.
width = 10
height = 7
load 'style.gp'
file = folder.'energy.csv'
set logscale xy
set format xy '10^{%T}'
set xrange [2e-6:3e-5]
set xlabel 'time step Δt / s'
set ylabel 'unexplained energy / base work' offset 1
set key right bottom reverse Left
plot file using ($1 > 0 ? $2 : NaN):(abs($3/$4)) with linespoints linecolor rgb blue pointtype 7 pointsize 0.5 \
       title 'damped', \
     '' using ($1 == 0 ? $2 : NaN):(abs($3/$4)) with linespoints linecolor rgb vermillion pointtype 5 \
       pointsize 0.5 title 'undamped', \
     '' using ($1 > 0 ? $2 : NaN):(abs($5/$4)) with lines linecolor rgb black linewidth 1.0 \
       title 'event-driven (no step), damped', \
     '' using ($1 == 0 ? $2 : NaN):(abs($5/$4)) with lines linecolor rgb black linewidth 1.0 dashtype 2 \
       title 'event-driven, undamped'
