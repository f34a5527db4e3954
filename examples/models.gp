# Models of the text as sketches: Figs 14, 15, 16 and 31. gnuplot -e "folder='build/figures'" examples/models.gp
set terminal svg size 480,320 font "Helvetica,13" background "white"
unset border
unset tics
unset key
blue = "#1f77b4"
red = "#d62728"
grey = "#888888"
set style arrow 1 head filled size 0.13,18 lw 1.6 lc rgb blue
set style arrow 2 head filled size 0.13,18 lw 1.6 lc rgb red
set style arrow 3 head filled size 0.13,18 lw 1.2 lc rgb grey
set parametric
set trange [0:2*pi]
set samples 200

# closed outlines: a body with a bulge, a part beside it
body_x(t) = 1.5 * cos(t) + 0.12 * cos(2 * t)
body_y(t) = 0.95 * sin(t)
part_x(t) = 0.55 * cos(t)
part_y(t) = 0.42 * sin(t)

# ---- Fig. 14: separation and augmentation in space, Fig. 15: in the plane ----
do for [figure in "14 15"] {
    set output sprintf("%s/model_%s.svg", folder, figure)
    unset label
    unset arrow
    unset object
    set size ratio -1
    set xrange [-0.6:6.6]
    set yrange [-0.6:4.2]
    plane = figure eq "15"
    set title (plane ? "Fig. 15: centres of bodies in the plane" : "Fig. 14: a part separates (or is added)")
    set label 1 "O" at 0.15,-0.25 center
    set arrow from 0,0 to 1.2,0 arrowstyle 3
    set arrow from 0,0 to 0,1.2 arrowstyle 3
    set label "x" at 1.25,-0.2
    set label "y" at -0.3,1.2
    if (!plane) { set arrow from 0,0 to -0.45,-0.45 arrowstyle 3; set label "z" at -0.62,-0.25 }
    # S1 of the rest, S of the whole, S2 of the part; S on the line between them
    set arrow from 0,0 to 2.6,2.0 arrowstyle 3
    set arrow from 0,0 to 3.0,2.18 arrowstyle 3
    set arrow from 0,0 to 5.0,3.08 arrowstyle 3
    set label "r_{S1}, r_S" at 0.75,1.3 tc rgb grey
    set label "r_{S2}" at 4.25,2.2 tc rgb grey
    set arrow from 2.6,2.0 to 1.9,3.2 arrowstyle 1
    set label "v_{S1}" at 1.4,3.3 tc rgb blue
    set arrow from 3.0,2.18 to 3.0,3.6 arrowstyle 3
    set label "v_S" at 3.08,3.6 tc rgb grey
    set arrow from 5.0,3.08 to 6.1,3.7 arrowstyle 2
    set label "v_{S2}" at 6.05,3.9 tc rgb red
    set label "S_1" at 2.05,2.1
    set label "S" at 2.95,1.85
    set label "S_2" at 5.08,3.05
    set label (plane ? "Ω_1" : "Ω_1, M∓m") at 2.6,0.75 center tc rgb blue
    set label (plane ? "Ω_2" : "Ω_2, m") at 5.7,2.6 tc rgb red
    set object circle at 2.6,2.0 size 0.05 fs solid fc rgb blue
    set object circle at 3.0,2.18 size 0.05 fs solid fc rgb grey
    set object circle at 5.0,3.08 size 0.05 fs solid fc rgb red
    plot 2.6 + body_x(t), 2.0 + body_y(t) with lines lc rgb blue lw 2, \
        5.0 + part_x(t), 3.08 + part_y(t) with lines lc rgb red lw 2
}

# ---- Fig. 16: a disc on an elastic shaft ----
set output folder . "/model_16.svg"
unset label
unset arrow
unset object
set title "Fig. 16: a disc on an elastic shaft"
set xrange [-3.3:3.3]
set yrange [-1.9:2.3]
set arrow from -3,0 to 3,0 nohead lw 1 dt 3 lc rgb grey
do for [side in "-1 1"] {
    s = real(side)
    set object polygon from 3*s,0 to 3*s - 0.2,-0.4 to 3*s + 0.2,-0.4 to 3*s,0 fs empty border rgb grey
}
set object rect from -0.22,-0.95 to 0.22,1.65 fc rgb blue fs transparent solid 0.15 border rgb blue
set object circle at 0,0.35 size 0.06 fs solid fc rgb "black"
set label "S" at 0.3,0.5
set label "M, I_S" at 0.35,1.5 tc rgb blue
set label "c" at -1.6,0.45
set arrow from 2.2,0 to 2.2,1.2 arrowstyle 3
set label "y" at 2.3,1.2 tc rgb grey
set label "ψ'" at -2.75,0.55
set arrow from -2.6,0.35 to -2.6,-0.3 arrowstyle 2
set label "O" at 0.3,-0.15
plot [-3:3] t, 0.35 * cos(pi * t / 6) with lines lc rgb "black" lw 2

# ---- Fig. 31: two bodies with a nonlinear connection ----
set output folder . "/model_31.svg"
unset label
unset arrow
unset object
set title "Fig. 31: two bodies with a connection"
set xrange [-0.4:8.4]
set yrange [-1.6:3.2]
set arrow from 0,0 to 8,0 nohead lw 1.5 lc rgb grey
set object rect from 1,0 to 2.6,1.3 fc rgb blue fs transparent solid 0.15 border rgb blue
set object rect from 5.4,0 to 7,1.3 fc rgb blue fs transparent solid 0.15 border rgb blue
set label "m(τ)" at 1.8,0.65 center tc rgb blue
set label "m(τ)" at 6.2,0.65 center tc rgb blue
set label "k_α" at 4,1.15 center
set arrow from 1.8,1.7 to 2.8,1.7 arrowstyle 2
set label "x" at 2.9,1.7 tc rgb red
set arrow from 6.2,1.7 to 7.2,1.7 arrowstyle 2
set label "y" at 7.3,1.7 tc rgb red
set arrow from 1.8,-0.9 to 0.6,-0.9 arrowstyle 3
set arrow from 6.2,-0.9 to 5.0,-0.9 arrowstyle 3
set label "-m' x'" at 1.2,-1.25 center tc rgb grey
set label "-m' y'" at 5.6,-1.25 center tc rgb grey
zigzag(u) = u < 0.1 || u > 0.9 ? 0 : 0.25 * (2 / pi) * asin(sin(2 * pi * 5 * (u - 0.1) / 0.8))
plot [0:1] 2.6 + 2.8 * t, 0.65 + zigzag(t) with lines lc rgb "black" lw 2
