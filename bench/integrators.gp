# Work and precision of integrators on one problem: error at the end against the time of a run, from the CSV file of
# bench/bench_integrators: gnuplot -e "folder='build/bench'; problem='cubic'; svg='OUT.svg'" bench/integrators.gp
load "bench/style.gp"
csv = folder."/integrators.csv"
set logscale xy
set format y "10^{%L}"
set xtics ("1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6, "10 ms" 1e7)
set xlabel "time of a run" offset 0,0.3
set ylabel "error at the end" offset 0.8,0
set xrange [1.6e3:2.5e7]
set yrange [problem eq "orbit" ? 1e-11 : 5e-16:2]
set ytics 1e-14,100
what(p) = p eq "cubic" ? "x'' = -x³ to t = 100" : p eq "mass" ? "(m x')' = -x³, m = 1 + 0.1 t, to t = 50" : \
    p eq "body" ? "a free rigid body to t = 60" : "Arenstorf's orbit, one period"
set title what(problem)."; dashed: by hand"
error(route) = strcol(2) eq problem && strcol(3) eq route ? $5 : NaN
# route, the setting at which its name stands, and where that is from the point
array route[7] = ["rk4_solve", "rk45_solve", "rk87_solve", "rk4_loop", "dp54_loop", "gsl_rkf45", "gsl_rk8pd"]
array names[7] = ["rk4", "rk45", "rk87", "", "", "GSL rkf45", "GSL rk8pd"]
array at[7] = ["2.62e+05", problem eq "cubic" ? "3.16e-14" : "1e-14", "1e-10", "", "", "1e-05", "1e-14"]
array dx[7] = [problem eq "orbit" ? 1 : -1, problem eq "cubic" ? 0.2 : 1, -4.5, 0, 0, 1, problem eq "orbit" ? -2 : problem eq "cubic" ? -4 : problem eq "mass" ? 0.7 : -1]
array dy[7] = [problem eq "orbit" ? 0.4 : 1.4, -0.6, -0.4, 0, 0, 0.4, problem eq "cubic" ? -1.3 : problem eq "mass" ? -1.2 : -0.9]
array colour[7] = [green, sky, blue, black, black, grey, grey]
array dash[7] = [1, 1, 1, 3, 2, 1, 1]
array shape[7] = [9, 5, 7, 8, 4, 5, 7]
name(i) = strcol(4) eq at[i] ? error(route[i]) : NaN
plot for [i=7:1:-1] csv using 6:(error(route[i])) with linespoints lc rgb colour[i] lw (i < 4 ? 2.4 : 1.5) dt dash[i] \
    pt shape[i] ps (i < 4 ? 0.7 : 0.5), \
    for [i=1:7] csv using 6:(name(i)):(names[i]) with labels left offset dx[i],dy[i] textcolor rgb colour[i]
