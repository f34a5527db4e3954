# A machine: its sketch, where examples/scenes/NAME.gp draws one, above one curve, with its events. A sketch also defines
#   event(i)    what the event i of the scene is; empty for one that stays unmarked
#   row(i)      0 or 1, the line of its label
#   before(i)   1 where the label ends at the event, 0 where its middle is there
#   rows        how many lines of labels there are
#   until       the end of the curve where it is not that of the run
# happened has the time and the number of each event.
# gnuplot -e "name='scoop'; csv='file.csv'; svg='file.svg'; title='...'; label='...'; column=3; happened='T I ...'" \
#     examples/scenes.gp
set encoding utf8
sketch = "examples/scenes/" . name . ".gp"
drawn = system("test -f " . sketch . " && echo yes") eq "yes"
height = drawn ? 456 : 320
set terminal svg size 480,height font "Helvetica,13" background "white"
set output svg
set datafile separator ","
event(i) = ""
row(i) = 0
before(i) = 0
until = 0
from_top(pixels) = 1 - pixels / real(height)
if (drawn) {
    load "examples/scenes/sketch.gp"
    set multiplot
    unset border; unset tics; unset key
    set label title at screen 0.5, screen from_top(15) center
    set lmargin at screen 0; set rmargin at screen 1
    set tmargin at screen from_top(28); set bmargin at screen from_top(178)
    set xrange [0:16]; set yrange [0:5]
    load sketch
    plot NaN notitle
    unset arrow; unset object; unset label
    set border 3 lc rgb "#555555"
    set xtics nomirror scale 0.5; set ytics nomirror scale 0.5
    set lmargin at screen 0.18; set rmargin at screen 0.96
    set tmargin at screen from_top(rows == 2 ? 224 : 208); set bmargin at screen from_top(400)
} else {
    set title title
    unset key
    rows = 0
}
set xlabel "time t, s" offset 0, 0.3
set ylabel label
set grid lc rgb "#dddddd" lt 1
set autoscale xy
set autoscale xfix; set autoscale yfix
set offsets 0, 0, graph 0.05, graph 0.05
stats csv using 1 nooutput
if (until) { set xrange [0:until] } else { until = STATS_max; set xrange [*:*] }
ROW = 1 + 19 / 180. # the line of an event reaches up to its label
pixel(t) = 374 * t / until
do for [k = 1:words(happened):2] {
    t = real(word(happened, k)); i = int(word(happened, k + 1))
    if (strlen(event(i))) {
        set arrow from first t, graph 0 to first t, graph (row(i) ? ROW : 1) nohead lc rgb "black" lw 0.9 dt (3,3) back
        # A label that would leave the figure ends where the curve does.
        if (before(i)) {
            set label event(i) at first t, graph 1 right offset character -0.4, 0.5 + 1.05 * row(i)
        } else { if (pixel(t) + 3.3 * strlen(event(i)) > 390) {
            set label event(i) at graph 1, graph 1 right offset character 0, 0.5 + 1.05 * row(i)
        } else {
            set label event(i) at first t, graph 1 center offset character 0, 0.5 + 1.05 * row(i)
        } }
    }
}
plot csv using 1:column with lines lc rgb "black" lw 2 notitle
