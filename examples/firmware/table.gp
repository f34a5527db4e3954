# Instructions of a call of each function, float above and double below.
# gnuplot -e "csv='build/firmware/table.csv'; svg='docs/figures/firmware.svg'" examples/firmware/table.gp
set terminal svg size 960,560 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set style line 1 lc rgb "#888888" pt 7 ps 0.8
set style line 2 lc rgb "#1f77b4" pt 5 ps 0.8
set style line 3 lc rgb "#2ca02c" pt 9 ps 0.9
set style line 4 lc rgb "#d62728" pt 6 ps 0.8 lw 2
set style line 5 lc rgb "#ff7f0e" pt 8 ps 0.9 lw 2
set grid lc rgb "#dddddd"
set logscale y
set yrange [30:1e9] # room for the names of the processors above the points
set format y "10^{%L}"
set ylabel "instructions"
targets = "M0 M4F M7 RV32IMAC RV32IMAFDC"
rows = int(system("awk -F, '$2 == \"float\" && $3 == \"M0\"' ".csv." | wc -l"))
table(precision, target) = "< awk -F, '$2 == \"".precision."\" && $3 == \"".target."\" {print ++n \",\" $1 \",\" $6}' ".csv
set xrange [0.5:rows + 0.5]
set multiplot layout 2,1 margins 0.08,0.98,0.24,0.94 spacing 0.06
set title "float" offset 0,-0.5
set xtics 1,1,rows format ""
set key top left horizontal samplen 1
plot for [i = 1:words(targets)] table("float", word(targets, i)) using 1:3 with points ls i title word(targets, i)
set title "double" offset 0,-0.5
unset key
set xtics rotate by 35 right format "%g" noenhanced
plot for [i = 1:words(targets)] table("double", word(targets, i)) using 1:3:xtic(2) with points ls i
unset multiplot
