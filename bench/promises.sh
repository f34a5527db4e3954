#!/bin/sh
# Write a table of what is promised and what was found: each bound of tests/promises.txt that rows of tests enforce, and the
# worst error of these rows. usage: promises.sh BUILD_FOLDER <TEXT, from the top of the project; BUILD_FOLDER/promises/rows
# is there (tests/test_promises.sh)
cat
printf '\n| promised by | bound | worst, double | float | points | enforced by |\n|---|---|---|---|---|---|\n'
awk -F '\t' '
    FILENAME ~ /rows$/ {row[++n] = $0; next}
    /^#/ || / @ as / || !/ @ rows / {next}
    {
        split($0, field, / @ /)
        sub(/^rows /, "", field[3])
        parts = split(field[3], part, / [\/] /)
        worst["double"] = worst["float"] = points = 0
        for (i = 1; i <= n; i++) {
            split(row[i], k, "\t")
            if (k[1] != part[1] || k[3] !~ "^(" part[2] ")$" || k[5] !~ "^(" part[3] ")$") continue
            if (parts > 3 && k[4] !~ "^(" part[4] ")$") continue
            if (k[6] + 0 > worst[k[2]] + 0) worst[k[2]] = k[6]
            points += k[8]
        }
        sub(/^manual: /, "the manual, ", field[1])
        sub(/^docs.accuracy.md: /, "docs/accuracy.md, ", field[1])
        if (field[1] !~ /^(the|docs)/) field[1] = "`" field[1] "`"
        line = "| " field[1] " | " field[2] " | " worst["double"] " | " worst["float"] " | " points " | tests/test_" part[1] ".c |"
        print line
    }' "$1/promises/rows" tests/promises.txt
