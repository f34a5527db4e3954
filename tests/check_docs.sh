#!/bin/sh
# Documents that cannot lie: prints what is wrong in README.md, docs/ and the marked numbers of the manuals, and fails if there
# is anything. What is looked for:
#   - a number that is none (NaN, infinity), a table without a row or with rows of other lengths, a generated part without a line;
#   - a row of numbers with an empty cell, in documents that a program writes (bench/documents.txt);
#   - a document that a program writes without the command that wrote it, or without a stamp of the headers;
#   - a marked number that differs from its source by more than its rounding (bench/numbers.sh);
#   - a document of more than 400 lines that is no table to look things up in.
# With "today" also:
#   - a document of `make docs` that was written from other headers than today's;
#   - a document of a campaign whose headers have changed since and that does not say so. How old each is gets printed.
#
# usage: check_docs.sh FOLDER [today], from the top of the project; FOLDER has README.md, docs/, bench/ and the headers
folder=$1 today=$2
list=$folder/bench/documents.txt
failures=0
wrong() { # reads lines, prints them, and counts them as failures
    while IFS= read -r line; do
        echo "$line"
        echo "$line" >>"$tmp"
    done
}
tmp=$(mktemp) || exit 1
trap 'rm -f "$tmp"' EXIT

# Numbers, rows, commands, stamps and lengths of all documents in one pass. In a document of `make docs` a cell must not be
# empty, but for a row's first, whose word stands in the row above then: a program writes "-" where there is nothing to say.
awk -v list="$list" -v folder="$folder" -v tables='^(names|changes|cost|validation|hard-cases)$' '
    function wrong(why) { print name ".md:" FNR ": " why ": " substr($0, 1, 120) }
    function is_rule(line) { return line ~ /^\|[-:| ]*-[-:| ]*$/ }
    function without_escaped(line) { gsub(/\\\|/, "x", line); return line }
    function cells(line) { return gsub(/\|/, "|", line) }
    function finish() { # what is known at the end of a document
        if (name == "") return
        if (after_rule || after_mark) print name ".md: nothing comes after its last line"
        if (kind[name] != "" && !stamped) print name ".md: does not say which headers it was measured on"
        if (kind[name] ~ /today|campaign/ && !commanded) print name ".md: does not name the command that wrote it"
        if (name !~ tables && name != "README" && lines > 400) print name ".md: has " lines " lines, more than 400"
        delete kind[name]
    }
    BEGIN {
        while ((getline line <list) > 0)
            if (line !~ /^#/ && split(line, field, " ") > 1) kind[field[1]] = field[2]
    }
    FNR == 1 {
        finish()
        name = FILENAME
        sub(/.*\//, "", name)
        sub(/[.]md$/, "", name)
        after_rule = after_mark = fenced = width = stamped = commanded = 0
    }
    { lines = FNR }
    /^The results on this page were obtained with (the headers [a-z].* [(]bench|earlier headers)/ { stamped = 1 }
    /`(make|sh) [a-z]/ { commanded = 1 }
    after_rule && !/^\|/ { wrong("the table before this line has no row") }
    after_mark && /^<!-- end -->/ { wrong("nothing was generated before this line") }
    /^```/ { fenced = !fenced }
    { after_rule = is_rule($0); after_mark = /^<!-- table / }
    after_rule { width = cells($0) }
    !/^\|/ { width = 0; next }
    fenced { next }
    {
        row = without_escaped($0)
        if (width && cells(row) != width) wrong("a row with " cells(row) - 1 " cells in a table of " width - 1)
        if (width && !after_rule && kind[name] == "today" && row ~ /[^ |] *\| *\|/) wrong("an empty cell")
        words = " " $0 " "
        gsub(/[^A-Za-z0-9_.+-]/, " ", words)
        if (words ~ / [-+]?(nan|inf) /) wrong("not a number")
    }
    END {
        finish()
        for (name in kind) if (kind[name] != "") print name ".md: is not there"
    }' "$folder"/README.md "$folder"/docs/*.md | wrong

# Marked numbers
NUMBERS_ROOT=$folder sh bench/numbers.sh check $(grep -lE '[0-9](<!--[a-zA-Z_0-9]+-->| \[[a-zA-Z]+_[a-zA-Z_0-9]+\])' \
    "$folder"/README.md "$folder"/docs/*.md "$folder"/src/*.h "$folder"/src/*/*.h) 2>&1 | wrong

# Today's headers
if [ "$today" = today ]; then
    STAMP_ROOT=$folder sh bench/stamp.sh of ateb integrators jacobi varmass | tr , '\n' | sed 's/^ //' |
        awk -v list="$list" -v folder="$folder" '
            function stamp_of(name,    file, line, found) { # the hashes, "earlier", or nothing
                file = folder "/docs/" name ".md"
                while ((getline line <file) > 0)
                    if (sub(/^The results on this page were obtained with the headers /, "", line) && sub(/ [(]bench.*/, "", line)) found = line
                    else if (line ~ /^The results on this page were obtained with earlier headers/) found = "earlier"
                close(file)
                return found
            }
            { now[$1] = $0 }
            END {
                split("ateb.h integrators.h jacobi.h varmass.h", header, " ")
                while ((getline line <list) > 0) {
                    n = split(line, field, " ")
                    if (field[2] !~ /^(today|campaign)$/) continue
                    has = stamp_of(field[1])
                    wanted = ""
                    for (h = 1; h <= 4; h++)
                        for (i = 4; i <= n; i++)
                            if (field[i] ".h" == header[h]) wanted = wanted (wanted == "" ? "" : ", ") now[header[h]]
                    if (has == wanted) continue
                    if (field[2] == "today") print field[1] ".md: written from other headers than today: make docs"
                    else if (has == "earlier") print field[1] ".md: of an earlier state, as it says" >"/dev/stderr"
                    else print field[1] ".md: of other headers than today, and does not say so: sh bench/stamp.sh refresh"
                }
            }' | wrong
fi
[ ! -s "$tmp" ]
