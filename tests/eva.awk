# A condition x < y in what Frama-C printed becomes x < y && NUMBER(x) && NUMBER(y), which has the same value: EVA 25 does not
# conclude from an ordered comparison that holds that neither side is NaN, though from x == x it does.
# usage: awk -f eva.awk PRINTED.c
function constant(x) { return x ~ /^(\([a-z_ ]*\))?-?[0-9][0-9a-fx.+pe-]*$/ }
function number(x) { return constant(x) ? "" : " && (" x " == " x " || impossible())" }
function stronger(condition,   i, c, depth, left, right) {
    if (condition ~ /^! \(.*\)$/) return "! (" stronger(substr(condition, 4, length(condition) - 4)) ")"
    for (i = 1; i <= length(condition); i++) {
        c = substr(condition, i, 1)
        depth += (c == "(") - (c == ")") + (c == "[") - (c == "]")
        if (depth || !match(substr(condition, i), /^ (<|>|<=|>=) /)) continue
        left = substr(condition, 1, i - 1)
        right = substr(condition, i + RLENGTH)
        return condition number(left) number(right)
    }
    return condition
}
{
    line = $0
    done = ""
    while (match(line, /(^|[^A-Za-z_0-9])(if|while) \(/)) {
        start = RSTART + RLENGTH - 1 # of the parenthesis
        depth = 1
        for (i = start + 1; depth; i++) { # to where it closes, on a later line perhaps
            while (i > length(line) && (getline more) > 0) line = line " " more
            c = substr(line, i, 1)
            depth += (c == "(") - (c == ")")
        }
        done = done substr(line, 1, start) stronger(substr(line, start + 1, i - start - 2)) ")"
        line = substr(line, i)
    }
    print done line
}
