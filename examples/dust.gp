# The spinning body that gathers dust, and the one that dust turns.
# gnuplot -e "csv='file.csv'; svg='file.svg'" examples/dust.gp
set terminal svg size 960,400 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set style line 1 lc rgb "#1f77b4" lw 2
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#2ca02c" lw 2
set style line 4 lc rgb "#888888" lw 2 dt 3
set style line 5 lc rgb "black" pt 6 ps 0.6
set grid lc rgb "#dddddd"
set key top right samplen 2
set multiplot layout 1,2
set xlabel "t (min)"
set ylabel "of the first value"
set xrange [0:10]
set yrange [0:1.1]
plot csv using 1:($2/2) with lines ls 1 title "spin", \
     csv using 1:($3/0.2) with lines ls 3 title "wobble", \
     csv using 1:6 with lines ls 4 title "kinetic energy", \
     csv every 10 using 1:($4/2) with points ls 5 title "closed form", \
     csv every 10 using 1:($5/0.2) with points ls 5 notitle
set xlabel "t (s)"
set ylabel "angular velocity (rad/s)"
set xrange [0:60]
set yrange [*:*]
set key top left Left reverse
plot csv using ($1*6):7 with lines ls 1 title "dust on one end", \
     csv using ($1*6):8 with lines ls 2 title "(168) as printed"
unset multiplot
