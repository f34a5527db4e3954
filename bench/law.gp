# Errors of the law of order five, cut off after each order, from the CSV files of bench/law.c:
# gnuplot -e "csv='build/law_slopes.csv'; svg='OUT.svg'; name='slopes'" bench/law.gp
load "bench/style.gp"
set logscale xy
set format y "10^{%L}"
set lmargin 9
if (name eq "slopes") {
    set xlabel "eps" offset 0,0.3
    set xrange [0.0009:0.2]
    set xtics ("0.001" 0.001, "0.003" 0.003, "0.01" 0.01, "0.03" 0.03, "0.1" 0.1)
    set title "law of order five, cut off after order 2, 3, 4, 5"
} else {
    set xlabel "t" offset 0,0.3
    set xrange [0.45:2000] # the motion begins at 2; the names of the curves stand before it
    set xtics ("10" 10, "100" 100, "1000" 1000)
    set title "eps = 0.01: the error of x along one motion"
}
set ylabel "error of x / amplitude" offset 0.8,0
set yrange [1e-16:1e-2]
set ytics 1e-16,100
array colour[4] = [grey, green, blue, red]
# a name stands before the first point of a motion, and beside the line at one eps; that of order 5 to its right
named(x) = name eq "slopes" ? abs(log(x/0.0253)) < 0.14 : x < 2.01
label(i, x, y) = named(x) ? y : NaN
plot for [i=1:4] csv using 1:(column(i+1)) with lines lc rgb colour[i] lw 2.4, \
    for [i=1:4] csv using 1:(label(i, $1, column(i+1))):(sprintf("order %d", i+1)) with labels \
    left offset (name eq "errors" ? -6.4 : i < 4 ? -6.4 : 1),(name eq "errors" ? 0 : i < 4 ? 0.3 : -0.9) textcolor rgb colour[i]
