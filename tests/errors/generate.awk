# Writes the C program that checks the errors of all public functions of varmass.h. It reads, in this order,
#   valid.txt        valid values that the types alone do not tell
#   exceptions.txt   the arguments for which the table of errors does not hold, each with its reason
#   objects.h        for its functions judge_TYPE, which give an object that was returned a status
#   jacobi.h ateb.h integrators.h varmass.h   for all public functions, structs and statuses; of integrators.h, which
#                    has statuses of its own, for its structs alone
# Every function gets a struct of its arguments, a function that fills it with valid values, and a function that makes
# the call; every struct gets a table of its fields. What is done with them stands in trials.h.
# usage: awk -f generate.awk valid.txt exceptions.txt objects.h jacobi.h ateb.h integrators.h varmass.h

function trim(text) {
    gsub(/[ \t]+/, " ", text)
    sub(/^ /, "", text)
    sub(/ $/, "", text)
    return text
}

# ---- declarations ----

# One declaration of a field or parameter: the results are D_name, D_type, D_kind, D_const, D_count
function declare(text,    stars) {
    text = trim(text)
    D_text = text
    D_count = 1
    D_const = text ~ /^const /
    sub(/^const /, "", text)
    while (match(text, /struct VM_TAG\([a-z0-9_]+\)/))
        text = substr(text, 1, RSTART - 1) substr(text, RSTART + 14, RLENGTH - 15) substr(text, RSTART + RLENGTH)
    if (match(text, /\(\*[A-Za-z0-9_]+\)/)) {
        D_name = substr(text, RSTART + 2, RLENGTH - 3)
        D_type = "code"
        D_kind = "CODE"
        return
    }
    stars = text ~ /\*/
    gsub(/\*/, " ", text)
    if (match(text, /\[[^\]]*\]/)) {
        D_count = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, 1, RSTART - 1)
    }
    text = trim(text)
    D_name = text
    sub(/^.* /, "", D_name)
    D_type = text
    sub(/ [^ ]*$/, "", D_type)
    D_kind = kind_of(D_type)
    if (stars) D_kind = D_type == "void" ? "USER" : "POINTER"
}

function kind_of(type) {
    if (type == "vm_real") return "REAL"
    if (type == "int") return "INTEGER"
    if (type == "long") return "LONG"
    if (type in is_callback) return "CODE"
    if (type in is_struct) return "STRUCT"
    return "UNKNOWN"
}

function add_fields(struct, line,    parts, n, i, type, name, double_only) {
    double_only = sub(/@ */, "", line) # see struct_open
    if (line ~ /\(/) parts[n = 1] = line
    else n = split(line, parts, ",")
    type = trim(parts[1])
    sub(/[ *]*[A-Za-z0-9_]+(\[[^\]]*\])?$/, "", type)
    for (i = 1; i <= n; i++) {
        declare(i == 1 ? parts[1] : type " " parts[i])
        i_field = ++fields[struct]
        field_name[struct, i_field] = D_name
        field_type[struct, i_field] = D_type
        field_kind[struct, i_field] = D_kind
        field_count[struct, i_field] = D_count
        field_in_double[struct, i_field] = double_only
    }
}

# a struct's text, from its first line to its last
function add_struct(text,    struct, lines, n, i) {
    match(text, /VM_TAG\([a-z0-9_]+\)/)
    struct = substr(text, RSTART + 7, RLENGTH - 8)
    if (struct ~ /^vmi_/ || (struct in is_struct)) return
    is_struct[struct] = 1
    structs[++n_structs] = struct
    sub(/^[^{]*{/, "", text)
    sub(/}[^}]*$/, "", text)
    struct_text[struct] = text
}

function add_function(text,    name, head) {
    sub(/[{;].*/, "", text)
    text = trim(text)
    sub(/^VM_[A-Z]+ /, "", text)
    head = text
    sub(/\(.*/, "", head)
    name = head
    sub(/^.*[ *]/, "", name)
    if (name !~ /^(vm|jacobi|ateb)_/ || (name in result)) return
    functions[++n_functions] = name
    result[name] = trim(substr(head, 1, length(head) - length(name)))
    sub(/^[^(]*\(/, "", text)
    sub(/\)$/, "", text)
    parameters[name] = trim(text)
}

# splits at the commas that stand in no parenthesis
function split_parameters(text, parts,    i, c, depth, n) {
    n = 1
    parts[1] = ""
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        if (c == "(") depth++
        if (c == ")") depth--
        if (c == "," && depth == 0) parts[++n] = ""
        else parts[n] = parts[n] c
    }
    return text == "" || text == "void" ? 0 : n
}

# ---- reading ----

FILENAME ~ /valid\.txt$/ {
    if ($0 ~ /^#/ || NF < 3) next
    key = $1 " " $2
    text = $0
    sub(/^[^ ]+ +[^ ]+ +/, "", text)
    value[key] = text
    value_line[key] = FNR
    next
}

FILENAME ~ /exceptions\.txt$/ {
    if ($0 ~ /^#/ || NF == 0) next
    if (NF < 6) bad_lines = bad_lines "exceptions.txt, line " FNR ": no reason is given\n"
    reason = $0
    sub(/^[^ ]+ +[^ ]+ +[^ ]+ +[^ ]+ +/, "", reason)
    gsub(/"/, "'", reason)
    exceptions = exceptions sprintf("    {\"%s\", \"%s\", \"%s\", \"%s\", %d, 0},\n", $1, $2, $3, $4, FNR)
    next
}

FILENAME ~ /objects\.h$/ {
    if (match($0, /judge_[a-z0-9_]+\(/)) has_judge[substr($0, RSTART + 6, RLENGTH - 7)] = 1
    next
}

{
    line = $0
    if (comment && !sub(/^.*\*\//, "", line)) next
    comment = 0
    while (match(line, /\/\*([^*]|\*+[^*\/])*\*+\//)) line = substr(line, 1, RSTART - 1) substr(line, RSTART + RLENGTH)
    if (sub(/\/\*.*/, "", line)) comment = 1
}
line ~ /^ *VM_[A-Z_0-9]+ = -?[0-9]+,? *$/ && FILENAME ~ /varmass\.h$/ {
    split(line, parts, "=")
    status = trim(parts[1])
    number = trim(parts[2])
    sub(/,$/, "", number)
    if (number < 0) statuses = statuses sprintf("    {%s, \"%s\"},\n", status, status)
}
line ~ /^typedef [^({]*\(\*[a-z0-9_]+\)\(/ {
    match(line, /\(\*[a-z0-9_]+\)/)
    is_callback[substr(line, RSTART + 2, RLENGTH - 3)] = 1
}
!struct_open && line ~ /^(typedef )?struct VM_TAG\([a-z0-9_]+\) *{/ {
    struct_open = 1
    text = ""
}
struct_open && /^#/ { # a field that float does not have stands between #if VM_MANT_DIG > 24 and #endif
    double_only = /^#if VM_MANT_DIG > 24/ ? "@" : ""
    next
}
struct_open {
    text = text " " double_only line
    if (line ~ /^}/) {
        add_struct(text)
        struct_open = 0
    }
    next
}
FILENAME !~ /integrators\.h$/ && line ~ /^(VM_API|VM_INLINE|VMI_APART) / {
    function_open = 1
    text = ""
}
function_open {
    text = text " " line
    if (line ~ /[;{]/) {
        add_function(text)
        function_open = 0
    }
}

# ---- valid values ----

# the struct whose name begins the name of a function, such as vm_drum of vm_drum_rhs; valid.txt may give another
# beginning
function subject_of(name,    i, begin, length_of_best, best) {
    best = ""
    length_of_best = 0
    for (i = 1; i <= n_structs; i++) {
        begin = looked_up(structs[i] " subject") ? found : structs[i]
        if (index(name, begin "_") != 1 || length(begin) <= length_of_best) continue
        best = structs[i]
        length_of_best = length(begin)
    }
    return best
}

# Is there a line of valid.txt for it? Its value is then in "found".
function looked_up(key) {
    if (!(key in value)) return 0
    found = value[key]
    is_used[key] = 1
    return 1
}

# the value of an argument: that of the function, of the functions of a struct, of the name, of the type
function has_value(name, type, argument,    subject) {
    subject = subject_of(name)
    return looked_up(name " " argument) || (subject != "" && looked_up(subject " " argument)) ||
        looked_up(type " " argument) || looked_up(type " *")
}

# adds a statement to those that fill an object or the arguments of a function
function put(text) { filling = filling "    " text "\n" }

# statements that give the field of a valid object its value, at the place p->name
function fill_field(struct, i,    kind, type, name, known, place) {
    kind = field_kind[struct, i]
    type = field_type[struct, i]
    name = field_name[struct, i]
    place = "p->" name
    if (field_count[struct, i] != 1 || kind == "UNKNOWN") return
    known = looked_up(struct " ." name) || looked_up(type " " name)
    if (!known && kind != "POINTER" && kind != "STRUCT") known = looked_up(type " *")
    if (known && found == "none") return
    if (known && found == "object") fill_pointer(type, place)
    else if (known && kind == "REAL") put(place " = R(" found ");")
    else if (known) put(place " = " found ";")
    else if (kind == "STRUCT") put("fill_" type "(&" place ");")
}

# a pointer to an object in memory of its own
function fill_pointer(type, place) {
    n_objects++
    objects = objects "static " type " object_" n_objects "[2];\n"
    put("fill_" type "(object_" n_objects ");")
    put("fill_" type "(object_" n_objects " + 1);")
    put(place " = object_" n_objects ";")
}

# ---- one struct: the table of its fields, and the function that fills a valid object ----

# one line of a table of fields
function entry(struct, name, kind, type, count, output) {
    return sprintf("    {\"%s\", %s, %s, offsetof(%s, %s), %s, %d},\n", name, kind, table_of(type), struct, name, count,
        output)
}

function write_struct(type,    i, n) {
    printf "static const field fields_%s[] = {\n", type
    for (i = 1; i <= fields[type]; i++) {
        if (field_in_double[type, i]) print "#if VM_MANT_DIG > 24"
        printf "%s", entry(type, field_name[type, i], field_kind[type, i], field_type[type, i], field_count[type, i], 0)
        if (field_in_double[type, i]) print "#endif"
    }
    printf "};\nstatic const type type_%s = {\"%s\", sizeof(%s), fields_%s, (int)(sizeof fields_%s / sizeof(field))};\n\n", type,
        type, type, type, type
    filling = ""
    if (looked_up(type " *") && found != "none") put("*p = " found ";")
    else {
        put("memset(p, 0, sizeof *p);")
        for (i = 1; i <= fields[type]; i++) fill_field(type, i)
        if (looked_up(type " prepare")) put(found ";")
    }
    fillers = fillers "static inline void fill_" type "(" type " *p)\n{\n" filling "}\n\n"
    fill_prototypes = fill_prototypes "static inline void fill_" type "(" type " *p);\n"
}

# ---- one argument: its type in A_kind, A_type, A_count and A_output, its value in the statements of filling ----

function table_of(type) {
    if (type in is_struct) return "&type_" type
    return type == "vm_real" ? "&type_vm_real" : "NULL"
}

function add_output(argument, memory, size, type) {
    n_outputs++
    outputs = outputs sprintf("    {\"%s\", %s, %s, %s},\n", argument, memory, size, table_of(type))
}

# a pointer to what the function writes
function argument_of_output(argument, type,    memory) {
    memory = "room[" rooms++ "].bytes"
    put("a->" argument " = (" type " *)(void *)" memory ";")
    add_output(argument, memory, "ROOM_FOR(" type ")", type)
    A_output = 1
}

# a pointer to the numbers {1, 2, 3}
function argument_of_numbers(name, argument, numbers,    memory, parts) {
    memory = "memory_" name "_" argument
    storage = storage "static vm_real " memory "[ROOM];\n"
    put("{")
    put("    const vm_real numbers[] = " numbers ";")
    put("    memset(" memory ", 0, sizeof " memory ");")
    put("    memcpy(" memory ", numbers, sizeof numbers);")
    put("    a->" argument " = " memory ";")
    put("}")
    A_count = split(numbers, parts, ",")
    if (!D_const) add_output(argument, memory, "sizeof " memory, "")
}

# a pointer to objects, all of them equal: text is a value, or "object" for the type's own
function argument_of_objects(name, argument, type, text,    memory, i) {
    memory = "memory_" name "_" argument
    storage = storage "static " type " " memory "[2];\n"
    for (i = 0; i < 2; i++) {
        if (text == "object") put("fill_" type "(" memory " + " i ");")
        else put(memory "[" i "] = " text ";")
    }
    put("a->" argument " = " memory ";")
    if (!D_const) add_output(argument, memory, "sizeof " memory, type)
}

# Returns 0 where a value has to be given in valid.txt and is not.
function argument_of_pointer(name, argument, type,    text) {
    text = ""
    if (D_const ? has_value(name, type, argument) : looked_up(name " " argument)) text = found
    else if (type == subject_of(name) || (D_const && (type in is_struct))) text = "object"
    else if (!D_const) text = "output"
    else if (argument ~ /_or_NULL$/) text = "none"
    if (text == "none") return 1
    if (text == "output") argument_of_output(argument, type)
    else if (type == "vm_real" && text != "") argument_of_numbers(name, argument, text)
    else if (text != "") argument_of_objects(name, argument, type, text)
    return text != ""
}

# An argument of type void *: the object that the function belongs to, or whatever a callback wants
function argument_of_void(name, argument, has_callback,    type) {
    if (looked_up(name " " argument)) type = found
    else type = has_callback ? "" : subject_of(name)
    if (type == "") return has_callback
    A_kind = "POINTER"
    A_type = type
    argument_of_objects(name, argument, type, "object")
    return 1
}

function argument_of_value(name, argument, type, kind,    known) {
    known = has_value(name, type, argument)
    if (kind == "REAL") put("a->" argument " = R(" (known ? found : "0.5") ");")
    else if (known) put("a->" argument " = " found ";")
    else if (kind == "STRUCT") put("fill_" type "(&a->" argument ");")
    else if (kind == "INTEGER" || kind == "LONG") put("a->" argument " = " (argument ~ /^n($|_)/ ? 1 : 0) ";")
    else return 0
    return 1
}

# after declare(); returns 0 where no value is known
function write_argument(name, has_callback) {
    A_kind = D_kind
    A_type = D_type
    A_count = 1
    A_output = 0
    if (D_kind == "POINTER") return argument_of_pointer(name, D_name, D_type)
    if (D_kind == "USER") return argument_of_void(name, D_name, has_callback)
    return argument_of_value(name, D_name, D_type, D_kind)
}

# ---- one function ----

# a parameter as a member of a struct: axis[3] is a pointer
function member_of(text) {
    if (sub(/\[[^\]]*\]$/, "", text)) sub(/[A-Za-z0-9_]+$/, "*&", text)
    sub(/^const vm_real /, "vm_real ", text)
    return text
}

# the statement that calls a function, and keeps what comes of it
function call_of(name, arguments,    type, call) {
    type = result[name]
    call = name "(" arguments ")"
    if (type == "void") return "    o->kind = NOTHING;\n    " call ";\n"
    if (type == "vm_real") return "    o->kind = NUMBER;\n    o->number = " call ";\n"
    if (type ~ /char/) return "    o->kind = TEXT;\n    o->text = " call ";\n"
    if (type == "int" && name ~ /(_is_|_are_|_possible$|_valid$)/)
        return "    o->kind = ANSWER;\n    o->status = " call ";\n"
    if (type == "int" && name !~ /^vm_/) return "    o->kind = MINUS_ONE;\n    o->status = " call ";\n"
    if (type == "int" || type == "long") return "    o->kind = STATUS;\n    o->status = " call ";\n"
    call = "    const " type " returned = " call ";\n"
    if (type in has_judge) return call "    o->kind = STATUS;\n    o->status = judge_" type "(&returned);\n"
    return call "    o->kind = NUMBER;\n    keep_struct(o, &type_" type ", &returned);\n"
}

# fields of arguments that valid.txt sets for this function, such as: vm_broken_rotor_orbit rotor.s 0
function write_fields_of_arguments(name,    key, place, argument) {
    for (key in value) {
        if (index(key, name " ") != 1 || key !~ /\./) continue
        place = substr(key, length(name) + 2)
        argument = place
        sub(/\..*/, "", argument)
        put("memory_" name "_" argument "[0]" substr(place, length(argument) + 1) " = " value[key] ";")
        is_used[key] = 1
    }
    if (looked_up(name " prepare")) put(found ";")
}

# as the integrators take it
function is_right_hand_side(name) {
    return parameters[name] ~ /^vm_real [a-z]+, const vm_real \*[a-z]+, vm_real \*[a-z]+, void \*[a-z0-9_]+$/
}

function write_function(name,    parts, n, i, members, table, arguments, has_callback) {
    n = split_parameters(parameters[name], parts)
    filling = storage = outputs = members = table = arguments = ""
    rooms = n_outputs = has_callback = 0
    for (i = 1; i <= n; i++) {
        declare(parts[i])
        if (D_kind == "CODE") has_callback = 1
    }
    for (i = 1; i <= n; i++) {
        declare(parts[i])
        if (D_text ~ /\]$/) D_kind = "POINTER"
        if (!write_argument(name, has_callback)) {
            missing = missing "FAILED: no valid value for " name ", argument " D_name ": tests/errors/valid.txt needs a line\\n"
            return
        }
        members = members "    " member_of(D_text) ";\n"
        arguments = arguments (i > 1 ? ", " : "") "a->" D_name
        table = table entry("arguments_" name, D_name, A_kind, A_type, A_count, A_output)
    }
    if (n_outputs > 8) bad_lines = bad_lines "main.h has no room for " n_outputs " outputs of " name "\n"
    write_fields_of_arguments(name)
    if (n == 0) members = "    int nothing;\n"
    if (n == 0) table = "    {NULL, REAL, NULL, 0, 0, 0},\n"
    printf "typedef struct arguments_%s {\n%s} arguments_%s;\n", name, members, name
    printf "static arguments_%s given_%s;\n%s", name, name, storage
    printf "static void fill_%s(void)\n{\n    arguments_%s *a = &given_%s;\n", name, name, name
    printf "    memset(a, 0, sizeof *a);\n%s}\n", filling
    printf "static void call_%s(outcome *o)\n{\n    arguments_%s *a = &given_%s;\n", name, name, name
    printf "    (void)a;\n%s}\n", call_of(name, arguments)
    printf "static const field fields_%s[] = {\n%s};\n", name, table
    printf "static const type type_%s = {\"\", sizeof(arguments_%s), fields_%s, %d};\n", name, name, name, n
    printf "static const output outputs_%s[] = {\n%s    {NULL, NULL, 0, NULL},\n};\n\n", name, outputs
    trials = trials sprintf("    {\"%s\", %d, &type_%s, &given_%s, fill_%s, call_%s, outputs_%s},\n", name,
        is_right_hand_side(name), name, name, name, name, name)
}

# ---- the program ----

function read_fields(    i, j, n, parts) {
    for (i = 1; i <= n_structs; i++) {
        n = split(struct_text[structs[i]], parts, ";")
        for (j = 1; j < n; j++) add_fields(structs[i], parts[j])
    }
}

function complain(    key) {
    printf "%s", bad_lines >"/dev/stderr"
    for (key in value)
        if (!is_used[key]) print "valid.txt, line " value_line[key] " is not needed: " key >"/dev/stderr"
}

END {
    read_fields()
    print "/* Written by tests/errors/generate.awk. */"
    print "#include \"tests/errors/trials.h\"\n"
    for (i = 1; i <= n_structs; i++) print "static const type type_" structs[i] ";"
    print ""
    for (i = 1; i <= n_structs; i++) write_struct(structs[i])
    printf "%s\n%s\n%s", fill_prototypes, objects, fillers
    for (i = 1; i <= n_functions; i++) write_function(functions[i])
    printf "static const trial trials[] = {\n%s};\n\n", trials
    printf "static exception exceptions[] = {\n%s    {NULL, NULL, NULL, NULL, 0, 0},\n};\n\n", exceptions
    printf "static const status_name status_names[] = {\n%s    {0, \"VM_OK\"},\n};\n\n", statuses
    printf "static const type *const types[] = {"
    for (i = 1; i <= n_structs; i++) printf "&type_%s,%s", structs[i], i % 5 ? " " : "\n    "
    print "NULL};\n"
    printf "#define MISSING \"%s\"\n", missing
    printf "#define FUNCTIONS %d\n", n_functions
    print "#include \"tests/errors/main.h\""
    complain()
}
