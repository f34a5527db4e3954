# What Doxygen reads in place of a file of src/: the comment at its top is about the file, the comment directly above a
# function, type or macro is about that. Characters that Doxygen or Markdown would take for marks are quoted, and what
# stands in column 8, code and formulas, is shown as it is.
function quoted(text) {
    gsub(/[\\@<>#%&*`~$|\[\]!]/, "\\\\&", text)
    return text
}
# one line of a comment without its marks
function line_of(text) {
    if (text ~ /^    /) { # code
        if (!in_code) print ""
        if (!in_code) print "\\verbatim"
        in_code = 1
        print text
        return
    }
    if (in_code && text ~ /^ *$/) {
        print ""
        return
    }
    if (in_code) print "\\endverbatim"
    in_code = 0
    sub(/^ +/, "", text)
    sub(/^- /, "\001", text)
    text = quoted(text)
    sub(/^\001/, "- ", text)
    print text
}
/^\/\*/ && !inside {
    inside = 1
    is_first = !seen++
    text = $0
    sub(/^\/\*+ ?/, "", text)
    if (text ~ /^-- .* -- \*\/$/) { # a heading inside a chapter
        inside = 0
        print ""
        next
    }
    printf "/** "
    if (is_first) {
        sub(/^[a-z0-9_\/]*\.h - /, "", text)
        printf "\\file\n\\brief "
    }
    if (text ~ /\*\/ *$/) {
        sub(/ *\*\/ *$/, "", text)
        line_of(text)
        print "*/"
        inside = 0
    } else line_of(text)
    if (is_first) print ""
    next
}
inside {
    text = $0
    ended = sub(/ *\*\/ *$/, "", text)
    sub(/^   /, "", text)
    line_of("" text)
    if (ended) {
        if (in_code) print "\\endverbatim"
        in_code = inside = 0
        print "*/"
    }
    next
}
# fields: the comment behind belongs to them
/;[ ]*\/\*/ { sub(/\/\*/, "/**<") }
{ print }
