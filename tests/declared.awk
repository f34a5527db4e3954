# A header without the bodies of its functions: declarations, types, tables and what is always inlined are left. Programs that are
# linked with one object of the headers (Makefile: headers.o) read it in place of the header; that takes a third of the time.
# usage: awk -f tests/declared.awk HEADER
/^VM_API / { in_function = 1 }
!in_function { print; next }
in_body { if (/^}/) in_function = in_body = 0; next }
{
    at = index($0, "{")
    if (at == 0) { # more lines of parameters, or a declaration
        print
        if (/;[ \t]*(\/\*.*)?$/) in_function = 0
        next
    }
    print substr($0, 1, at - 1) ";"
    if (/}[ \t]*(\/\*.*)?$/) in_function = 0
    else in_body = 1
}
