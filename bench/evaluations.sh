#!/bin/sh
# Random evaluations of every special function in both precisions, a row of the table at a time. For each row a program of its own
# is compiled. A row that came to its end has a line in tests/evaluations/kept.txt with a checksum of its program's machine code,
# and is not run again while this code stays as it is. So a run of hours that was broken off goes on where it was, also in another
# checkout, and a change of the headers repeats only the rows that it concerns. When all rows are there, docs/evaluations.md is
# written.
# usage: evaluations.sh BUILD COUNT SEED [FIRST LAST], from the top of the project: COUNT evaluations of each function, of slow
#        ones COUNT/10; rows FIRST to LAST alone, counted from 1
folder=$1/evaluations count=$2 seed=$3 first=${4:-1} last=${5:-1000} kept=tests/evaluations/kept.txt
mkdir -p "$folder" && echo '*' >"$1/.gitignore" || exit 1
compile="${CC:-cc} -std=c99 -O2 -fopenmp"

row() { # row PRECISION LINE: runs this row unless it is there
    program=$folder/row flags=
    [ "$1" = float ] && flags=-DVM_USE_FLOAT
    $compile $flags -DROW="$2" -c tests/evaluations.c -o "$program.o" || return 1
    code="COUNT=$count SEED=$seed machine code $(cksum <"$program.o")"
    grep -sqF "$1 $2: $code: " $kept && return
    $compile "$program.o" -o "$program" -lm || return 1
    result=$("$program" "$count" "$seed" "$2") || { echo "$result"; return 1; }
    sh tests/keep_line.sh $kept "$1 $2" "$code" "$result"
}
$compile tests/evaluations.c -o "$folder/all" -lm || exit 1
"$folder/all" rows >"$folder/rows"
rows=$(wc -l <"$folder/rows")
[ "$last" -le "$rows" ] || last=$rows
for precision in double float; do
    line=$first
    while [ "$line" -le "$last" ]; do
        row $precision "$line" || exit 1
        line=$((line + 1))
    done
done

[ "$first" = 1 ] && [ "$last" = "$rows" ] || { echo "evaluations: rows $first to $last of $rows are there"; exit; }
line=1
: >"$folder/table"
while [ $line -le "$rows" ]; do
    sed -n "s/^[a-z]* $line: .*: //p" $kept | paste -s -d '|' - |
        awk -F'|' '{print "| " $1 " | " $2 " | " $5 " | " $3 + $6 " |"}' >>"$folder/table"
    line=$((line + 1))
done
sed "s/@COUNT@/$count/; s/@SEED@/$seed/" bench/evaluations.md | sed -e "/@TABLE@/{r $folder/table" -e 'd;}' >docs/evaluations.md
sh bench/stamp.sh write evaluations
echo "all rows: $rows in double and $rows in float, $count evaluations each (of slow functions a tenth), 0 violations"
