# Names the places where one call or one list in braces draws two random arguments: C leaves open which of them is drawn
# first, so that gcc and clang draw other numbers. Prints FILE: STATEMENT, and fails, where it finds one.
# usage: awk -v draws=NAMES -f two_draws.awk FILE..., from any place; NAMES: a regular expression of the functions that draw

function draws_twice(statement, depth, drawn, i, rest) {
    for (i = 1; i <= length(statement); i++) {
        rest = substr(statement, i)
        if (depth > 0 && match(rest, "^[^A-Za-z0-9_({](" draws ")[(]")) drawn[depth]++
        if (substr(rest, 1, 1) ~ /[({]/) drawn[++depth] = substr(rest, 2) ~ "^(" draws ")[(]"
        if (drawn[depth] > 1) return 1
        if (rest ~ /^([?:]|&&|[|][|])/) drawn[depth] = 0 # what is before these is drawn first, or is not drawn
        if (substr(rest, 1, 1) ~ /[)}]/ && depth > 0) depth--
    }
    return 0
}

{
    sub(/\/\*.*\*\//, "")
    text[FILENAME] = text[FILENAME] " " $0
}

END {
    for (file in text) {
        count = split(text[file], statement, ";")
        for (k = 1; k <= count; k++) {
            sub(/^.*\) *\{/, "", statement[k])
            if (draws_twice(statement[k])) {
                print file ": " statement[k]
                found = 1
            }
        }
    }
    exit found
}
