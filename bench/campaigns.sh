#!/bin/sh
# The campaigns: checks that take from minutes to hours. docs/campaigns.md has a row for each part. After a part has passed, its
# row holds the stamp of the headers that it depends on (bench/stamp.sh), and the part is not run again while they stay as they
# are. So a series that was broken off goes on where it was, also in another checkout. A part that was not run keeps its row,
# which then names the older headers. What a part printed is in build/campaigns/PART.log.
# usage: campaigns.sh [PART...], from the top of the project; without a name all parts are run, in this order
folder=build/campaigns document=docs/campaigns.md
mkdir -p $folder && echo '*' >build/.gitignore || exit 1
wanted=$*
failed=

# A row a part: name; headers; command; the lines of its output that are the result (a regular expression); what it shows
parts() {
    cat <<'END'
scan; ateb jacobi; make scan; passed, ; errors of the special functions at a million random arguments in each region, found by comparison with quadruple precision
points; ateb jacobi; make points; passed, ; errors of the special functions at 20 000 new points of each table of true values, which are computed with arbitrary precision (the last three results are those with fused multiply-adds)
routes; ateb jacobi integrators varmass; make routes; passed, ; errors and estimated errors of the motions of 2000 random oscillators by six routes (formulas and collocation)
exhaustive; ateb jacobi; make exhaustive; passed, ; errors of functions in float, at every float within one period
evaluations; ateb jacobi varmass; make evaluations COUNT=1000000000; ^all|violations; whether the special functions keep to their ranges, symmetries and identities at random arguments
events; integrators; make test-events; passed, ; whether integrators find every event exactly once, in random runs whose events coincide, jump or vanish
refusals; ateb jacobi integrators varmass; make test-refusals ROUNDS=1000000; passed, ; whether each function (except those of scenes), called with random numbers of any size, refuses them or gives finite results
threads; ateb jacobi integrators varmass; make test-threads; passed|equal; whether eight threads at once compute results with the same bits as one thread, under ThreadSanitizer
coverage; ateb jacobi integrators varmass; make coverage; [.]h ; how many lines the tests execute, and how many outcomes of conditions occur in the tests
mutants-jacobi; jacobi; make test-mutate MUTANTS=40 SEED=49 MUTATED=jacobi; caught, ; how many deliberate errors in jacobi.h the tests notice
mutants-ateb; ateb; make test-mutate MUTANTS=40 SEED=49 MUTATED=ateb; caught, ; how many deliberate errors in ateb.h the tests notice
mutants-integrators; integrators; make test-mutate MUTANTS=40 SEED=49 MUTATED=integrators; caught, ; how many deliberate errors in integrators.h the tests notice
mutants-varmass; varmass; make test-mutate MUTANTS=40 SEED=49 MUTATED=varmass; caught, ; how many deliberate errors in varmass.h the tests notice
proof; ateb jacobi integrators varmass; make proof; passed|kinds of alarms; a proof, by abstract interpretation, that certain run-time errors cannot occur at any arguments in jacobi.h, ateb.h, integrators.h and three quarters of varmass.h
kernels; ateb jacobi; make proof-kernels KERNELS=full; passed, ; a proof, by Gappa and Sollya, of bounds for the errors of basic functions (kernels)
sanitizers; ateb jacobi integrators varmass; make test-sanitize; passed, ; what sanitizers, valgrind and static analysers find
fuzz; ateb jacobi integrators varmass; make test-fuzz SECONDS=16800; ^fuzz: |^planted: ; whether calls of all functions with generated inputs find errors, and whether such calls find deliberate errors
cross; ateb jacobi integrators varmass; make test-cross; ^cross: ; whether results have the same bits, and the tests pass, on every target (processor and compiler)
peers; ateb jacobi integrators varmass; make peers; ^No peer|^A peer; times and errors of the kit, compared with those of GSL, Boost and SUNDIALS
cost; ateb jacobi integrators varmass; make cost; ^wrote; times of all routes (methods of computing), on a machine that does nothing else
END
}
is_wanted() { [ -z "$wanted" ] || echo " $wanted " | grep -q " $1 "; }
for part in $wanted; do
    parts | grep -q "^$part; " || { echo "campaigns.sh: no such part: $part" >&2; exit 2; }
done
field() { echo "$1" | awk -F'; ' -v n="$2" '{print $n}'; }                               # field LINE N: of a line of parts
column() { awk -F' [|] ' -v part="| $1" -v n="$2" '$1 == part {print $n}' $folder/old; } # column PART N: of the part's row
current_stamp() { sh bench/stamp.sh of $(field "$1" 2); }                                # current_stamp LINE

# new_row LINE STAMP RESULT: writes the document, with these two columns in the row of this line
new_row() {
    cp $document $folder/old || : >$folder/old
    {
        cat <<'END'
# Campaigns

This page is written by `make campaigns` (bench/campaigns.sh).

A campaign is a check that takes too long for `make test-all`. For each campaign, the table says what the campaign
shows, with which version of the kit's headers it last ran, and what it printed at the end of this run. The column
"headers" names these headers, each with its hash. A hash is a number that bench/stamp.sh computes from the code of a
header and that changes if the code changes. If the hashes of a row are not those of today's headers, the
campaign last ran with earlier headers. In the row "coverage", the name of each header is followed by six numbers. Three
numbers are about the lines of the header: how many there are, how many were not executed, and the share that was
executed. The other three numbers are about the outcomes of its conditions (true or false): how many there are, how many
did not occur, and the share that occurred. The command `make campaigns` runs a campaign again if one of its headers has
changed since the campaign last passed. The command `make campaigns CAMPAIGNS="scan proof"` does this only for the two
campaigns "scan" and "proof". [reliability.md](reliability.md) and [fuzzing.md](fuzzing.md) say which mistakes in the
code the campaigns found.

| campaign | command | what it shows | headers | result |
|---|---|---|---|---|
END
        while IFS= read -r line <&4; do
            part=${line%%; *}
            headers=$(column "$part" 4) found=$(column "$part" 5)
            [ "$line" != "$1" ] || headers=$2 found="$3 |"
            echo "| $part | \`$(field "$line" 3)\` | $(field "$line" 5) | ${headers:-not run since hashes are recorded} | ${found:-- |}"
        done 4<$folder/parts
        printf '\nThe results on this page were obtained with earlier headers, except for the rows whose hashes are those of the present headers.\n'
    } >$folder/new
    mv $folder/new $document
}

parts >$folder/parts
new_row none
while IFS= read -r line <&3; do
    name=${line%%; *}
    is_wanted "$name" || continue
    stamp=$(current_stamp "$line")
    if [ "$(column "$name" 4)" = "$stamp" ]; then
        echo "$name: passed before, with these headers"
        continue
    fi
    echo "$name: $(field "$line" 3)"
    if $(field "$line" 3) >$folder/"$name".log 2>&1; then
        result=$(grep -E "$(field "$line" 4)" $folder/"$name".log | tail -n 9 | tr -s ' ' | sed 's/[|]/\\|/g; s/^ //' | paste -s -d ';' - |
            sed 's/;/; /g')
        echo "$name: $result"
        new_row "$line" "$stamp" "${result:-passed}"
    else
        failed="$failed $name"
        echo "$name: FAILED, see $folder/$name.log"
    fi
done 3<$folder/parts

cp $document $folder/old
current=1
while IFS= read -r line <&3; do
    [ "$(column "${line%%; *}" 4)" = "$(current_stamp "$line")" ] || current=
done 3<$folder/parts
[ -z "$current" ] || sh bench/stamp.sh write campaigns
sh bench/stamp.sh refresh
[ -z "$failed" ] || { echo "campaigns that failed:$failed" >&2; exit 1; }
