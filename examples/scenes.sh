#!/bin/sh
# Draw a figure of each machine and numerical example from the CSV files in the folder named, as SVG beside them.
folder=$1
if ! sh tests/install.sh -w "which draws the figures" "command -v gnuplot" gnuplot-nox; then
    echo "no gnuplot: the curves are in $folder/scenes_*.csv, no figures drawn"
    exit 0
fi
draw() { # draw NAME COLUMN TITLE LABEL
    happened=$(tr ',\n' '  ' <"$folder/scenes_$1_events.csv")
    gnuplot -e "name='$1'; csv='$folder/scenes_$1.csv'; svg='$folder/scenes_$1.svg'; title=\"$3\"; label=\"$4\"" \
        -e "column=$2; happened='$happened'" \
        examples/scenes.gp || exit 1
}
draw pouring 2 "Fig. 1: a hook tips a vessel" "angle φ, rad"
draw vessel 3 "Figs 2, 3: a vessel tipped by a motor" "angular velocity ω, rad/s"
draw turner 3 "Fig. 4: a wagon turner" "angular velocity ω, rad/s"
draw tippler 3 "Fig. 5: a tippler with counterweights" "angular velocity ω, rad/s"
draw wagon 3 "Fig. 6: a wagon fills, then empties" "velocity v, m/s"
draw mechanism 3 "Fig. 7: a wagon on a crank" "angular velocity ω, rad/s"
draw mill 3 "Fig. 8: a rolling mill" "velocity v_1, m/s"
draw regulator 3 "Fig. 9: a mercury regulator" "angular velocity ω, rad/s"
draw scoop 3 "Fig. 10: a scoop cuts, carries, drops" "angular velocity ω, rad/s"
draw excavator 27 "Fig. 10: five bodies, the scoop is filled" "height y of the scoop, m"
draw crane 4 "Fig. 11: a crane's load, picked up, leaking, dropped" "x of the load, m"
draw luffing 21 "Fig. 11: four bodies, a load that leaks and drops" "height y of the block, m"
draw dosing 2 "Fig. 12: a belt dosing device" "angle θ of the lever, rad"
draw weighing 2 "Fig. 13: automatic weighing" "angle θ of the bar, rad"
draw heap 3 "Cayley's chain from a heap" "velocity v, m/s"
draw winding 3 "A chain winds on a drum" "angular velocity ω, rad/s"
draw stator 4 "A broken rotor meets the stator" "angle ψ, rad"
draw reel 3 "A band winds up on a drum, layer by layer" "angular velocity ω, rad/s"
draw rocket 4 "A rocket of two stages" "height, m"
draw fig18 4 "Fig. 18: the rest of a broken rotor" "angle ψ, rad"
draw fig30 2 "Fig. 30: Laval's rotor" "x, m"
draw fig32 2 "Fig. 32: one of two bodies and a spring" "x, m"
echo "  $folder/scenes_*.svg   the machines of chapter 1, Figs 1 to 13, and numerical examples"
