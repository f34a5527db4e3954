# Error of sa, ca against the time of a call, |s| < 10, alpha = 3 and 4/3, by every route, from the CSV files of
# bench/bench_ateb: gnuplot -e "folder='build/bench'; svg='build/figures/cost_ateb.svg'" bench/ateb.gp
load "bench/style.gp"
csv = folder."/ateb.csv"; csv_float = folder."/ateb_float.csv"; csv_wide = folder."/ateb_wide.csv"
set logscale xy
set xrange [2:8000]
set yrange [3e-17:1e-1]
set xtics ("10 ns" 10, "100 ns" 100, "1 µs" 1000)
set ytics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12, "10^{-14}" 1e-14, \
    "10^{-16}" 1e-16)
set xlabel "time of sa and ca together" offset 0,0.3
set ylabel "largest error" offset 0.8,0
error(alpha, route) = strcol(2) eq "saca; |s| < 10; alpha = ".alpha && strcol(3) eq route ? $5 : NaN
array alpha[2] = ["3", "1.333"]
array dash[2] = [1, 2]

set label "plan, arrays\n(-O3, AVX)" at 3,1.5e-2 textcolor rgb purple
set label "plan" at 25,2.5e-4 center textcolor rgb red
set label "float" at 11.5,8e-8 right textcolor rgb green
set label "solid: α = 3\ndashed: α = 4/3,\na general power" at 42,1e-10 textcolor rgb black
set label "float, any α" at 150,1e-7 textcolor rgb green
set label "any α" at 185,1.7e-16 textcolor rgb red
set label "GSL's inverse\nbeta function" at 2000,1.5e-13 center textcolor rgb grey
plot for [i=1:2] csv using 6:(error(alpha[i], "ateb_plan_saca")) with linespoints lc rgb red lw 2.2 dt dash[i] pt 9 ps 1, \
    for [i=1:2] csv_wide using 6:(error(alpha[i], "ateb_plan_saca_array")) with linespoints lc rgb purple lw 2.2 dt dash[i] pt 5 ps 0.8, \
    for [i=1:2] csv_float using 6:(error(alpha[i], "ateb_plan_saca")) with linespoints lc rgb green lw 2.2 dt dash[i] pt 11 ps 1, \
    for [i=1:2] csv using 6:(error(alpha[i], "ateb_saca")) with points lc rgb red pt 12+2-i ps 1.4, \
    for [i=1:2] csv_float using 6:(error(alpha[i], "ateb_saca")) with points lc rgb green pt 12+2-i ps 1.4, \
    for [i=1:2] csv using 6:(error(alpha[i], "gsl_cdf_beta_Pinv")) with points lc rgb grey pt 8-i ps 1
