# varmass.h with ateb.h, integrators.h and jacobi.h in place of their #include lines. The shared block and the elementary
# kernels, the same in several headers, stand where they occur first.
# usage: awk -f amalgamate.awk varmass.h, from the top of the project
function copy(file,    line, dropping, block) {
    while ((getline line < file) > 0) {
        if (line ~ /^\/\* ---- (Shared block|Elementary kernels)/) {
            block = line ~ /Shared/ ? "shared" : "elementary"
            dropping = seen[block]++
        }
        if (!dropping) {
            if (line ~ /^#include "(ateb|integrators|jacobi)\.h"/) {
                split(line, part, "\"")
                copy(part[2])
            } else print line
        }
        if (line ~ /^\/\* ---- End of the (shared block|elementary kernels)/) dropping = 0
    }
    close(file)
}
BEGIN {
    copy(ARGV[1])
    exit
}
