# The figures of the separated pendulum. gnuplot -e "prefix='build/figures/pendulum'" examples/pendulum.gp
set encoding utf8
set datafile separator ","
set terminal svg size 960,420 font "Helvetica,13" background "white"
set output prefix.".svg"
set grid lc rgb "#dddddd"
file(name) = prefix."_".name.".csv"
set multiplot layout 1,2
set title "Fig. 19, every 0.075 s"
set xlabel "x, m"; set ylabel "y (down), m"
set size ratio -1
set xrange [-2:3.6]; set yrange [3:-0.8]
set key top right reverse Left samplen 2
rods(kind) = sprintf("< awk 'BEGIN {RS = \"\"; FS = \"\\n\"} $3 == %d {print $1 \"\\n\" $2 \"\\n\"}' %s", kind, file("motion"))
plot rods(0) using 1:2 with lines lc rgb "#888888" title "before", \
     rods(1) using 1:2 with lines lc rgb "#1f77b4" lw 2 title "what remains", \
     rods(2) using 1:2 with lines lc rgb "#d62728" lw 2 title "the part"
set size noratio
set title "angular velocity of what remains (125), φ' = 1.3"
set xlabel "l/L"; set ylabel "φ_1', rad/s"
set xrange [0:0.5]; set yrange [-11:3]
set key bottom left
plot file("rate") using 1:2 with lines lc rgb "#1f77b4" lw 2 title "u = (0.4, -0.25), Ω = 0.6", \
     "" using 1:3 with lines lc rgb "#d62728" lw 2 dt 2 title "the same, as printed", \
     "" using 1:4 with lines lc rgb "#2ca02c" lw 2 title "u = 0, Ω = 3", \
     "" using 1:5 with lines lc rgb "#ff7f0e" lw 2 dt 2 title "the same, as printed"
unset multiplot
