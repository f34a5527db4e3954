# The drum on which a band winds up: rigid shaft above, elastic shaft below, as printed and as it is.
# gnuplot -e "csv='file.csv'; svg='file.svg'" examples/drum.gp
set terminal svg size 960,720 font "Helvetica,13" background "white"
set output svg
set encoding utf8
set datafile separator ","
set style line 1 lc rgb "#1f77b4" lw 2
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#2ca02c" lw 2
set style line 4 lc rgb "#888888" lw 2
set style line 5 lc rgb "#9467bd" lw 2
set style line 6 lc rgb "#ff7f0e" lw 2
set grid lc rgb "#dddddd"
set key top left reverse Left samplen 2
set multiplot layout 2,2
set title "rigid shaft: angular velocity (196)"
set xlabel "φ, rad"
set ylabel "dφ/dt, rad/s"
set xrange [0:7.5]
set yrange [0:7]
plot csv index 0 using 1:14 with lines ls 6 title "e = 0.9", \
     csv index 0 using 1:11 with lines ls 5 title "0.6 = j Ω_b", \
     csv index 0 using 1:8 with lines ls 3 title "0.3", \
     csv index 0 using 1:5 with lines ls 4 title "0", \
     csv index 0 using 1:2 with lines ls 1 title "-0.4, stops at 7.5"
set title "rigid shaft: angle (206), and (199) as printed"
set xlabel "t, s"
set ylabel "φ, rad"
set xrange [0:10]
set yrange [0:9]
set key bottom right
plot csv index 0 using 15:1 with lines ls 6 title "e = 0.9", \
     csv index 0 using 9:1 with lines ls 3 title "0.3", \
     csv index 0 using 3:1 with lines ls 1 title "-0.4", \
     csv index 0 using ($16 >= 0 ? $16 : 1/0):1 with lines ls 2 lc rgb "#ff7f0e" title "0.9, (199) as printed", \
     csv index 0 using 10:1 with lines ls 2 lc rgb "#2ca02c" title "0.3, (199) as printed"
set title "elastic shaft: mass centre S_1"
set ylabel "x, y of S_1, mm"
set xrange [0:2.5]
set yrange [-60:210]
set key top left
plot csv index 1 using 1:(1e3*$2) with lines ls 1 title "x, exact", \
     csv index 1 using 1:(1e3*$4) with lines ls 2 lc rgb "#1f77b4" title "x, (191) as printed", \
     csv index 1 using 1:(1e3*$3) with lines ls 3 title "y, exact", \
     csv index 1 using 1:(1e3*$5) with lines ls 2 lc rgb "#2ca02c" title "y, (191) as printed"
set title "elastic shaft: deflection over the first layer"
set xlabel "φ, rad"
set ylabel "y, mm"
set xrange [0:6.28]
set yrange [-13:22]
plot csv index 2 using 1:(1e3*$2) with lines lc rgb "#cccccc" lw 5 title "integrated (211)", \
     csv index 2 using 1:(1e3*$3) with lines ls 1 title "(224) corrected", \
     csv index 2 using 1:(1e3*$4) with lines ls 2 title "(224) as printed"
unset multiplot
