# Free rotation in closed form and integrated: error of attitude against time, after 1, 10 ... 10^6 turns, from the CSV of
# bench/bench_rotation.
# gnuplot -e "csv='build/bench/rotation.csv'; svg='build/figures/cost_rotation.svg'" bench/rotation.gp
load "bench/style.gp"
set logscale xy
set xtics ("1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6, "10 ms" 1e7, "0.1 s" 1e8, "1 s" 1e9, "10 s" 1e10)
set ytics ("1" 1, "10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12, "10^{-14}" 1e-14, "10^{-16}" 1e-16)
set xrange [700:2e10]
set yrange [3e-17:20]
set title "a body turns freely: 1, 10 ... 10^6 turns" offset 0,-0.5
set xlabel "time of one attitude" offset 0,0.3
set ylabel "error of attitude, rad" offset 0.8,0

array route[6] = ["rk87_solve", "rk87_solve", "rk45_solve", "rk4_solve", "GSL rk8pd", "GSL rk8pd"]
array knob[6] = ["1e-12", "1e-06", "1e-09", "128", "1e-12", "1e-06"]
array colour[6] = [blue, blue, sky, green, grey, grey]
array dash[6] = [1, 1, 1, 1, 2, 2]
array shape[6] = [7, 7, 5, 9, 7, 7]
error(r, k) = strcol(2)[1:10] eq "triaxial 1" && strcol(3) eq r && strcol(4) eq k ? $5 : NaN
set label "exact, any time" at 5e3,3e-16 textcolor rgb red
set label "rk87, 10^{-12}" at 1.5e6,3e-11 textcolor rgb blue
set label "rk87, 10^{-6}" at 5.5e5,2.5e-3 textcolor rgb blue
set label "rk45, 10^{-9}" at 5e3,3e-11 textcolor rgb sky
set label "rk4" at 3e4,3e-6 textcolor rgb green
set label "GSL rk8pd, dashed" at 1.5e3,5e-2 textcolor rgb grey
set label "1 turn" at 1.2e4,2e-14 textcolor rgb black
set label "10^6" at 8e9,1.5e-3 textcolor rgb black
plot for [i=6:1:-1] csv using 6:(error(route[i], knob[i])) with linespoints lc rgb colour[i] lw 2.2 dt dash[i] pt shape[i] ps 0.55, \
    csv using 6:(error("exact", "")) with points lc rgb red pt 13 ps 1.1
