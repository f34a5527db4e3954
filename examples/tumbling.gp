# A tumbling satellite before and after it sheds a panel: the bodies at seven times in an oblique view along y, and what
# the jump changes and keeps.
# gnuplot -e "csv='tumbling.csv'; svg='tumbling.svg'" examples/tumbling.gp
set terminal svg size 1100,640 font "Helvetica,13" background "white"
set output svg
set datafile separator ","
set linetype 1 lc rgb "#888888"
set linetype 2 lc rgb "#1f77b4"
set linetype 3 lc rgb "#d62728"
set grid lc rgb "#dddddd"
set multiplot

set origin 0, 0.46
set size 1, 0.54
set size ratio -1
set xrange [-8.5:12.5]
set yrange [-2.7:3.3]
set xlabel "x, m (y into the picture)" offset 0, 0.5
set ylabel "z, m"
set key top left horizontal reverse Left samplen 2
X(x, y) = x + 0.4 * y
Z(y, z) = z + 0.25 * y
plot for [k = 0:2] csv index 1:2 \
    using ($1 == k ? X($2, $3) : NaN):(Z($3, $4)):(X($5, $6) - X($2, $3)):(Z($6, $7) - Z($3, $4)) \
    with vectors nohead lt k+1 lw 1.7 title word("whole hub panel", k+1)

set size noratio
set size 0.5, 0.46
set xrange [-6:6]
set yrange [*:*]
set xlabel "t, s"
set style data lines
after(x, y) = x >= 0 ? y : NaN
before(x, y) = x < 0 ? y : NaN
set origin 0, 0
set yrange [-1:1.6]
set ylabel "hub's angular velocity, rad/s"
set key top left horizontal reverse Left samplen 3
plot for [k = 2:4] csv index 0 using 1:(before($1, column(k))) lt 1 lw 2 dt k-1 notitle, \
     for [k = 2:4] csv index 0 using 1:(after($1, column(k))) lt 2 lw 2 dt k-1 title word("x y z", k-1)." (body)"
set origin 0.5, 0
set yrange [0:26]
set ylabel "L_z, about the origin, N m s"
plot csv index 0 using 1:7 lt 1 lw 4 title "sum", \
     csv index 0 using 1:(after($1, $5)) lt 2 lw 2 title "hub", \
     csv index 0 using 1:(after($1, $6)) lt 3 lw 2 title "panel"
unset multiplot
