#!/bin/sh
# A text file of the project holds one line for each run of hours that came to its end, so that this run is not made again. This
# script writes the line "NAME: CODE: RESULT" into FILE, in place of the line of this NAME. CODE says with which code the run was
# made, and RESULT what it found.
# usage: keep_line.sh FILE NAME CODE RESULT
new=$(mktemp) || exit 1
{ grep -sv "^$2: " "$1"; echo "$2: $3: $4"; } | LC_ALL=C sort -t ' ' -k 1,1 -k 2,2n >"$new" && cat "$new" >"$1"
rm "$new"
