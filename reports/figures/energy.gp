# Energy that the books do not explain, over the base work, against the step.
width = 15
height = 7.5
load 'style.gp'
file = folder.'energy.csv'
set logscale xy
set format xy '10^{%T}'
set xrange [4e-7:4e-5]
set yrange [1e-15:1e-3]
set xlabel 'time step Δt / s'
set ylabel 'unexplained energy / base work' offset 1
set key outside right center reverse Left samplen 1.5
share(elements, damped) = ($1 > 0) == damped && $2 == elements ? abs($4/$5) : NaN
plot file using 3:(share(10, 1)) with linespoints linecolor rgb blue pointtype 7 pointsize 0.5 \
       title 'damped, 10 elements', \
     '' using 3:(share(5, 0)) with linespoints linecolor rgb green pointtype 9 pointsize 0.5 \
       title 'undamped, 5 elements', \
     '' using 3:(share(10, 0)) with linespoints linecolor rgb vermillion pointtype 5 pointsize 0.5 \
       title 'undamped, 10 elements', \
     '' using 3:(share(20, 0)) with linespoints linecolor rgb purple pointtype 13 pointsize 0.5 \
       title 'undamped, 20 elements', \
     '' using ($1 > 0 ? $3 : NaN):(abs($6/$5)) with lines linecolor rgb black linewidth 1.0 \
       title 'event-driven, damped', \
     '' using ($1 == 0 && $2 == 10 ? $3 : NaN):(abs($6/$5)) with lines linecolor rgb black linewidth 1.0 \
       dashtype 2 title 'event-driven, undamped'
