# The figures of the broken rotor. gnuplot -e "prefix='build/figures/rotor'; figure='break'" examples/rotor.gp
set encoding utf8
set datafile separator ","
set style line 1 lc rgb "#888888" lw 1.5
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#1f77b4" lw 2
set style line 4 lc rgb "#2ca02c" lw 2 dt 4
set grid lc rgb "#dddddd"
set output prefix."_".figure.".svg"
file(name) = prefix."_".name.".csv"

if (figure eq "break") {
    set terminal svg size 1180,400 font "Helvetica,13" background "white"
    set multiplot
    set size 0.44,1; set origin 0,0
    stats file("vectors") using 1:2 every ::0::0 nooutput
    Sx = STATS_min_x; Sy = STATS_min_y
    stats file("vectors") using 1:2 every ::1::1 nooutput
    S2x = STATS_min_x; S2y = STATS_min_y
    stats file("vectors") using 1:2 every ::5::5 nooutput
    Ax = STATS_min_x; Ay = STATS_min_y
    set size ratio -1
    set title "Fig. 17: velocities at the break (1 m/s = 0.5 m)"
    set xlabel "x, m"; set ylabel "y, m"
    set xrange [-1.2:3.4]; set yrange [-1.8:1]
    set object 1 circle at Sx,Sy size 1 fillstyle empty border lc rgb "#888888"
    set label 1 "S" at Sx-0.16,Sy
    set label 2 "S_2" at S2x-0.02,S2y-0.1
    set label 3 "A" at Ax+0.05,Ay-0.06 point pt 7 ps 0.6
    set key inside right center reverse Left samplen 1.5
    plot file("orbit") using 2:3 with lines lc rgb "#bbbbbb" title "orbit of S", \
         file("vectors") using 1:2:3:4 every ::0::0 with vectors lc rgb "#888888" lw 2 title "v of S", \
         "" using 1:2:3:4 every ::1::1 with vectors lc rgb "#000000" lw 2 title "v of S_2, before", \
         "" using 1:2:3:4 every ::2::2 with vectors lc rgb "#1f77b4" lw 2 title "N: v of S_2, after", \
         "" using 1:2:3:4 every ::3::3 with vectors lc rgb "#d62728" lw 2 title "T: lost (57)", \
         "" using 1:2:3:4 every ::4::4 with vectors lc rgb "#2ca02c" lw 2 title "v of S_1, after"
    unset object 1; unset label 1; unset label 2; unset label 3
    set size noratio; set size 0.28,1; set origin 0.44,0
    set title "speed of S, after (52)"
    set xlabel "t, s"; set ylabel "v_{Sb}, m/s"
    set xrange [0:4]; set yrange [0.3:1]
    set key top right reverse Left samplen 2
    plot file("orbit") using 1:5 with lines ls 2 title "printed", "" using 1:4 with lines ls 3 title "corrected"
    set origin 0.72,0
    set title "spin of the remainder (59)"
    set key top center
    set xlabel "α, rad"; set ylabel "Ω_{1a}, rad/s"
    set xrange [-3:3]; set yrange [1.4:2.4]
    plot file("spin") using 1:3 with lines ls 2 title "printed", "" using 1:2 with lines ls 3 title "corrected"
    unset multiplot
}
if (figure eq "transient") {
    set terminal svg size 960,360 font "Helvetica,13" background "white"
    set multiplot layout 1,2
    set xlabel "t after the break, s"
    set key bottom left reverse Left samplen 2
    set ylabel "y of S_1, m"
    plot file("transient") using 1:2 with lines ls 1 title "(68) by rk45", \
         "" using 1:4 with lines ls 3 title "(69)", "" using 1:6 with lines ls 4 title "(71): (69) uncoupled", \
         "" using 1:8 with lines ls 2 title "(73) as printed"
    set key top left
    set yrange [0.4:3]
    set ylabel "dψ/dt, rad/s"
    plot file("transient") using 1:3 with lines ls 1 title "(68) by rk45", \
         "" using 1:5 with lines ls 3 title "(69)", "" using 1:7 with lines ls 4 title "(72): (69) uncoupled", \
         "" using 1:9 with lines ls 2 title "(74) as printed"
    unset multiplot
}
if (figure eq "fig18") {
    set terminal svg size 960,360 font "Helvetica,13" background "white"
    set multiplot layout 1,2
    set xlabel "t"; set ylabel "r of S_1"
    set key top left reverse Left samplen 2
    set xrange [0:40]; set yrange [0:4.5]
    plot file("fig18") every ::0::400 using 1:4 with lines lc rgb "#d62728" lw 2 title "Ω = 2.5", \
         "" every ::0::400 using 1:3 with lines lc rgb "#ff7f0e" lw 2 title "Ω = 1", \
         "" every ::0::400 using 1:2 with lines lc rgb "#1f77b4" lw 2 title "Ω = 0.625", 0.8205128 ls 1 title "r_{SS}, (77)"
    set xrange [0:400]; set yrange [0:14]
    plot file("fig18") using 1:4 every 5 with lines lc rgb "#d62728" lw 2 title "Ω = 2.5", \
         "" using 1:6 every 20 with lines lc rgb "#000000" lw 1 dt 2 title "laws of growth", \
         "" using 1:3 every 5 with lines lc rgb "#ff7f0e" lw 2 title "Ω = 1", \
         "" using 1:5 every 20 with lines lc rgb "#000000" lw 1 dt 2 notitle, \
         "" using 1:2 every 5 with lines lc rgb "#1f77b4" lw 2 title "Ω = 0.625"
    unset multiplot
}
