# Errors of the averaged laws for Duffing's oscillator over eps, from the CSV file of bench/duffing.c:
# gnuplot -e "csv='build/duffing_slopes.csv'; svg='OUT.svg'" bench/duffing.gp
load "bench/style.gp"
set logscale xy
set format y "10^{%L}"
set lmargin 9
set xlabel "eps" offset 0,0.3
set xrange [0.0008:0.12]
set xtics ("0.001" 0.001, "0.003" 0.003, "0.01" 0.01, "0.03" 0.03, "0.1" 0.1)
set title "error of x after a time of 3/eps: mean motion (slope 1), with its ripple (slope 2)"
set ylabel "error of x / amplitude" offset 0.8,0
set yrange [1e-10:1e-1]
array colour[6] = [blue, blue, red, red, green, green]
set key on bottom right noenhanced samplen 2 spacing 0.9 font "Helvetica,13"
plot for [i = 1:6] csv using 1:(column(i + 1)) with lines lc rgb colour[i] lw (i % 2 ? 1.4 : 2.6) title columnheader(i + 1)
