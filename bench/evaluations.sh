#!/bin/sh
# Random evaluations of every special function in both precisions, a row of the table at a time. A row that came to its end is
# kept in BUILD/evaluations with the stamp of the headers (bench/stamp.sh) that have its functions, and is not run again while they
# stay as they are. So a run of hours that was broken off goes on where it was. When all rows are there, docs/evaluations.md is
# written.
# usage: evaluations.sh BUILD COUNT SEED [FIRST LAST], from the top of the project: COUNT evaluations of each function, of slow
#        ones COUNT/10; rows FIRST to LAST alone, counted from 1
folder=$1/evaluations count=$2 seed=$3 first=${4:-1} last=${5:-1000}
mkdir -p "$folder" && echo '*' >"$1/.gitignore" || exit 1
ateb=$(sh bench/stamp.sh of ateb jacobi) all=$(sh bench/stamp.sh of ateb jacobi varmass)

run_of() { # run_of LINE: what is run in this row; only Lambert's function is in varmass.h
    case $(sed -n "$1p" "$folder/rows") in
    Lambert*) echo "COUNT=$count SEED=$seed $all" ;;
    *) echo "COUNT=$count SEED=$seed $ateb" ;;
    esac
}
is_there() { [ "$(head -n 1 "$folder/$1.$2" 2>/dev/null)" = "$(run_of "$2")" ]; } # is_there PRECISION LINE: this row has been run
row() { # row PRECISION LINE: runs this row unless it is there
    kept=$folder/$1.$2
    is_there "$1" "$2" && return
    { run_of "$2" && "$folder/$1" "$count" "$seed" "$2"; } >"$kept.new" || { cat "$kept.new"; return 1; }
    mv "$kept.new" "$kept"
}
for precision in double float; do
    flags=
    [ $precision = float ] && flags=-DVM_USE_FLOAT
    ${CC:-cc} -std=c99 -O2 -fopenmp $flags tests/evaluations.c -o "$folder/$precision" -lm || exit 1
    "$folder/$precision" rows >"$folder/rows"
    rows=$(wc -l <"$folder/rows")
    line=$first
    while [ "$line" -le "$last" ] && [ "$line" -le "$rows" ]; do
        row $precision "$line" || exit 1
        line=$((line + 1))
    done
done

line=1
: >"$folder/table"
while [ $line -le "$rows" ]; do
    if ! is_there double "$line" || ! is_there float "$line"; then
        echo "evaluations: row $line is not there yet"
        exit
    fi
    sed -s -n 2p "$folder/double.$line" "$folder/float.$line" | paste -s -d '|' - |
        awk -F'|' '{print "| " $1 " | " $2 " | " $5 " | " $3 + $6 " |"}' >>"$folder/table"
    line=$((line + 1))
done
sed "s/@COUNT@/$count/; s/@SEED@/$seed/" bench/evaluations.md | sed -e "/@TABLE@/{r $folder/table" -e 'd;}' >docs/evaluations.md
sh bench/stamp.sh write evaluations
echo "all rows: $rows in double and $rows in float, $count evaluations each (of slow functions a tenth), 0 violations"
