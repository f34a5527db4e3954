# Writes one header from its root: each #include "..." is replaced by the file it names, the first time it occurs; a
# second time it is dropped. An #include of another root, such as "jacobi.h", stays, and what that root includes is not
# written again, unless whole=1. The line @INDEX@ of the manual becomes the index: a line for each public function, made
# of its name and the first sentence of its comment.
# usage: awk [-v whole=1] -f src/headers.awk ROOT, from the top of the project

function folder_of(file) {
    return file ~ /\// ? substr(file, 1, match(file, /[^\/]*$/) - 1) : ""
}

# the file that #include "name" means in file, without "folder/../"
function resolve(file, name) {
    name = folder_of(file) name
    while (sub(/[^\/.]+\/\.\.\//, "", name)) {}
    return name
}

# stops where a file that is included is not there
function check(file,    line) {
    if ((getline line < file) < 0) {
        print "headers.awk: cannot read " file > "/dev/stderr"
        exit 1
    }
    close(file)
}

function include_of(line) {
    return line ~ /^#include "/ ? substr(line, 11, length(line) - 11) : ""
}

function is_root(file) {
    return folder_of(file) == folder_of(ARGV[1])
}

# all that file includes, directly or not, counts as written
function mark(file,    line, name) {
    if (written[file]++) return
    check(file)
    while ((getline line < file) > 0) {
        name = include_of(line)
        if (name != "") mark(resolve(file, name))
    }
    close(file)
}

function put(line) {
    if (line == "" && body[lines] == "") return
    body[++lines] = line
}

# the comment whose lines begin at body[first] as one line, up to the end of its first sentence
function first_sentence(first,    i, text) {
    for (i = first; i <= lines && body[i] !~ /^VM_/; i++) {
        text = text " " body[i]
        if (body[i] ~ /\*\//) break
    }
    gsub(/[ \t]+/, " ", text)
    sub(/^ *\/\* /, "", text)
    sub(/ *\*\/.*$/, "", text)
    if (match(text, /[.:]( |$)/)) text = substr(text, 1, RSTART - 1)
    return text
}

function index_function(line, chapter,    name) {
    if (line !~ /^VM_(API|INLINE) /) return
    name = line
    sub(/\(.*/, "", name)
    sub(/^.*[ *]/, "", name)
    if (name ~ /^vmi_/) return
    if (chapter != last_chapter) entries = entries "\n\n     " titles[chapter]
    last_chapter = chapter
    entries = entries sprintf("\n       %-30s %s", name, comment ? first_sentence(comment) : "")
}

# in a chapter, what it includes comes before it; in a root, in place of the #include
function copy_chapter(file,    line, name, number, open) {
    if (written[file]++) return
    check(file)
    while ((getline line < file) > 0) {
        name = include_of(line)
        if (name != "") copy_chapter(resolve(file, name))
    }
    close(file)
    while ((getline line < file) > 0) {
        if (++number == 1) {
            titles[file] = line
            sub(/^\/\* /, "", titles[file])
            sub(/\.h - /, ": ", titles[file])
            sub(/ *\*\/$/, "", titles[file])
        }
        if (include_of(line) != "") continue
        if (line ~ /^\/\*/ && !comment) comment = lines + 1
        if (line ~ /^\/\*/) open = 1
        if (line ~ /\*\//) open = 0
        if (line == "" && !open) comment = 0
        put(line)
        index_function(line, file)
    }
    close(file)
}

function copy_root(file,    line, name) {
    if (written[file]++) return
    check(file)
    while ((getline line < file) > 0) {
        name = include_of(line)
        if (name == "") put(line)
        else if (!is_root(resolve(file, name))) copy_chapter(resolve(file, name))
        else if (whole) copy_root(resolve(file, name))
        else {
            put(line)
            mark(resolve(file, name))
        }
    }
    close(file)
}

BEGIN {
    copy_root(ARGV[1])
    for (i = 1; i <= lines; i++) {
        if (body[i] ~ /^@INDEX@/) print substr(entries, 3) substr(body[i], 8)
        else print body[i]
    }
    exit
}
