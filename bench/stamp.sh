#!/bin/sh
# The stamp of a document: which headers its numbers were measured on. A header's hash leaves out comments and blanks, and
# holds no date, so that it changes only where the code does.
#
#   stamp.sh of HEADER...        prints the hashes, as in "ateb.h 1c2d3e4f, jacobi.h 5a6b7c8d"
#   stamp.sh write DOCUMENT...   ends docs/DOCUMENT.md with today's stamp; bench/documents.txt names the headers it needs
#   stamp.sh refresh             makes the documents of campaigns say whether the headers have changed since
#   stamp.sh headers DOCUMENT    prints the headers that the document depends on
#
# from the top of the project; STAMP_ROOT is another folder that has the headers, docs/ and bench/documents.txt
root=${STAMP_ROOT:-.}
list=$root/bench/documents.txt
begins='The results on this page were obtained with the headers '
earlier='The results on this page were obtained with earlier headers'
how='(bench/stamp.sh computes the hashes)'

# A header without comments, blanks and the conditions for CUDA's compiler, with which no number of a document is measured. No
# string of the headers has the marks of a comment.
bare() {
    awk '{
            line = $0
            while (line != "") {
                at = index(line, inside ? "*/" : "/*")
                if (at == 0) {
                    if (!inside) printf "%s", line
                    break
                }
                if (!inside) printf "%s", substr(line, 1, at - 1)
                line = substr(line, at + 2)
                inside = !inside
            }
        }' "$1" | tr -d ' \t\r\n' | sed 's/&&!defined(__CUDACC__)//g'
}
of() {
    for header in "$@"; do
        header=${header%.h}
        [ -f "$root/$header.h" ] || { echo "stamp.sh: no such header: $header.h" >&2; return 1; }
        printf '%s.h %08x\n' "$header" "$(bare "$root/$header.h" | cksum | cut -d' ' -f1)"
    done | paste -s -d , - | sed 's/,/, /g'
}
headers_of() { awk -v name="$1" '$1 == name {for (i = 4; i <= NF; i++) print $i}' "$list" | sort; }

end_with() { # end_with DOCUMENT LINE: replaces the stamp that the document has, or adds one
    file=$root/docs/$1.md
    awk -v line="$2" -v begins="^($begins|$earlier)" '
        $0 ~ begins {next}
        {text[++n] = $0}
        END {
            while (n > 0 && text[n] == "") n--
            for (i = 1; i <= n; i++) print text[i]
            print ""
            print line
        }' "$file" >"$file.new"
    if cmp -s "$file" "$file.new"; then rm "$file.new"; else mv "$file.new" "$file"; fi
}
write() {
    for document in "$@"; do
        end_with "$document" "$begins$(of $(headers_of "$document")) $how."
    done
}
refresh() {
    for document in $(awk '$2 == "campaign" {print $1}' "$list"); do
        [ -f "$root/docs/$document.md" ] || continue
        has=$(sed -n "s/^$begins\(.*\) (bench.*/\1/p; s/^$earlier: \(.*\) (bench.*/\1/p" "$root/docs/$document.md")
        today=$(of $(headers_of "$document"))
        if [ -z "$has" ]; then end_with "$document" "$earlier. It is not recorded which headers these were."
        elif [ "$has" = "$today" ]; then end_with "$document" "$begins$has $how."
        else end_with "$document" "$earlier: $has $how."; fi
    done
}

mode=$1
shift
case $mode in
of) of "$@" ;;
write) write "$@" ;;
refresh) refresh ;;
headers) headers_of "$1" ;;
*) echo "stamp.sh: no such mode: $mode" >&2; exit 2 ;;
esac
