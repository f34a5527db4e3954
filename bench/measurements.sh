#!/bin/sh
# Write a document of worst errors: a row for each bound that a program of tests enforces, with the functions it is for and
# the worst error found, in double and in float. The full tables stay in build/.
# usage: measurements.sh bound|function LOG... <TEXT, from the top of the project; prints the text and then the table. LOGs
# are what the programs print (build/tests/NAME.log). With "function" each function has rows of its own.
by=$1
shift
cat
echo
echo '| program | unit | bound | functions | double: worst | of which | float: worst | of which |'
echo '|---|---|---|---|---|---|---|---|'
for log in "$@"; do
    awk -f tests/rows.awk "$log" | awk -F '\t' -v program="$(basename "$log" .log)" -v by="$by" '
        function value(x) { return x ~ /nan|inf/ ? 1e300 : x + 0 }
        function cell(group, precision,    key) {
            key = group SUBSEP precision
            return key in worst ? worst[key] " | " of_which[key] : "- | -"
        }
        $5 ~ /^(eps|ulp)/ {
            gsub(/[|]/, "\\\\|")
            group = $5 SUBSEP $7 (by == "function" ? SUBSEP $3 : "")
            if (!(group in functions)) order[++n] = group
            if (!((group, $3) in seen)) {
                seen[group, $3] = 1
                functions[group] = functions[group] (functions[group] == "" ? "" : "; ") $3
            }
            key = group SUBSEP $2
            if (!(key in worst) || value($6) > value(worst[key])) {
                worst[key] = $6
                of_which[key] = $3 ($4 == "-" ? "" : ": " $4)
            }
        }
        END {
            for (i = 1; i <= n; i++) {
                split(order[i], part, SUBSEP)
                printf "| %s | %s | %s | %s | %s | %s |\n", program, part[1], part[2], functions[order[i]],
                    cell(order[i], "double"), cell(order[i], "float")
            }
        }'
done
