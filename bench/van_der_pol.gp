# Van der Pol's oscillator by first-order averaging and by the law of order three, from the CSV files of
# bench/van_der_pol.c: gnuplot -e "csv='build/vdp_wave.csv'; svg='OUT.svg'; name='wave'" bench/van_der_pol.gp
load "bench/style.gp"
set lmargin 9
array colour[4] = [grey, green, blue, red]
if (name eq "slopes") {
    set logscale xy
    set format y "10^{%L}"
    set xlabel "eps" offset 0,0.3
    set xrange [0.0009:0.2]
    set xtics ("0.001" 0.001, "0.003" 0.003, "0.01" 0.01, "0.03" 0.03, "0.1" 0.1)
    set title "error of x / amplitude, alpha = 3, from outside the limit cycle"
    set ylabel "error of x / amplitude" offset 0.8,0
    set yrange [1e-9:10]
    set ytics 1e-8,100
    array method[4] = ["averaging (410)", "order 1", "order 2", "order 3"]
    label(x, y) = abs(log(x/0.0253)) < 0.14 ? y : NaN
    plot for [i=1:4] csv using 1:(column(i+1)) with lines lc rgb colour[i] lw 2.4, \
        csv using 1:(label($1, $2)):(method[1]) with labels left offset 1,0.7 textcolor rgb colour[1], \
        for [i=2:4] csv using 1:(label($1, column(i+1))):(method[i]) with labels \
        left offset 1,-0.9 textcolor rgb colour[i]
} else {
    set xlabel "t" offset 0,0.3
    set ylabel "x" offset 0.8,0
    set title "the last 9 s of 30 s: alpha = 3, feed = c = 0.1"
    set key above
    plot csv using 1:2 with lines lc rgb "#cccccc" lw 7 title "exact", \
        csv using 1:3 with lines lc rgb grey dt 2 lw 2 title "averaging (410)", \
        csv using 1:4 with lines lc rgb green lw 2 title "order 1", \
        csv using 1:5 with lines lc rgb red lw 1.6 title "order 3"
}
