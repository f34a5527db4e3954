# Names the places where one call or one list in braces draws two random arguments: C leaves open which of them is drawn
# first, so that gcc and clang print other hashes. Prints FILE: STATEMENT; nothing where all is well.
# usage: awk -f two_draws.awk FILE..., from any place

function draws_twice(statement, depth, drawn, i, rest) {
    for (i = 1; i <= length(statement); i++) {
        rest = substr(statement, i)
        if (depth > 0 && match(rest, /^[^a-z_](uniform|vector|some_[a-z]+)\(/)) drawn[depth]++
        if (substr(rest, 1, 1) ~ /[({]/) drawn[++depth] = substr(rest, 2) ~ /^(uniform|vector|some_[a-z]+)\(/
        if (drawn[depth] > 1) return 1
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
            if (draws_twice(statement[k])) print file ": " statement[k]
        }
    }
}
