#!/bin/sh
# Bring the tables and figures of docs/cost.md up to date from the last run of make bench. In the document a table
# stands between the lines <!-- table NAME --> and <!-- end -->.
# usage: cost.sh FOLDER FIGURES DOCUMENT DOCUMENT_FIGURES, FOLDER with the programs' CSV files
folder=$1 figures=$2 document=$3 document_figures=$4
tables=$folder/tables
mkdir -p "$tables"

{ echo '```'; cat "$folder/machine"; echo '```'; } >"$tables/machine"
sh bench/summary.sh "$folder" markdown >"$tables/summary" || exit 1
sh bench/goals.sh "$folder" docs/counts.md >"$tables/goals" || exit 1

# routes PROGRAM JOB : error, ns and ratio of each route to a job, in double, float and with -O3 -march=native
routes() {
    echo '| by | double: error | ns | x sin | -O3 -march=native: ns | float: error | ns | x sinf |'
    echo '|---|---|---|---|---|---|---|---|'
    for kind in "" _float _wide; do sed "s/^/${kind:-double},/" "$folder/$1$kind.csv"; done | awk -F, -v job="$2" '
        function row(a, b, c, d, e, f, g, h) {print "| `" a "` | " b " | " c " | " d " | " e " | " f " | " g " | " h " |"}
        $3 == job && $4 !~ /chain/ {
            key = $4 ($5 != "" ? ", " $5 : "")
            if (!(key in seen)) {seen[key] = 1; order[++n] = key}
            error[key, $1] = $6
            ns[key, $1] = sprintf($7 < 100 ? "%.1f" : "%.0f", $7)
            ratio[key, $1] = sprintf("%.3g", $8)
        }
        END {
            for (i = 1; i <= n; i++) {
                k = order[i]
                row(k, error[k, "double"], ns[k, "double"], ratio[k, "double"], ns[k, "_wide"], error[k, "_float"],
                    ns[k, "_float"], ratio[k, "_float"])
            }
        }'
}
routes jacobi 'sncndn; |u| < 2K; m = 0.5' >"$tables/jacobi"
routes ateb 'saca; |s| < 10; alpha = 3' >"$tables/ateb"
routes ateb 'saca; |s| < 10; alpha = 1.333' >"$tables/ateb_power"

awk -F, '
    BEGIN {print "| problem | by | to 1e-4 | 1e-6 | 1e-8 | 1e-10 |\n|---|---|---|---|---|---|"}
    $9 == "dp54_loop" {
        split($2, part, " to ")
        key = part[1] " | `" $3 "`"
        if (!(key in seen)) {seen[key] = 1; order[++n] = key}
        cell[key, part[2]] = sprintf("%.3g (%.2f)", $6/1000, $7)
    }
    END {
        for (i = 1; i <= n; i++) {
            printf "| %s |", order[i]
            for (goal = 4; goal <= 10; goal += 2) printf " %s |", cell[order[i], "1e-" goal]
            print ""
        }
    }' "$folder/integrators.csv" >"$tables/integrators"

awk -F, '
    BEGIN {print "| effects | by hand | inline functions | scene |\n|---|---|---|---|"}
    NR > 1 {
        if (!($2 in seen)) {seen[$2] = 1; order[++n] = $2}
        ns[$2, $3] = sprintf("%.1f", $6)
    }
    END {
        for (i = 1; i <= n; i++) {
            k = order[i]
            if (k !~ /^(no effect|[0-9]: )/) continue
            print "| " k " | " ns[k, "by hand"] " | " ns[k, "inline functions"] " | " ns[k, "scene"] " |"
        }
    }' "$folder/scenes.csv" >"$tables/scenes"

awk -F, '
    BEGIN {print "| an effect beside a damper | adds, x sin | adds without its arithmetic, x sin |\n|---|---|---|"}
    $3 == "adds to a scene" {all = $7}
    $3 == "adds beyond its arithmetic" {gsub(/;/, ",", $2); printf "| %s | %.2f | %.2f |\n", $2, all, $7}
    ' "$folder/scenes.csv" >"$tables/effects"

awk -F, '
    BEGIN {print "| bodies in a chain | ns a body |\n|---|---|"}
    $2 ~ /^a body of a chain/ {sub(/.* /, "", $2); printf "| %s | %.1f |\n", $2, $6}
    ' "$folder/scenes.csv" >"$tables/chain"

awk -F, '
    BEGIN {print "| level | by | no stream | 1 | 4 |\n|---|---|---|---|---|"}
    NR > 1 && $9 == "by hand" {
        key = $2 " | `" $3 "`"
        gsub(/;/, ",", key)
        if (!(key in seen)) {seen[key] = 1; order[++n] = key}
        cell[key, $4] = sprintf("%.1f (%.2f)", $6, $7)
    }
    END {
        for (i = 1; i <= n; i++) {
            k = order[i]
            print "| " k " | " cell[k, 0] " | " cell[k, 1] " | " cell[k, 4] " |"
        }
    }' "$folder/streams.csv" >"$tables/streams"

for table in oscillator oscillator_all rotation; do sh bench/motion_tables.sh "$folder" $table >"$tables/$table"; done

awk -v tables="$tables" '
    /^<!-- end -->/ {inside = 0}
    !inside {print}
    /^<!-- table / {
        inside = 1
        while ((getline line <(tables "/" $3)) > 0) print line
    }' "$document" >"$document.new" && mv "$document.new" "$document"
cp "$figures"/cost_*.svg "$document_figures"
echo "wrote $document and $document_figures/cost_*.svg"
