# Error of sn, cn, dn against the time of a call, |u| < 2K, m = 0.5, by every route, from the CSV files of
# bench/bench_jacobi: gnuplot -e "folder='build/bench'; svg='build/figures/cost_jacobi.svg'" bench/jacobi.gp
load "bench/style.gp"
csv = folder."/jacobi.csv"; csv_float = folder."/jacobi_float.csv"; csv_wide = folder."/jacobi_wide.csv"
set logscale xy
set xrange [2.5:200]
set yrange [2e-17:0.3]
set xtics ("3 ns" 3, "5" 5, "10" 10, "20" 20, "50" 50, "100" 100, "200" 200)
set ytics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12, \
    "10^{-14}" 1e-14, "10^{-16}" 1e-16)
set xlabel "time of sn, cn and dn together" offset 0,0.3
set ylabel "largest error" offset 0.8,0
error(route) = strcol(2) eq "sncndn; |u| < 2K; m = 0.5" && strcol(3) eq route ? $5 : NaN

set label "AGM, 1 step" at 44,2.8e-2 textcolor rgb blue
set label "2" at 52,5.2e-5 textcolor rgb blue
set label "3" at 62,1.8e-10 textcolor rgb blue
set label "4" at 78,2.5e-15 textcolor rgb blue
set label "the same in float" at 27,1e-3 right textcolor rgb sky
set label "float, plan" at 15.5,1.4e-6 center textcolor rgb green
set label "float, any m" at 28,1e-8 center textcolor rgb green
set label "plan, arrays\n(-O3, AVX)" at 4.4,3e-14 center textcolor rgb red
set label "plan" at 18,3e-15 center textcolor rgb red
set label "any m" at 35,3e-15 center textcolor rgb red
set label "GSL" at 78,2e-16 textcolor rgb grey
plot csv_float using 6:(error("jacobi_agm_sncndn")) with linespoints lc rgb sky lw 2 pt 6 ps 0.7, \
    csv using 6:(error("jacobi_agm_sncndn")) with linespoints lc rgb blue lw 2.2 pt 7 ps 0.7, \
    csv_float using 6:(error("jacobi_sncndn")) with points lc rgb green pt 13 ps 1.4, \
    csv_float using 6:(error("jacobi_plan_sncndn")) with points lc rgb green pt 9 ps 1.2, \
    csv using 6:(error("jacobi_sncndn")) with points lc rgb red pt 13 ps 1.4, \
    csv using 6:(error("jacobi_plan_sncndn")) with points lc rgb red pt 9 ps 1.2, \
    csv_wide using 6:(error("jacobi_plan_sncndn_array")) with points lc rgb red pt 5 ps 1, \
    csv using 6:(error("gsl_sf_elljac_e")) with points lc rgb grey pt 7 ps 1
