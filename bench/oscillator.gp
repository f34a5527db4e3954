# What a digit of x(t) costs: error against the time of one answer, by every route, from the CSV file of bench_oscillator.
# gnuplot -e "csv='build/bench/oscillator.csv'; svg='build/figures/cost_oscillator.svg'" bench/oscillator.gp
# With all=1 the twelve cases, else alpha = 3, psi0 = 0.7, eps = 0.01.
load "bench/style.gp"
if (!exists("all")) all = 0
if (all) { set terminal svg size 1100,900 font "Helvetica,14" background "white"; set output svg; unset grid }
array curve[6] = ["rk87_solve", "rk45_solve", "rk4_solve", "vm_osc_by_route collocation", "GSL rk8pd", "GSL rkf45"]
array colour[6] = [blue, sky, green, purple, grey, grey]
array dash[6] = [1, 1, 1, 1, 2, 3]
array shape[6] = [7, 5, 9, 13, 7, 5]

# closed forms: cos a disc, cn a triangle, ca a square, the laws of orders 2 to 5 a rhombus; open: as printed, or prepared
array law[20] = ["cos (360) printed", "cn (396) printed", "ca (321) printed", "cos corrected", "cn corrected", "ca (325)", \
    "vm_osc_plan_by_route trig", "vm_osc_plan_by_route Jacobi", "vm_osc_plan_by_route Ateb", \
    "vm_osc_plan_by_route order 2", "vm_osc_plan_by_route order 3", "vm_osc_plan_by_route order 4", "vm_osc_plan_by_route order 5", \
    "vm_osc_by_route trig", "vm_osc_by_route Jacobi", "vm_osc_by_route Ateb", \
    "vm_osc_by_route order 2", "vm_osc_by_route order 3", "vm_osc_by_route order 4", "vm_osc_by_route order 5"]
array mark[20] = [6, 8, 4, 7, 9, 5, 6, 8, 4, 12, 12, 12, 12, 7, 9, 5, 13, 13, 13, 13]
place(route) = sum [i=1:20] (route eq law[i] ? i : 0)
tint(i) = i <= 6 ? 0x222222 : 0xd55e00
bigger(i) = (all ? 0.55 : 1.05) * (mark[at_least(i)] > 9 ? 1.5 : 1)

set logscale xy
set xrange [15:(all ? 4e8 : 2e7)]
lowest = 1e-16 # errors below it are drawn on it
set yrange [lowest:40]
set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6, "10 ms" 1e7)
set ytics ("1" 1, "10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12, "10^{-14}" 1e-14, "10^{-16}" 1e-16)

seen(e) = e > lowest ? e : lowest
error(route) = strcol(2) eq job && strcol(3) eq route && $5 < 5 ? seen($5) : NaN
law_error(i) = strcol(2) eq job && i > 0 && $5 < 5 ? seen($5) : NaN
at_least(i) = i > 1 ? i : 1
$grid << END # of the twelve panels: as one line, for a small file
1e2,1e-16
1e2,40

1e4,1e-16
1e4,40

1e6,1e-16
1e6,40

1e8,1e-16
1e8,40

15,1
4e8,1

15,1e-4
4e8,1e-4

15,1e-8
4e8,1e-8

15,1e-12
4e8,1e-12

15,1e-16
4e8,1e-16
END
draw = all ? "plot $grid with lines lc rgb '#e4e4e4' lt 1, " : "plot "
draw = draw."for [i=6:1:-1] csv using 6:(error(curve[i])) with ".(all ? "lines" : "linespoints pt shape[i] ps 0.55")
draw = draw." lc rgb colour[i] lw (all ? 1.5 : 2.2) dt dash[i], csv using 6:(law_error(place(strcol(3))))"
draw = draw.":(bigger(place(strcol(3)))):(mark[at_least(place(strcol(3)))]):(tint(place(strcol(3))))"
draw = draw." with points ps variable pt variable lc rgb variable lw 1.5"

if (!all) {
    job = "alpha=3 psi0=0.7 eps=0.01"
    set title "(m x')' + x³ = 0, m = 1 + t/100" offset 0,-0.5
    set xlabel "time of one answer, x(300)" offset 0,0.3
    set ylabel "error, by the amplitude" offset 0.8,0
    set label "cos" at 28,12 center textcolor rgb black
    set label "cn" at 140,12 right textcolor rgb black
    set label "ca" at 170,12 textcolor rgb black
    set label "as printed" at 290,1.3 textcolor rgb black
    set label "corrected" at 21,0.012 textcolor rgb black
    set label "first order" at 600,0.012 textcolor rgb red
    set label "laws of order" at 60,3e-5 textcolor rgb red
    set label "2" at 112,6e-7 right textcolor rgb red
    set label "3" at 112,1.6e-9 right textcolor rgb red
    set label "4" at 112,8e-12 right textcolor rgb red
    set label "5" at 112,1.7e-13 right textcolor rgb red
    set label "prepared" at 500,2e-15 right textcolor rgb red
    set label "at once" at 1500,2e-15 textcolor rgb red
    set label "rk87" at 1.2e5,4e-12 right textcolor rgb blue
    set label "rk45" at 1.3e6,2e-11 textcolor rgb sky
    set label "rk4" at 2.5e6,8e-10 textcolor rgb green
    set label "GSL rk8pd" at 2.6e5,2.3e-12 textcolor rgb grey
    set label "GSL rkf45" at 2.1e5,1.3e-2 textcolor rgb grey
    set label "collocation" at 3e5,3e-14 textcolor rgb purple
    eval(draw)
} else {
    set label "(m x')' + x|x|^{alpha-1} = 0, m = 1 + eps t: error of x by the amplitude against the time of x(3/eps)" \
        at screen 0.5,0.98 center textcolor rgb black
    set label "rk87" at screen 0.05,0.955 textcolor rgb blue
    set label "rk45" at screen 0.1,0.955 textcolor rgb sky
    set label "rk4" at screen 0.15,0.955 textcolor rgb green
    set label "collocation" at screen 0.19,0.955 textcolor rgb purple
    set label "GSL rk8pd - -  rkf45 ···" at screen 0.37,0.955 textcolor rgb grey
    set label "● cos ▲ cn ■ ca, open: as printed" at screen 0.555,0.955 textcolor rgb black
    set label "vm\\_osc, ◆ orders 2 to 5" at screen 0.82,0.955 textcolor rgb red
    set multiplot
    do for [row=0:2] {
        do for [column=0:3] {
            job = sprintf("alpha=%s psi0=%s eps=%s", column < 2 ? "3" : "4/3", column % 2 ? "0.7" : "0", word("0.1 0.01 0.001", row + 1))
            unset xtics
            unset ytics
            if (row == 2) { set xtics ("0.1 µs" 1e2, "10 µs" 1e4, "1 ms" 1e6, "0.1 s" 1e8) nomirror scale 0 textcolor rgb black }
            if (column == 0) { set ytics ("1" 1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12, "10^{-16}" 1e-16) nomirror scale 0 textcolor rgb black }
            set lmargin at screen 0.06 + 0.235 * column
            set rmargin at screen 0.275 + 0.235 * column
            set tmargin at screen 0.9 - 0.3 * row
            set bmargin at screen 0.66 - 0.3 * row
            set title job offset 0,-0.8
            eval(draw)
            unset label
        }
    }
    unset multiplot
}
