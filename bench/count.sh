#!/bin/sh
# Instructions of a call of every public function, counted by callgrind, so that they are the same in every run.
# usage: CC=compiler FLAGS=flags count.sh FOLDER, with FOLDER/double and FOLDER/float from bench/count.c; the table
# goes to FOLDER/counts.md and to the screen
folder=$1
count() { # count PRECISION : lines "function instructions"
    LD_BIND_NOW=1 valgrind --tool=callgrind --callgrind-out-file="$folder/$1.out" "$folder/$1" 2>/dev/null |
        awk '{print "calls", $1}'
    callgrind_annotate --inclusive=yes --threshold=100 "$folder/$1.out" |
        awk 'match($0, /:count_[a-z]/) {
            instructions = $1
            gsub(/,/, "", instructions)
            name = substr($0, RSTART + 7)
            sub(/ .*/, "", name)
            sub(/\.(constprop|part|isra).*/, "", name)
            print name, instructions
        }'
}
for precision in double float; do
    echo "callgrind: $precision" >&2
    count $precision >"$folder/$precision.counts"
    grep -q '^calls' "$folder/$precision.counts" || { echo "$folder/$precision did not come to its end" >&2; exit 1; }
done
{
    echo '# Instructions of a call'
    echo
    echo "Written by \`make bench-count\`: $(uname -m), $($CC --version | head -n 1), $FLAGS, counted by callgrind, the same in every"
    echo 'run. Means over 200 calls, with arguments as bench/count.c has them; a step of x'"''"' = -x^3 for the integrators.'
    echo
    echo '| function | double | float |'
    echo '|---|---|---|'
    awk -v order="$(grep -o '^COUNT([a-z0-9_A-Z]*\|^SEPARATE static void count_[a-z_]*' bench/count.c | sed 's/^COUNT(//; s/.*count_//')" '
        $1 == "calls" {file++; calls = $2; next}
        {instructions[$1, file] = $2}
        END {
            n = split(order, name, "\n")
            for (i = 1; i <= n; i++) {
                if (name[i] == "nothing") continue
                printf "| `%s` |", name[i]
                loop = name[i] ~ /array/ ? 0 : 1
                for (f = 1; f <= 2; f++)
                    printf " %.0f |", (instructions[name[i], f] - loop*instructions["nothing", f])/calls
                print ""
            }
        }' "$folder/double.counts" "$folder/float.counts"
} | tee "$folder/counts.md"
