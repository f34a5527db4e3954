# The loops of files of src, one a line: file, tab, function or macro, tab, the keyword and its parenthesis. A do is
# listed by its while. usage: awk -f loops.awk FILE...
FNR == 1 { header = FILENAME; where = ""; comment = 0 }
{
    line = $0
    if (comment && !sub(/^.*\*\//, "", line)) next
    comment = 0
    while (match(line, /\/\*([^*]|\*+[^*\/])*\*+\//)) line = substr(line, 1, RSTART - 1) substr(line, RSTART + RLENGTH)
    if (sub(/\/\*.*/, "", line)) comment = 1
    if (match(line, /^(VM_API|VM_INLINE|VMI_APART|VMI_FOLDED|static) .*\(/) || match(line, /^#define [A-Za-z0-9_]+/)) {
        where = line
        sub(/^#define /, "", where)
        sub(/\(.*/, "", where)
        sub(/ .*[ *]/, " ", where)
        sub(/.* /, "", where)
    }
    if (match(line, /(^|[^A-Za-z0-9_])(for|while) \(/)) {
        text = substr(line, RSTART)
        sub(/^[^fw]*/, "", text)
        depth = 0
        for (i = index(text, "("); i <= length(text); i++) { # to where its parenthesis closes
            c = substr(text, i, 1)
            depth += (c == "(") - (c == ")")
            if (depth == 0) break
        }
        print header "\t" where "\t" substr(text, 1, i)
    }
}
