#!/bin/sh
# The goals of speed, each beside what the bench programs measured, and the reason where it is not reached: a table for
# docs/cost.md. The limits are the time of a chain of calls, and the instructions of a call, which come from docs/counts.md.
# usage: goals.sh FOLDER COUNTS, FOLDER with the CSV files of the programs
folder=$1 counts=$2
# what @ program @ job @ route @ at most so many sin (float: sinf) @ its line in docs/counts.md @ reason where it takes longer
rows='sn, cn, dn to 2K @ jacobi @ sncndn; |u| < 2K; 0 < m < 0.5 @ jacobi_sncndn @ 5 @ jacobi_sncndn @ K is computed by a table, a root and a division; only then can u be reduced to u - j K (j is an integer), the argument that the theta functions need
sn, cn, dn to 2K @ jacobi @ sncndn; |u| < 2K; 0.5 < m < 1 @ jacobi_sncndn @ 5 @ jacobi_sncndn @ above m = 0.97, K needs a logarithm, and the theta functions need an exponential if their arguments are far from 0
sn, cn, dn to 2K @ jacobi @ sncndn; |u| < 2K; -30 < m < -1 @ jacobi_sncndn @ 5 @ jacobi_sncndn @ for m below -1.25, K is computed by the arithmetic-geometric mean
sn, cn, dn to 1e9 @ jacobi @ sncndn; |u| < 1e9; 0 < m < 0.5 @ jacobi_sncndn @ 10 @  @ for abs(u) above 2^20, K must have twice the digits; K is computed by the arithmetic-geometric mean, each step of which must wait for the previous step
sn, cn, dn to 1e9 @ jacobi @ sncndn; |u| < 1e9; 0.5 < m < 1 @ jacobi_sncndn @ 10 @  @ the same reason as for 0 < m < 0.5; in addition, the theta functions need an exponential if their arguments are far from 0
sn, cn, dn prepared @ jacobi @ sncndn; |u| < 2K; m = 0.5 @ jacobi_plan_sncndn @ 2 @ jacobi_plan_sncndn @ a call computes two polynomials of degree 10 and then a division
sn, cn, dn prepared, m near 1 @ jacobi @ sncndn; |u| < 2K; m = 0.99 @ jacobi_plan_sncndn @ 3 @  @ theta functions of arguments far from 0 need sinh and cosh, which must wait until u is reduced to a quarter period
sa, ca @ ateb @ saca; |s| < 10; 0 < alpha < 5 @ ateb_saca @ 12 @ ateb_saca @ Pi_alpha, the powers and the inversion are computed anew for each alpha
sa, ca prepared, without a power @ ateb @ saca; |s| < 10; alpha = 3 @ ateb_plan_saca @ 2 @ ateb_plan_saca_3 @ s is reduced to a quarter period; then the power d^(alpha+1) is computed, d being the distance of s from the nearest zero of ca; then polynomials are computed; each of these steps must wait for the previous step
sa, ca prepared, with a power @ ateb @ saca; |s| < 10; alpha = 1.333 @ ateb_plan_saca @ 3 @ ateb_plan_saca_4_3 @ the power needs a logarithm and an exponential, which must wait until s is reduced to a quarter period; the polynomials that give sa and ca must wait for the power
sa, ca prepared, with a power @ ateb @ saca; |s| < 10; alpha = 1000 @ ateb_plan_saca @ 3 @  @ the power needs a logarithm and an exponential
arrays, -O3 -march=native @ jacobi_wide @ sncndn; |u| < 2K; m = 0.5 @ jacobi_plan_sncndn_array @ 0.5 @ jacobi_plan_sncndn_array @ a vector register holds few numbers, and each number needs the reduction of u and a division
arrays, -O3 -march=native, m near 1 @ jacobi_wide @ sncndn; |u| < 2K; m = 0.99 @ jacobi_plan_sncndn_array @ 0.5 @  @ each number needs sinh and cosh, which are computed from an exponential
arrays, -O3 -march=native @ ateb_wide @ saca; |s| < 10; alpha = 3 @ ateb_plan_saca_array @ 0.5 @  @ sa and ca have one formula near the zeros of sa and one near those of ca; what both formulas need is computed for each s, since a vector register cannot branch
arrays, -O3 -march=native, with a power @ ateb_wide @ saca; |s| < 10; alpha = 1.333 @ ateb_plan_saca_array @ 0.8 @  @ each number needs a logarithm and an exponential for the power; in addition, what the formula near the zeros of sa and the formula near the zeros of ca need is computed for each s
sn, cn, dn in float @ jacobi_float @ sncndn; |u| < 2K; 0 < m < 0.5 @ jacobi_sncndn @ 5 @ jacobi_sncndn @ sinf is fast because it computes in double; the float code of the kit must not use double
sn, cn, dn prepared, in float @ jacobi_float @ sncndn; |u| < 2K; m = 0.5 @ jacobi_plan_sncndn @ 2 @ jacobi_plan_sncndn @ sinf is fast because it computes in double; the float code of the kit must not use double
sa, ca in float @ ateb_float @ saca; |s| < 10; 0 < alpha < 5 @ ateb_saca @ 12 @ ateb_saca @ sinf is fast because it computes in double; the float code of the kit must not use double
sa, ca prepared, in float @ ateb_float @ saca; |s| < 10; alpha = 3 @ ateb_plan_saca @ 2 @ ateb_plan_saca_3 @ sinf is fast because it computes in double; the float code of the kit must not use double'
echo '| what | of which | goal | measured | reached | in a chain | instructions, double; float | instructions divided by those of sin | reason, if not reached |'
echo '|---|---|---|---|---|---|---|---|---|'
for program in jacobi ateb jacobi_wide ateb_wide jacobi_float ateb_float; do
    [ -f "$folder/$program.csv" ] && sed "s/^[^,]*/$program/" "$folder/$program.csv"
done | awk -F, -v rows="$rows" -v counts="$counts" '
    BEGIN {
        while ((getline line <counts) > 0)
            if (split(line, cell, / *[|] */) > 3) {
                count[cell[2]] = cell[3] "; " cell[4]
                double_count[cell[2]] = cell[3]
                float_count[cell[2]] = cell[4]
            }
        n = split(rows, row, "\n")
    }
    $4 == "" { ratio[$1, $2, $3] = $7 }
    END {
        for (i = 1; i <= n; i++) {
            split(row[i], field, / *@ */)
            measured = ratio[field[2], field[3], field[4]]
            reached = measured == "" ? "not measured" : measured + 0 <= field[5] + 0 ? "yes" : "no"
            chain = ratio[field[2], field[3], field[4] " (chain)"]
            name = "`" field[6] "`"
            in_sin = ""
            if (field[6] != "" && name in count) in_sin = field[2] ~ /float/ ? float_count[name] / float_count["`sin`"] : double_count[name] / double_count["`sin`"]
            of = field[3]
            gsub(/;/, ",", of)
            gsub(/[|]/, "\\\\|", of)
            printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", field[1], of, field[5],
                measured == "" ? "" : sprintf("%.2f", measured), reached, chain == "" ? "" : sprintf("%.2f", chain),
                count[name], in_sin == "" ? "" : sprintf("%.1f", in_sin), reached == "no" ? field[7] : ""
        }
    }'
echo
echo "The times in this table were measured on one machine ($(sed -n 's/^processor *//p' "$folder/machine"))."
