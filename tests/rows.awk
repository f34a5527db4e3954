# The rows of the tables of worst errors that test programs print (check_finish in tests/check.h), for other programs:
# program, precision, function, region, unit, worst, bound, number of points, separated by tabs; a row without a region has "-".
BEGIN { OFS = "\t" }
/ unit +worst +bound +n +worst at$/ {
    split($0, word, /  +/)
    program = word[1]
    precision = word[2]
    in_table = 1
    next
}
/ passed, [0-9]+ failed, [0-9]+ skipped$/ { in_table = 0 }
in_table && match($0, / +[^ ]+ +[^ ]+ +[0-9]+   [^ ]+, [^ ]+/) {
    words = substr($0, 1, RSTART - 1)
    split(substr($0, RSTART), number, " ")
    n = split(words, word, /  +/)
    if (n == 2) {
        word[3] = word[2]
        word[2] = "-"
    }
    print program, precision, word[1], word[2], word[3], number[1], number[2], number[3]
}
