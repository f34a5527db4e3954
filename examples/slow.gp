# One of Figs 21, 26-30, 32 from the CSV file of examples/slow.c: a row of panels, of so many cases each.
# gnuplot -e "csv='f.csv'; svg='f.svg'; panels=3; cases=1; waves=1; low=-2; high=2; label='x'" examples/slow.gp
# waves: 1 draws the motion and both branches of its curves, 2 the motion broad, 0 the upper branches and the turning
# points
set terminal svg size 400*panels+60,360 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set style line 1 lc rgb (waves == 2 ? "#bbbbbb" : "#888888") lw (waves == 2 ? 5 : 1)
set style line 2 lc rgb "#d62728" lw 2 dt 2
set style line 3 lc rgb "#1f77b4" lw (waves == 2 ? 1 : 2)
set xlabel "t"
set ylabel label
set yrange [low:high]
set grid lc rgb "#dddddd"
if (waves) { set key top right reverse Left samplen 2 } else { set key top left reverse Left samplen 2 } # where no curve is
thin = waves == 2 ? 1 : 10 # the curves are smooth: one point in so many is drawn
set multiplot layout 1,panels
do for [p=0:panels-1] {
    if (waves) {
        plot csv index 2*p using 1:2 with lines ls 1 title columnheader(2), \
             csv index 2*p using 1:3 skip 1 every thin with lines ls 2 title "as printed", \
             csv index 2*p using 1:4 skip 1 every thin with lines ls 2 notitle, \
             csv index 2*p using 1:5 skip 1 every thin with lines ls 3 title "corrected", \
             csv index 2*p using 1:6 skip 1 every thin with lines ls 3 notitle
    } else {
        plot for [c=0:cases-1] csv index 2*(p*cases+c)+1 using 1:(abs($2)) skip 1 every 3 with points pt 7 ps 0.4 \
                 lc rgb "#888888" title (c ? "" : "turning points, rk45"), \
             for [c=0:cases-1] csv index 2*(p*cases+c) using 1:3 skip 1 every thin with lines ls 2 title (c ? "" : "as printed"), \
             for [c=0:cases-1] csv index 2*(p*cases+c) using 1:5 skip 1 every thin with lines ls 3 title (c ? "" : "corrected")
    }
}
unset multiplot
