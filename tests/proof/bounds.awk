# Are the bounds of tests/proof/bounds.txt those of the comments? Prints each that is not, and fails then. The words of a
# comment may be broken over lines.
# usage: awk -f bounds.awk [-v root=FOLDER] tests/proof/bounds.txt
function text_of(name,    line, text) { # a file with every run of blanks and line ends as one blank
    while ((getline line <name) > 0) text = text " " line
    close(name)
    gsub(/[ \t]+/, " ", text)
    return text
}
function put(words, mark, bound,    at) {
    while ((at = index(words, mark)) > 0) words = substr(words, 1, at - 1) bound substr(words, at + length(mark))
    return words
}
BEGIN {
    if (root == "") root = "."
}
/^#/ || !NF { next }
{
    lines++
    count = split($0, field, /; /)
    if (count < 4) next # a lemma
    words = field[5]
    for (i = 6; i <= count; i++) words = words "; " field[i]
    words = put(put(words, "@d", field[2]), "@f", field[3])
    if (!(field[4] in text)) text[field[4]] = text_of(root "/" field[4])
    if (!index(text[field[4]], words)) {
        print field[4] " does not say: " words
        wrong++
    }
}
END {
    if (lines < 15) print "no bounds"
    exit wrong > 0 || lines < 15
}
