#!/bin/sh
# The measured numbers that texts written by hand may name, each from one place, as a table: docs/numbers.md.
#
# In Markdown a mark follows the number, 272<!--hard_cases-->; in the manuals it follows in brackets, 304 [jacobi_plan_bytes].
# tests/check_docs.sh fails where a marked number differs from the table by more than the rounding of its last digit.
#
#   numbers.sh table          prints the table
#   numbers.sh check FILE...  prints the marked numbers that differ from docs/numbers.md, and fails if there are any
#   numbers.sh write FILE...  sets the marked numbers to the table's values, with as many digits as they have
#
# from the top of the project; NUMBERS_ROOT is another folder that has docs/
root=${NUMBERS_ROOT:-.}

# A row of the table for each call; VALUE is what the command prints.
number() { # number NAME "WHERE IT IS FROM" COMMAND...
    name=$1 from=$2
    shift 2
    value=$("$@")
    case $value in
    "" | *[!0-9.e+-]*) echo "numbers.sh: no number for $name: '$value'" >&2; exit 1 ;;
    esac
    echo "| $name | $value | $from |"
}
# Cells: rows of docs/DOCUMENT.md whose text matches, their COLUMN's Nth number; of several rows the least or the most
cell() { # cell least|most DOCUMENT ROWS COLUMN [N]
    awk -F' [|] ' -v which="$1" -v rows="$3" -v column="$4" -v nth="${5:-1}" '
        index($0, "| ") == 1 && $0 ~ rows {
            text = $column
            for (i = 1; i <= nth && match(text, /[0-9]+([.][0-9]+)?(e[-+]?[0-9]+)?/); i++) {
                value = substr(text, RSTART, RLENGTH)
                text = substr(text, RSTART + RLENGTH)
            }
            if (i <= nth) next
            if (best == "" || (which == "least" ? value + 0 < best + 0 : value + 0 > best + 0)) best = value
        }
        END {print best}' "$root/docs/$2.md"
}
# Worst errors in double: rows of docs/DOCUMENT.md, a table by bench/measurements.sh, whose functions match
worst() { # worst DOCUMENT PROGRAM UNIT BOUND FUNCTIONS
    awk -F' [|] ' -v program="| $2" -v unit="$3" -v bound="$4" -v functions="(^|; )($5)(; |$)" '
        $1 == program && $2 == unit && $3 == bound && $4 ~ functions && $5 + 0 > most + 0 {most = $5}
        END {print most}' "$root/docs/$1.md"
}
# Rows of docs/hard-cases.md: all, those without a number of the naive formula, those 1000 times worse or without
hard_cases() { # hard_cases all|none|worse
    awk -F' *[|] *' -v which="$1" '
        /^\| / && $2 != "what would go wrong" {
            n["all"]++
            if ($7 == "no number") n["none"]++
            if ($7 == "no number" || $7 >= 1000 * $5) n["worse"]++
        }
        END {print n[which] + 0}' "$root/docs/hard-cases.md"
}
# Time of a route over that of a peer, over the problems that match, in the table of integrators of docs/cost.md
ratio() { # ratio least|most PROBLEMS COLUMN ROUTE PEER
    awk -F' *[|] *' -v which="$1" -v problems="^($2)\$" -v column="$3" -v route="\`$4\`" -v peer="\`$5\`" '
        /^<!-- table integrators/ {on = 1}
        /^<!-- end/ {on = 0}
        on && $2 ~ problems && ($3 == route || $3 == peer) {time[$2, $3] = $column + 0; seen[$2] = 1}
        END {
            for (p in seen) {
                ratio = time[p, route] / time[p, peer]
                if (best == "" || (which == "least" ? ratio < best : ratio > best)) best = ratio
            }
            printf "%.3g\n", best
        }' "$root/docs/cost.md"
}

worst_of() { # worst_of NAME and what worst wants, WHAT
    number "$1" "docs/$2.md: worst error in double ($4) of $7, rows of $3 with the bound $5 $4" worst "$2" "$3" "$4" "$5" "$6"
}
promise() { # promise NAME "ENTRY OF THE MANUAL" BOUND : the worst error in double
    number "$1" "docs/promises.md: worst error in double, row \"the manual, $2\" with the bound $3" cell most promises "^[|] the manual, $2 [|] $3 [|]" 3
}
# a column of the row that a job and a route name in the table "In short" of docs/cost.md: 3 error, 4 ns, 5 ratio
in_short() { # in_short NAME "JOB" "ROUTE" COLUMN
    rows="^[|] [^|]* [|] $2 [|] \`$3\`"
    of=$(awk -F' [|] ' -v rows="$rows" '$0 ~ rows {print $2; exit}' "$root/docs/cost.md")
    what=$([ "$4" = 3 ] && echo error || echo ratio)
    number "$1" "docs/cost.md, \"In short\": $what in the row \"$of\", \`$3\`" cell least cost "$rows" $(($4 + 1))
}
ratios() { # ratios NAME PROBLEMS COLUMN ROUTE PEER HEAD : NAME_least and NAME_most
    of=$(echo "$2" | sed 's/[|]/, /g')
    number "$1_least" "docs/cost.md, \"Integrators\", column \"$6\": smallest ratio of the time of \`$4\` to that of \`$5\` in the problems $of" ratio least "$2" "$3" "$4" "$5"
    number "$1_most" "docs/cost.md, \"Integrators\", column \"$6\": largest ratio of the time of \`$4\` to that of \`$5\` in the problems $of" ratio most "$2" "$3" "$4" "$5"
}
# the law of an order at once and from a plan, in the table of oscillators of docs/cost.md: error, µs, ns
law_numbers() { # law_numbers ORDER
    number "order$1_error" "docs/cost.md, first table of \"Oscillators\": error in the row \`vm_osc_by_route order $1\`" cell least cost "^[|] .vm_osc_by_route order $1. [|] [^|]* µs [|]" 2 1
    number "order$1_time" "docs/cost.md, first table of \"Oscillators\": time in µs in the row \`vm_osc_by_route order $1\`" cell least cost "^[|] .vm_osc_by_route order $1. [|] [^|]* µs [|]" 2 2
    # a plan's time stands in ns there
    number "order$1_plan_time" "docs/cost.md, first table of \"Oscillators\": time in µs in the row \`vm_osc_plan_by_route order $1\`" plan_time "$1"
}
plan_time() {
    ns=$(cell least cost "^[|] .vm_osc_plan_by_route order $1. [|] [^|]* ns [|]" 2 2)
    awk -v ns="$ns" 'BEGIN {if (ns > 0) print ns / 1000}'
}
coverage() { awk -F' [|] ' -v column="$1" '$1 ~ /^[|] [a-z]+[.]h$/ && $3 ~ /%/ && $5 ~ /%/ {if (least == "" || $column + 0 < least) least = $column + 0}
    END {print least}' "$root/docs/reliability.md"; }
size_of() { # size_of "FLAGS" HEADER TYPE : bytes of a type, by the compiler
    program=${BUILD:-build}/numbers/size
    mkdir -p "${program%/*}" || return 1
    printf '#include <stdio.h>\n#include "%s"\nint main(void) { printf("%%d\\n", (int)sizeof(%s)); return 0; }\n' "$2" "$3" >"$program.c"
    ${CC:-cc} -std=c99 $1 -I"$root" "$program.c" -o "$program" -lm && "$program"
}

table() {
    hard='docs/hard-cases.md'
    number hard_cases "$hard: number of rows of all tables" hard_cases all
    number hard_cases_no_number "$hard: number of rows with \"no number\" for the naive formula in double" hard_cases none
    number hard_cases_thousand "$hard: number of rows whose naive error in double is 1000 or more times the error, or no number" hard_cases worse

    worst_of K_error scan scan ulp 2 K K
    worst_of E_error scan scan ulp 2 E E
    worst_of sncndn_eps scan scan eps 4 'sn|cn|dn' 'sn, cn and dn'
    worst_of sncndn_ulp scan scan ulp 9 'sn|cn|dn' 'sn, cn and dn'
    worst_of solve_kpK_error scan scan ulp 4 'solve_kpK(_m1)?' 'solve_kpK and solve_kpK_m1'
    worst_of ateb_pi_error scan scan ulp 1 Pi Pi
    worst_of saca_eps scan scan eps 4 'sa|ca' 'sa and ca'
    worst_of saca_ulp scan scan ulp 8 'sa|ca' 'sa and ca'
    worst_of ateb_plan_ulp scan scan ulp 2 'plan sa|plan ca' 'plan sa and plan ca'
    promise jump_momentum Jumps '3 eps'
    promise jump_angular_momentum Jumps '6 eps'
    promise rotation_attitude Rotation '8 eps'
    promise rotation_omega Rotation '5 eps'
    promise lambert_error "Lambert's W" '1 ulp'

    in_short K_time 'K, 0 < m < 1' jacobi_K 5
    in_short E_time 'E, 0 < m < 1' jacobi_E 5
    in_short sncndn_time_near 'sncndn, .*K/2, .*' jacobi_sncndn 5
    in_short sncndn_time_2K 'sncndn, .*2K, 0.5 < m < 1' jacobi_sncndn 5
    in_short sncndn_time_far 'sncndn, .*1e9, .*' jacobi_sncndn 5
    in_short jacobi_plan_time 'sncndn, .*2K, m = 0.5' jacobi_plan_sncndn 5
    in_short jacobi_plan_array_time 'sncndn, .*2K, m = 0.5' jacobi_plan_sncndn_array 5
    in_short solve_kpK_time 'm of k.K = c, 1.32 < c < 1.85' jacobi_solve_kpK 5
    in_short ateb_pi_time 'Pi, 0 < alpha < 5' ateb_pi 5
    in_short saca_time 'saca, .* alpha = 3' ateb_saca 5
    in_short ateb_plan_time 'saca, .* alpha = 3' ateb_plan_saca 5
    in_short ateb_plan_array_time 'saca, .* alpha = 3' ateb_plan_saca_array 5
    in_short ateb_plan_power_time 'saca, .* alpha = 1.333' ateb_plan_saca 5
    in_short rotation_error 'triaxial 1e6' exact 3
    in_short rotation_sines 'triaxial 1e6' exact 5
    number rotation_time "docs/cost.md, \"Free rotation\": time in µs, row \`exact\`, column \"1e6 turns\"" cell least cost '^[|] `exact` ' 5 2
    number rotation_gsl_error "docs/cost.md, \"Free rotation\": error in rad, row \`GSL rk8pd\`, 1e-09, column \"1e6 turns\"" cell least cost 'GSL rk8pd`, 1e-09' 5 1
    number rotation_gsl_time "docs/cost.md, \"Free rotation\": time in s, row \`GSL rk8pd\`, 1e-09, column \"1e6 turns\"" cell least cost 'GSL rk8pd`, 1e-09' 5 2

    number cn_corrected_error "docs/cost.md, first table of \"Oscillators\": error in the row \`cn corrected\`" cell least cost '^[|] `cn corrected`' 2 1
    number cn_corrected_time "docs/cost.md, first table of \"Oscillators\": time in ns in the row \`cn corrected\`" cell least cost '^[|] `cn corrected`' 2 2
    number oscillator_gsl_2 "docs/cost.md, first table of \"Oscillators\": time in µs, row \`GSL rk8pd\`, column \"1e-2\"" cell least cost '^[|] `GSL rk8pd` [|]' 3
    number oscillator_gsl_8 "docs/cost.md, first table of \"Oscillators\": time in µs, row \`GSL rk8pd\`, column \"1e-8\"" cell least cost '^[|] `GSL rk8pd` [|]' 6
    number oscillator_gsl_10 "docs/cost.md, first table of \"Oscillators\": time in µs, row \`GSL rk8pd\`, column \"1e-10\"" cell least cost '^[|] `GSL rk8pd` [|]' 7
    law_numbers 3
    law_numbers 5
    power='^[|] alpha=4/3 psi0=0[.]7 eps=0[.]01 [|].*[|] `vm_osc_by_route order [345]` [0-9.]+ µs; GSL [0-9.]+ ms [|]'
    number power_time "docs/cost.md, second table of \"Oscillators\": time in µs of \`vm_osc_by_route\`, row \"alpha=4/3 psi0=0.7 eps=0.01\", column \"1e-8\"" cell least cost "$power" 5 2
    number power_gsl_time "docs/cost.md, second table of \"Oscillators\": time in ms of GSL, row \"alpha=4/3 psi0=0.7 eps=0.01\", column \"1e-8\"" cell least cost "$power" 5 3
    number oscillator_rk87_8 "docs/cost.md, first table of \"Oscillators\": time in µs, row \`rk87_solve\`, column \"1e-8\"" cell least cost '^[|] `rk87_solve` [|]  [|]' 6

    all='cubic|mass|momentum|body|orbit' smooth='cubic|mass|momentum|body'
    ratios rk4_loop "$all" 5 rk4_solve rk4_loop 1e-6
    ratios rk45_loop "$all" 5 rk45_solve dp54_loop 1e-6
    ratios rk45_gsl "$all" 5 rk45_solve gsl_rkf45 1e-6
    ratios rk87_gsl "$smooth" 7 rk87_solve gsl_rk8pd 1e-10
    number rk87_gsl_orbit "docs/cost.md, \"Integrators\", column \"1e-8\": ratio of the time of \`rk87_solve\` to that of \`gsl_rk8pd\` in the problem orbit" ratio least orbit 6 rk87_solve gsl_rk8pd

    number effect_least "docs/cost.md, \"Scenes and streams\", column \"adds without its arithmetic\": ratio in the row \"linear spring\"" cell least cost '^[|] linear spring [|]' 3
    effects='linear spring|cubic spring|second damper|Van der Pol|gravity|motor|harmonic|own force|mass of time'
    number effect_most "docs/cost.md, \"Scenes and streams\", column \"adds without its arithmetic\": largest ratio of the effects that compute no power" cell most cost "^[|] ($effects) [|]" 3
    chain='^[|] 10* [|] [0-9.]+ [|]$'
    number chain_least "docs/cost.md, \"Scenes and streams\", column \"ns a body\": smallest value" cell least cost "$chain" 2
    number chain_most "docs/cost.md, \"Scenes and streams\", column \"ns a body\": largest value" cell most cost "$chain" 2
    number spring_flash "docs/scene-sizes.md, column M4F: bytes in the row \"a linear spring\" minus those in the row \"a body on a line, nothing acts\"" spring_flash
    closed='^[|] `vm_osc_closed_at [(]order 5[)]`'
    number closed_flash "docs/firmware.md, float, column M4F: flash in bytes in the row \`vm_osc_closed_at (order 5)\`" cell least firmware "$closed" 3 1
    number closed_stack "docs/firmware.md, float, column M4F: stack in bytes in the row \`vm_osc_closed_at (order 5)\`" cell least firmware "$closed" 3 2
    number closed_instructions "docs/firmware.md, float, column M4F: instructions in the row \`vm_osc_closed_at (order 5)\`" cell least firmware "$closed" 3 3
    plan='^[|] `ateb_plan_saca [(]alpha = 3[)]`'
    number saca_plan_instructions "docs/firmware.md, float, column M4F: instructions in the row \`ateb_plan_saca (alpha = 3)\`" cell least firmware "$plan" 3 3
    number saca_plan_instructions_double "docs/firmware.md, double, column M4F: instructions in the row \`ateb_plan_saca (alpha = 3)\`" cell most firmware "$plan" 3 3
    number saca_plan_instructions_m7 "docs/firmware.md, double, column M7: instructions in the row \`ateb_plan_saca (alpha = 3)\`" cell most firmware "$plan" 4 3
    number amplitude_instructions "docs/firmware.md, float, column M4F: instructions in the row \`vm_osc_amplitude_law\`" cell least firmware '^[|] `vm_osc_amplitude_law`' 3 3
    number coverage_lines "docs/reliability.md, first table: smallest percentage of the headers in the column \"executed\"" coverage 3
    number coverage_outcomes "docs/reliability.md, first table: smallest percentage of the headers in the column \"taken\"" coverage 5
    number jacobi_plan_bytes "the compiler: sizeof of a \`jacobi_plan\` in double" size_of "" jacobi.h jacobi_plan
    number jacobi_plan_bytes_float "the compiler: sizeof of a \`jacobi_plan\` in float" size_of -DVM_USE_FLOAT jacobi.h jacobi_plan
    number ateb_plan_bytes "the compiler: sizeof of an \`ateb_plan\` in double" size_of "" ateb.h ateb_plan
    number ateb_plan_bytes_float "the compiler: sizeof of an \`ateb_plan\` in float" size_of -DVM_USE_FLOAT ateb.h ateb_plan
}
spring_flash() {
    awk -F' [|] ' '$1 ~ /nothing acts$/ && !n++ {bare = $3 + 0} $1 == "| a linear spring" {print $3 - bare}' "$root/docs/scene-sizes.md"
}

# Each mark of the files: the number before it and the table's value, rounded as the number is
marks() { # marks check|write FILE
    awk -v mode="$1" -v list="$root/docs/numbers.md" '
        # the value with as many digits as the text has: digits after the point, or after that of a power of ten
        function rounded(value, text,    mantissa, digits, point) {
            mantissa = text
            sub(/e.*/, "", mantissa)
            point = index(mantissa, ".")
            digits = point ? length(mantissa) - point : 0
            if (text ~ /e/) {
                value = sprintf("%." digits "e", value)
                sub(/e-0/, "e-", value)
                sub(/e[+]0?/, "e", value)
                return value
            }
            return sprintf("%." digits "f", value)
        }
        # is the text the value, rounded to the digits that the text has? A tie may go either way.
        function is_rounded(value, text,    mantissa, unit, point) {
            mantissa = text
            unit = 1
            if (text ~ /e/) {
                unit = ("1" substr(text, index(text, "e"))) + 0
                sub(/e.*/, "", mantissa)
            }
            point = index(mantissa, ".")
            if (point) unit /= 10 ^ (length(mantissa) - point)
            return text - value <= 0.500001 * unit && value - text <= 0.500001 * unit
        }
        BEGIN {
            while ((getline line <list) > 0)
                if (split(line, cell, / *[|] */) > 3 && cell[3] ~ /^[0-9]/) value[cell[2]] = cell[3]
            mark = "[0-9]+([.][0-9]+)?(e-?[0-9]+)?(<!--[a-zA-Z_0-9]+-->| \\[[a-zA-Z]+_[a-zA-Z_0-9]+\\])"
        }
        {
            rest = $0
            out = ""
            while (match(rest, mark)) {
                whole = substr(rest, RSTART, RLENGTH)
                match(whole, /^[0-9.e-]+/)
                text = substr(whole, 1, RLENGTH)
                sub(/<!--$|-*$/, "", text)
                name = substr(whole, length(text) + 1)
                shown = name
                gsub(/[^a-zA-Z_0-9]/, "", name)
                match(rest, mark)
                if (!(name in value)) {
                    print FILENAME ":" FNR ": no number of this name in docs/numbers.md: " name >"/dev/stderr"
                    failed = 1
                    right = text
                } else {
                    right = is_rounded(value[name], text) ? text : rounded(value[name], text)
                    if (right != text && mode == "check") {
                        print FILENAME ":" FNR ": " name " is " value[name] ", and not " text >"/dev/stderr"
                        failed = 1
                    }
                }
                out = out substr(rest, 1, RSTART - 1) right shown
                rest = substr(rest, RSTART + RLENGTH)
            }
            if (mode == "write") print out rest
        }
        END {exit failed + 0}' "$2"
}

mode=$1
shift
case $mode in
table)
    printf '# Measured numbers\n\nThis page is written by `make numbers` (bench/numbers.sh).\n\n'
    printf 'The table has the measured numbers that the README, the manuals and some other documents show. There, a mark with the name of the number follows each\n'
    printf 'number. The column "from" says from which document a value was copied, and from which table, row and column. A name in quotation\n'
    printf "marks after the document is the heading of a section. A ratio is a time divided by the time of one call of the C library's\n"
    printf '`sin`, or by the time of another integrator, which is then named.\n\n'
    printf '| name | value | from |\n|---|---|---|\n'
    table
    ;;
check)
    failures=0
    for file in "$@"; do marks check "$file" || failures=1; done
    exit $failures
    ;;
write)
    for file in "$@"; do
        marks write "$file" >"$file.new" || { rm "$file.new"; exit 1; }
        if cmp -s "$file" "$file.new"; then rm "$file.new"; else mv "$file.new" "$file"; fi
    done
    ;;
*) echo "numbers.sh: no such mode: $mode" >&2; exit 2 ;;
esac
