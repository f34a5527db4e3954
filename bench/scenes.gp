# Time of a right-hand side as effects are added one by one, from the CSV file of bench/bench_scenes:
# gnuplot -e "folder='build/bench'; svg='build/figures/cost_scenes.svg'" bench/scenes.gp
load "bench/style.gp"
csv = folder."/scenes.csv"
set style fill solid 1 noborder
set boxwidth 0.25
set xrange [-0.6:5.6]
set yrange [0:*]
set xtics ("no effect" 0, "spring" 1, "+ damper" 2, "+ Van der\nPol" 3, "+ gravity" 4, "+ drive" 5) scale 0 font ",15"
set ylabel "ns of a right-hand side" offset 0.8,0
ns(route, effects) = strcol(3) eq route && (effects == 0 ? strcol(2) eq "no effect" : strcol(2)[1:1] eq sprintf("%d", effects)) ? $6 : NaN
set bmargin 3.2
set label "by hand" at 4.73,8 rotate textcolor rgb grey front
set label "inline functions" at 5,8 rotate textcolor rgb sky front
set label "scene" at 5.27,8 rotate textcolor rgb "white" front
plot for [e=0:5] csv using (e-0.27):(ns("by hand", e)) with boxes lc rgb grey, \
    for [e=0:5] csv using (e):(ns("inline functions", e)) with boxes lc rgb sky, \
    for [e=0:5] csv using (e+0.27):(ns("scene", e)) with boxes lc rgb red
