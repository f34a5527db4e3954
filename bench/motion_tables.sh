#!/bin/sh
# The tables of oscillators and free rotation for docs/cost.md, from the CSV files of the bench programs.
# usage: motion_tables.sh FOLDER oscillator | oscillator_all | rotation
awk -F, -v table="$2" '
    function time(ns) {
        return ns < 1e3 ? sprintf("%.0f ns", ns) : ns < 1e6 ? sprintf("%.3g µs", ns/1e3) : ns < 1e9 ? sprintf("%.3g ms", ns/1e6) \
            : sprintf("%.3g s", ns/1e9)
    }
    function keep(key, goal) { # the cheapest setting within an error of 10^-goal
        if ($5 != "nan" && $5 + 0 <= 10^-goal && (!((key, goal) in ns) || $6 + 0 < ns[key, goal])) {
            ns[key, goal] = $6 + 0
            by[key, goal] = $3
        }
    }
    function line(key) {if (!(key in seen)) {seen[key] = 1; order[++n] = key}}
    table == "oscillator" && $2 ~ /^alpha=3 psi0=0.7 eps=0.01/ {
        line($3)
        sixteen = $2 ~ /of 16$/
        if (!sixteen && $4 == "") error[$3] = $5
        for (goal = 2; goal <= 10; goal += 2) keep($3 sixteen, goal)
        if (!sixteen && (!($3 in least) || $6 + 0 < least[$3])) least[$3] = $6 + 0
    }
    table == "oscillator_all" && $2 ~ /^alpha=/ && $2 !~ /of 16$/ && $3 !~ /^vm_osc_(plan|closed)/ {
        line($2)
        for (goal = 2; goal <= 10; goal += 2) keep($2 ($3 ~ /^GSL/), goal)
    }
    table == "rotation" && $2 == "triaxial" && $3 == "prepared motion" {
        line("`exact`, prepared")
        for (decade = 0; decade <= 6; decade += 2) cell["`exact`, prepared", decade] = "as below, " time($6)
    }
    table == "rotation" && /^rotation,(triaxial|middle axis) 1e/ {
        key = "`" $3 "`" ($4 == "" ? "" : $3 == "rk4_solve" ? ", " $4 " steps a turn" : ", " $4)
        line(key)
        cell[key, $2 ~ /^t/ ? substr($2, 12) : $2] = $5 ", " time($6)
    }
    END {
        if (table == "oscillator") {
            print "| by | error | to 1e-2 | 1e-4 | 1e-6 | 1e-8 | 1e-10 | each of 16, to 1e-4 | 1e-8 |\n|---|---|---|---|---|---|---|---|---|"
            for (i = 1; i <= n; i++) {
                k = order[i]
                printf "| `%s` | %s |", k, error[k] != "" ? error[k] " in " time(least[k]) : ""
                for (goal = 2; goal <= 10; goal += 2) printf " %s |", (k 0, goal) in ns ? time(ns[k 0, goal]) : ""
                for (goal = 4; goal <= 8; goal += 4) printf " %s |", (k 1, goal) in ns ? time(ns[k 1, goal]) : ""
                print ""
            }
        }
        if (table == "oscillator_all") {
            print "| case | to 1e-2 | 1e-4 | 1e-6 | 1e-8 | 1e-10 |\n|---|---|---|---|---|---|"
            for (i = 1; i <= n; i++) {
                k = order[i]
                printf "| %s |", k
                for (goal = 2; goal <= 10; goal += 2) {
                    ours = ns[k 0, goal]; theirs = ns[k 1, goal]
                    printf " %s%s%s |", ours ? "`" by[k 0, goal] "` " time(ours) : "-", theirs ? "; GSL " time(theirs) : "", \
                        theirs && (!ours || theirs < ours) ? ": GSL wins" : ""
                }
                print ""
            }
        }
        if (table == "rotation") {
            print "| by | 1 turn: error (rad), time | 100 turns | 1e4 turns | 1e6 turns | about the middle axis, 1e4 turns |\n|---|---|---|---|---|---|"
            for (i = 1; i <= n; i++) {
                printf "| %s |", order[i]
                for (decade = 0; decade <= 6; decade += 2) printf " %s |", cell[order[i], decade]
                printf " %s |\n", cell[order[i], "middle axis 1e4"]
            }
        }
    }' "$1/${2%_all}.csv"
