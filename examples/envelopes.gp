# One figure of examples 1 and 2: x and its velocity with one pair of envelopes, as printed and corrected.
# gnuplot -e "csv='file.csv'; svg='file.svg'; name='Ateb'; column=4" examples/envelopes.gp
set terminal svg size 960,360 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set style line 1 lc rgb "#888888" lw 1
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#1f77b4" lw 2
set xlabel "t"
set xrange [0:50]
set yrange [-1.15:1.75]
set grid lc rgb "#dddddd"
set key top right reverse Left samplen 2
set multiplot layout 1,2
set ylabel "x, amplitude"
plot csv using 1:2 with lines ls 1 title "x by rk45", \
     csv using 1:column with lines ls 2 title name." as printed", \
     csv using 1:(-column(column)) with lines ls 2 notitle, \
     csv using 1:column+2 with lines ls 3 title name." corrected", \
     csv using 1:(-column(column+2)) with lines ls 3 notitle
set ylabel "dx/dt, largest velocity"
plot csv using 1:3 with lines ls 1 title "dx/dt by rk45", \
     csv using 1:column+1 with lines ls 2 title name." as printed", \
     csv using 1:(-column(column+1)) with lines ls 2 notitle, \
     csv using 1:column+3 with lines ls 3 title name." corrected", \
     csv using 1:(-column(column+3)) with lines ls 3 notitle
unset multiplot
