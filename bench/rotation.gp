# Free rotation in closed form and integrated: error of attitude against time, after 1, 10 ... 1e6 turns, from the CSV of
# bench/bench_rotation.
# gnuplot -e "csv='build/bench/rotation.csv'; svg='build/figures/cost_rotation.svg'" bench/rotation.gp
set terminal svg size 720,600 font "Helvetica,18" background "white"
set output svg
set datafile separator ","
set datafile missing NaN
set logscale xy
set grid lc rgb "#e4e4e4" lt 1
set border 3 lc rgb "#555555"
set tics nomirror textcolor rgb "#333333" scale 0.5
unset key
set xtics ("1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6, "10 ms" 1e7, "0.1 s" 1e8, "1 s" 1e9)
set ytics ("1" 1, "10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12, \
    "10^{-14}" 1e-14, "10^{-16}" 1e-16)
set xrange [700:5e9]
set yrange [3e-17:20]
set xlabel "time of one attitude" offset 0,0.3
set ylabel "error, rad" offset 0.8,0

blue = "#0072b2"; sky = "#3a9bd9"; green = "#009e73"; red = "#d55e00"; grey = "#8a8a8a"
array route[6] = ["rk87_solve", "rk87_solve", "rk45_solve", "rk4_solve", "GSL rk8pd", "GSL rk8pd"]
array knob[6] = ["1e-12", "1e-06", "1e-09", "128", "1e-12", "1e-06"]
array colour[6] = [blue, blue, sky, green, grey, grey]
array dash[6] = [1, 1, 1, 1, 2, 2]
array shape[6] = [7, 7, 5, 9, 7, 7]
error(r, k) = strcol(2)[1:11] eq "triaxial 1e" && strcol(3) eq r && strcol(4) eq k ? $5 : NaN
set label "exact: 1, 10 ... 10^6 turns" at 5e3,3.5e-16 textcolor rgb red
plot for [i=6:1:-1] csv using 6:(error(route[i], knob[i])) with linespoints lc rgb colour[i] lw 2.2 dt dash[i] pt shape[i] ps 0.6, \
    csv using 6:(error("exact", "")) with points lc rgb red pt 13 ps 1.6
