# The bounds that a comment or a document promises, a line each: where, number, unit, separated by tabs.
# A bound is a number before "ulp", "eps" or "VM_EPSILON". In files of src/ only the comments directly above public
# functions count, by the function's name, and the manual's part ACCURACY, by its entries; in Markdown the column
# "promised" of a table, by the first cell of the row. A function that has the accuracy of another one is a line with "as"
# and the other's name; one without any word of its accuracy is a line with "none" and "-".
# usage: awk -f tests/promises.awk FILE...
BEGIN { OFS = "\t" }

function bounds(where, text,    number, unit, found) {
    gsub(/VM_EPSILON/, "eps", text)
    while (match(text, /[0-9.]+[;,] [0-9.]+ (ulp|eps)/)) { # "3; 6 eps": both have the unit
        number = substr(text, RSTART, RLENGTH)
        unit = number
        sub(/.* /, " ", unit)
        sub(/[;,]/, unit " and", number)
        text = substr(text, 1, RSTART - 1) number substr(text, RSTART + RLENGTH)
    }
    while (match(text, /[0-9][0-9.]*(\^-?[0-9]+)? +(ulp|eps)|one ulp/)) {
        number = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        unit = number
        sub(/.* /, "", unit)
        sub(/ .*/, "", number)
        print where, number == "one" ? 1 : number, unit
        found++
    }
    return found
}
function borrowed(where, text) { # from another function
    if (!match(text, /(accuracy|[Vv]alues) (is|are) (that|those) of [a-zA-Z_0-9]+/)) return 0
    text = substr(text, RSTART, RLENGTH)
    sub(/.* /, "", text)
    print where, text, "as"
    return 1
}

FNR == 1 { comment = ""; in_comment = in_accuracy = in_table = 0; entry = "" }

# comments directly above public functions
/^\/\*/ { comment = ""; in_comment = 1 }
in_comment { comment = comment " " $0 }
/\*\// { in_comment = 0 }
/^VM_(API|INLINE) / {
    match($0, /[A-Za-z_0-9]+\(/)
    name = substr($0, RSTART, RLENGTH - 1)
    if (name !~ /^vmi_/) {
        gsub(/[ *\/]+/, " ", comment)
        if (borrowed(name, comment) + bounds(name, comment) == 0) print name, "-", "none"
    }
    comment = ""
}
/^[#}]/ { comment = "" }

# the manual's ACCURACY: entries begin in column 6 and go on further to the right
/^   ACCURACY/ { in_accuracy = 1; next }
in_accuracy && /^   [A-Z]/ { bounds(entry, text); in_accuracy = 0 }
in_accuracy && /^     [^ ]/ {
    if (entry != "") bounds(entry, text)
    entry = text = $0
    sub(/^ +/, "", entry)
    sub(/  .*/, "", entry)
    entry = "manual: " entry
}
in_accuracy && !/^     [^ ]/ { text = text " " $0 }

# the column "promised" of a table
/^\|/ {
    n = split($0, cell, / *\| */)
    if (/\| promised \|/) {
        in_table = 0
        for (i = 1; i <= n; i++) if (cell[i] == "promised") in_table = i
    } else if (in_table) bounds("docs/accuracy.md: " cell[2], cell[in_table])
}
!/^\|/ { in_table = 0 }
