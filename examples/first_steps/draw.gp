# The figure of one of the first steps: its CSV file names the curves in its first line.
# gnuplot -e "csv='f.csv'; svg='f.svg'; title='...'" examples/first_steps/draw.gp
set terminal svg size 720,360 font "Helvetica,13" background "white"
set output svg
set encoding utf8
set datafile separator ","
set datafile missing ""
set grid lc rgb "#dddddd"
set title title noenhanced
set key autotitle columnhead at screen 0.5, screen 0.02 center bottom horizontal maxrows 1 samplen 2 noenhanced
set bmargin 7 # for the label of the axis and, below it, up to three rows of names of the curves
set linetype 1 lc rgb "#888888" lw 1.5
set linetype 2 lc rgb "#1f77b4" lw 2
set linetype 3 lc rgb "#d62728" lw 2 dt 2
set linetype 4 lc rgb "#2ca02c" lw 2 dt 4
set linetype cycle 4
set xlabel system("head -1 ".csv." | cut -d, -f1") noenhanced
set offsets 0, 0, graph 0.05, graph 0.05
columns = int(system("head -1 ".csv." | tr ',' '\n' | wc -l"))
plot for [i = 2:columns] csv using 1:i with lines
