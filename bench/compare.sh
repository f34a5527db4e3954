#!/bin/sh
# How far do two runs of make bench differ? For every line that both folders have, the quotient of the two ratios
# (to sin, or to the hand-written loop); the worst ones, and how many are within 15 %.
# usage: compare.sh FOLDER FOLDER       exit status 0 if all are within 15 %
[ -d "$1" ] && [ -d "$2" ] || { sed -n '2,4s/^# //p' "$0"; exit 2; }
for csv in "$1"/*.csv; do
    [ -f "$2/$(basename "$csv")" ] || continue
    awk -F, '
        FNR == 1 {file++; for (i = 1; i <= NF; i++) column[file, $i] = i; next}
        !column[file, "ratio"] {next}
        {
            key = ""
            for (i = 1; i < column[file, "error"]; i++) key = key (i > 1 ? ", " : "") $i
            ratio = $column[file, "ratio"]
        }
        file == 1 {before[key] = ratio}
        file == 2 && before[key] > 0 && ratio > 0 {
            q = ratio/before[key]
            printf "%.3f  %s: %s, %s\n", (q > 1 ? q : 1/q), key, before[key], ratio
        }' "$csv" "$2/$(basename "$csv")"
done | sort -rn | awk '
    {count++; within += $1 <= 1.15; five += $1 <= 1.05}
    NR <= 10 {print}
    END {
        printf "%d of %d ratios within 15 %%, %d within 5 %%\n", within, count, five
        exit !(count > 0 && within == count)
    }'
