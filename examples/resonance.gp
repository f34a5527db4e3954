# The three figures of examples/resonance.c.
# gnuplot -e "folder='build/figures'" examples/resonance.gp
set terminal svg size 860,360 font "Helvetica,13" background "white"
set datafile separator ","
set style line 1 lc rgb "#888888" pt 7 ps 0.25
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#1f77b4" lw 2
set style line 4 lc rgb "#333333" lw 1 dt 3
set grid lc rgb "#dddddd"

csv = folder."/resonance_curve.csv"
set output folder."/resonance.svg"
set key top left reverse Left samplen 2
set xlabel "frequency of the force"
set ylabel "amplitude"
set yrange [0:2]
set xrange [0.4:1.5]
set multiplot layout 1,2
do for [sweep=0:1] {
    set title sweep ? "sweep down" : "sweep up"
    plot csv index 2+sweep using 1:2 every 4 with points ls 1 title "turning points, rk45", \
         for [branch=0:1] csv index branch using 1:($3 == 1 ? $2 : NaN) every 3 with lines ls 3 title (branch ? "" : "averaged, stable"), \
         for [branch=0:1] csv index branch using 1:($3 == 0 ? $2 : NaN) every 3 with lines ls 2 title (branch ? "" : "unstable")
}
unset multiplot

csv = folder."/resonance_passage.csv"
set output folder."/passage.svg"
set xlabel "t"
set yrange [0:3.5]
set xrange [0:2000]
set multiplot layout 1,2
do for [weak=0:1] {
    set title weak ? "a weak force: passage" : "a strong one: capture, release"
    plot csv index 2*weak+1 using 1:2 every 3 with points ls 1 title "turning points, rk45", \
         csv index 2*weak using 1:2 with lines ls 3 title "averaged", \
         csv index 2*weak using 1:3 with lines ls 4 title "backbone w(A) = nu"
}
unset multiplot

csv = folder."/resonance_periodic.csv"
set output folder."/two_harmonics.svg"
set terminal svg size 760,440 font "Helvetica,13" background "white"
unset title
set key at graph 0.03,0.97 top left reverse Left samplen 3
set xlabel "frequency of the force nu (rad/s)"
set ylabel "amplitude A (m)"
set xrange [0.2:1.6]
set yrange [0:2.4]
set style line 5 lc rgb "#888888" pt 7 ps 0.5
set style line 6 lc rgb "black" lw 2
set style line 7 lc rgb "black" lw 2 dt 2
set style line 8 lc rgb "black" lw 1 dt 3
set label 1 "2 vibrations\nin a period" at 0.57,1.2 left
set label 2 "1 vibration\nin a period" at 1.39,1.42 left
plot for [peak=0:1] csv index 3*peak+2 using 1:2 every 6 with points ls 5 title (peak ? "" : "integration, nu rises"), \
     for [peak=0:1] csv index 3*peak using 1:($3 == 1 ? $2 : NaN) with lines ls 6 title (peak ? "" : "averaged, stable"), \
     for [peak=0:1] csv index 3*peak using 1:($3 == 0 ? $2 : NaN) with lines ls 7 title (peak ? "" : "averaged, unstable"), \
     for [peak=0:1] csv index 3*peak+1 using 1:2 with lines ls 8 title (peak ? "" : "backbone w(A) = nu, w(A) = 2 nu")
