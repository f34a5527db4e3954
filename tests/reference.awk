# What the comments of public functions lack, a line each: errors, units, accuracy, cost or source. The words that count stand in
# the comment directly above the function, in the first comment of its file (the chapter), or, but for errors, in the manual.
# usage: awk -f tests/reference.awk MANUAL FILE..., where MANUAL is the file of src/ whose first comment is the manual

# words that tell what happens after a mistake: a status, NaN, a limit, another function that has the same errors
function tells_errors(text) {
    return text ~ /VM_[A-Z][A-Z]|ODE_[A-Z][A-Z]|NaN|[Ss]tatus|refuse|[Rr]eturns? (infinity|-1|0|1)|cannot fail|nothing is done/ ||
        text ~ /[Ee]rrors are|[Dd]omain|as in [a-z0-9_]+|(that|those) of [a-z0-9_]+_|as [a-z0-9]+_[a-z0-9_]+ does|for any/
}
function tells_units(text) { return text ~ /[^A-Za-z](m|s|kg|N|J|W|rad|radians|degrees|SI units|pure numbers?|unit of t|any unit)[^A-Za-z]/ }
function tells_accuracy(text) { return text ~ /ACCURACY|ulp|eps|exact|[Aa]ccura|tolerance|rounding|digits/ }
function tells_cost(text) { return text ~ /docs\/c(ost|ounts)|instructions|in less time|same time|square root|evaluation/ }
function tells_source(text) { return text ~ /REFERENCES|\([0-9]+\)|\[[0-9]\]|DLMF/ }

function look_at(name) {
    public_functions++
    own = comment chapter
    if (!tells_errors(own)) print FILENAME ": " name " lacks what happens after an error"
    if (!tells_units(own manual)) print FILENAME ": " name " lacks units"
    if (!tells_accuracy(own manual)) print FILENAME ": " name " lacks an accuracy"
    if (!tells_cost(own manual)) print FILENAME ": " name " lacks a cost"
    if (!tells_source(own manual)) print FILENAME ": " name " lacks a source"
    if (comment == "") print FILENAME ": " name " has no comment"
}

FNR == 1 { chapter = comment = ""; is_first = 1; in_comment = 0 }
/^\/\*/ { comment = ""; in_comment = 1 }
in_comment { comment = comment " " $0 " " }
in_comment && /\*\// {
    in_comment = 0
    if (is_first) {
        if (FNR == NR) manual = comment
        else chapter = comment
        is_first = 0
        comment = ""
    }
    next
}
/^VM_(API|INLINE) / && FNR != NR {
    if (match($0, /[A-Za-z_0-9]+\(/)) {
        name = substr($0, RSTART, RLENGTH - 1)
        if (name ~ /^(vm|jacobi|ateb|rk4|rk45|rk87|ode)_/) look_at(name)
    }
}
/^[#}]/ { comment = "" }
END { if (!public_functions) print "no public function was found" }
