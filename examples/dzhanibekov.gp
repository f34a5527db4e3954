# The wing nut that turns over: omega_y by the closed form and by rk45, and the errors of rk45's attitude.
# gnuplot -e "csv='dzhanibekov.csv'; svg='dzhanibekov.svg'" examples/dzhanibekov.gp
set terminal svg size 960,540 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set style line 1 lc rgb "#1f77b4" lw 3
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#2ca02c" lw 2 dt 4
set grid lc rgb "#dddddd"
set xrange [0:40]
set lmargin 11
set multiplot layout 2,1
set ylabel "omega_y, rad/s"
set yrange [-12:17]
set key top right horizontal reverse Left samplen 3
plot csv using 1:2 with lines ls 1 title "closed form", \
     csv using 1:3 with lines ls 2 title "rk45 to 1e-3", \
     csv using 1:4 with lines ls 3 title "rk45 to 1e-8"
set xlabel "t, s"
set ylabel "error of attitude, rad"
set yrange [1e-10:10]
set logscale y
set format y "10^{%L}"
set key bottom right
plot csv using 1:5 with lines ls 2 title "rk45 to 1e-3", \
     csv using 1:6 with lines ls 3 title "rk45 to 1e-8"
unset multiplot
