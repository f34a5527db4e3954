# The rocket with the nozzle off its axis: how it tilts and where it flies.
# gnuplot -e "csv='file.csv'; svg='file.svg'" examples/rocket.gp
set terminal svg size 960,400 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set style line 1 lc rgb "#1f77b4" lw 2
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#888888" lw 2 dt 3
set style line 4 lc rgb "#2ca02c" lw 2
set grid lc rgb "#dddddd"
set key top left Left reverse samplen 2
set multiplot layout 1,2
set xlabel "t (s)"
set ylabel "tilt (degrees)"
set xrange [0:10]
set yrange [0:90]
plot csv using 1:2 with lines ls 1 title "no spin", \
     csv using 1:3 with lines ls 2 title "(155), (157) as printed", \
     csv using 1:4 with lines ls 3 title "without jet damping", \
     csv using 1:7 with lines ls 4 title "a turn a second"
set xlabel "aside (km)"
set ylabel "height (km)"
set xrange [-0.5:10]
set yrange [0:30]
set key bottom right
plot csv using (-$5):6 with lines ls 1 title "no spin", \
     csv using (-$8):9 with lines ls 4 title "a turn a second"
unset multiplot
