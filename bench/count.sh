#!/bin/sh
# Instructions of a call of every public function, counted by callgrind, so that they are the same in every run.
# usage: CC=compiler FLAGS=flags count.sh FOLDER, with FOLDER/double and FOLDER/float from bench/count.c; the table
# goes to FOLDER/counts.md and to the screen. Where a program, valgrind or callgrind_annotate fails, or a function has
# no count above that of the empty loop, the script fails with a reason and there is no FOLDER/counts.md.
folder=$1
fail() {
    echo "count.sh: $*" >&2
    exit 1
}

count() { # count PRECISION : FOLDER/PRECISION.counts, of lines "calls NUMBER" and "function instructions"
    out=$folder/$1
    LD_BIND_NOW=1 valgrind --tool=callgrind --callgrind-out-file="$out.out" "$out" \
        >"$out.said" 2>"$out.errors" ||
        fail "valgrind $out ended with status $?: $(tail -n 1 "$out.errors")"
    grep -Eq '^[1-9][0-9]* calls$' "$out.said" || fail "$out did not say how many calls it made"
    callgrind_annotate --inclusive=yes --threshold=100 "$out.out" >"$out.annotated" 2>"$out.errors" ||
        fail "callgrind_annotate $out.out ended with status $?: $(tail -n 1 "$out.errors")"
    {
        awk '{print "calls", $1}' "$out.said"
        awk 'match($0, /:count_[a-z]/) {
            instructions = $1
            gsub(/,/, "", instructions)
            name = substr($0, RSTART + 7)
            sub(/ .*/, "", name)
            sub(/\.(constprop|part|isra).*/, "", name)
            print name, instructions
        }' "$out.annotated"
    } >"$out.counts"
}

table() { # the rows, in the order of bench/count.c; fails where a number is missing or cannot be one
    names=$(grep -o '^COUNT([a-z0-9_A-Z]*\|^SEPARATE static void count_[a-z_]*' bench/count.c |
        sed 's/^COUNT(//; s/.*count_//')
    awk -v order="$names" '
        $1 == "calls" {precision++; calls[precision] = $2; next}
        {instructions[$1, precision] = $2}
        END {
            n = split(order, name, "\n")
            for (i = 1; i <= n; i++) {
                if (name[i] == "nothing") continue
                row = "| `" name[i] "` |"
                loop = name[i] ~ /array/ ? 0 : 1
                for (p = 1; p <= 2; p++) {
                    counted = instructions[name[i], p]
                    empty = instructions["nothing", p]
                    if (counted !~ /^[0-9]+$/ || empty !~ /^[1-9][0-9]*$/ || counted <= loop * empty) {
                        print "count.sh: " name[i] " has no count (" counted ", the empty loop " empty ")" \
                            >"/dev/stderr"
                        exit 1
                    }
                    row = row sprintf(" %.0f |", (counted - loop * empty) / calls[p])
                }
                print row
                rows++
            }
            if (rows == 0) {
                print "count.sh: no function was found in bench/count.c" >"/dev/stderr"
                exit 1
            }
        }' "$folder/double.counts" "$folder/float.counts"
}

rm -f "$folder/counts.md"
for precision in double float; do
    echo "callgrind: $precision" >&2
    count $precision
done
table >"$folder/rows" || exit 1
compiler=$($CC --version) || fail "the compiler $CC does not say its version"
{
    echo '# Instructions of a call'
    echo
    echo "The command \`make counts\` writes this page. The processor was an $(uname -m), and the compiler was $(echo "$compiler" | head -n 1)"
    echo "with $FLAGS."
    echo "The table says for each function how many machine instructions a call executes. The instructions were counted by callgrind, a tool"
    echo "of the program valgrind. Each number is the mean of 200 calls (for functions of arrays, the mean for one of the 200 values that a"
    echo "call computes); it is the same in every run, because all runs use the same arguments. In some rows the name of the function has an"
    echo "addition that says how it was called. For example, \`ateb_plan_saca_4_3\` is a call of \`ateb_plan_saca\` with a plan for alpha = 4/3,"
    echo "where alpha is the exponent of the Ateb functions, and the addition _to_1e_3 stands for a tolerance of 1e-3. The file"
    echo "bench/count.c has all calls and their arguments. In the rows of the integrators (rk4, rk45, rk87), a call computes one step of the"
    echo "solution of x'' = -x^3."
    echo
    echo '| function | double | float |'
    echo '|---|---|---|'
    cat "$folder/rows"
} >"$folder/counts.md"
cat "$folder/counts.md"
