# One curve of a machine: gnuplot -e "csv='file.csv'; svg='file.svg'; title='...'; label='...'; column=3" examples/scenes.gp
set terminal svg size 480,320 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set xlabel "time t, s"
set ylabel label
set title title
set grid lc rgb "#dddddd"
set autoscale yfix
set offsets 0, 0, graph 0.05, graph 0.05
plot csv using 1:column with lines lc rgb "#1f77b4" lw 2 notitle
