# Writes the C program that checks the errors of all public functions of varmass.h. It reads, in this order,
#   valid.txt        valid values that the types alone do not tell
#   exceptions.txt   the arguments for which the table of errors does not hold, each with its reason
#   objects.h        for its functions judge_TYPE, which give an object that was returned a status
#   jacobi.h ateb.h integrators.h varmass.h   for structs and statuses, and, but for integrators.h, which has statuses of its
#                    own, for all public functions
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

function add_fields(struct, line,    parts, n, i, type, name) {
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
    if (NF < 6) bad_lines = bad_lines "\nexceptions.txt, line " FNR ": no reason is given"
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
    if (status == "VM_BAD_STIFFNESS") in_statuses = 0
}
line ~ /^typedef [^({]*\(\*[a-z0-9_]+\)\(/ {
    match(line, /\(\*[a-z0-9_]+\)/)
    is_callback[substr(line, RSTART + 2, RLENGTH - 3)] = 1
}
!struct_open && line ~ /^(typedef )?struct VM_TAG\([a-z0-9_]+\) *{/ {
    struct_open = 1
    text = ""
}
struct_open {
    text = text " " line
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

# the struct whose name begins the name of a function, such as vm_drum of vm_drum_rhs; valid.txt may give another beginning
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

function looked_up(key) {
    if (!(key in value)) return 0
    found = value[key]
    is_used[key] = 1
    return 1
}

function has_value(name, type, argument,    subject) {
    subject = subject_of(name)
    return looked_up(name " " argument) || (subject != "" && looked_up(subject " " argument)) ||
        looked_up(type " " argument) || looked_up(type " *")
}

function put(text) { filling = filling "    " text "\n" }

# statements that fill the value at "place"
function fill_struct(type, place) {
    put("fill_" type "(&" place ");")
}

function fill_field(struct, i, place,    kind, type, name, known) {
    kind = field_kind[struct, i]
    type = field_type[struct, i]
    name = field_name[struct, i]
    if (field_count[struct, i] != 1) return
    known = looked_up(struct " ." name) || looked_up(type " " name)
    if (kind == "CODE" || kind == "LONG" || kind == "INTEGER" || kind == "REAL") known = known || looked_up(type " *")
    if (known && found == "none") return
    if (known && kind == "REAL") put(place " = R(" found ");")
    else if (known && kind != "POINTER" && kind != "UNKNOWN") put(place " = " found ";")
    else if (known && kind == "POINTER" && found == "object") {
        objects = objects "static " type " object_" ++n_objects "[2];\n"
        put("fill_" type "(object_" n_objects ");")
        put("fill_" type "(object_" n_objects " + 1);")
        put(place " = object_" n_objects ";")
    }
    else if (known && kind == "POINTER") put(place " = " found ";")
    else if (kind == "STRUCT") fill_struct(type, place)
}

# ---- writing ----

# a name as a string, and the type that a field or pointer leads to
function entry(struct, name, kind, type, count, output) {
    return sprintf("    {\"%s\", %s, %s, offsetof(%s, %s), %s, %d},\n", name, kind,
        (type in is_struct) ? "&type_" type : (type == "vm_real" ? "&type_vm_real" : "NULL"), struct, name, count, output)
}

function write_struct(type,    i, n) {
    printf "static const field fields_%s[] = {\n", type
    for (i = 1; i <= fields[type]; i++)
        printf "%s", entry(type, field_name[type, i], field_kind[type, i], field_type[type, i], field_count[type, i], 0)
    printf "};\nstatic const type type_%s = {\"%s\", sizeof(%s), fields_%s, %d};\n\n", type, type, type, type, fields[type]
    filling = ""
    if (looked_up(type " *") && found != "none") put("*p = " found ";")
    else {
        put("memset(p, 0, sizeof *p);")
        for (i = 1; i <= fields[type]; i++) fill_field(type, i, "p->" field_name[type, i])
        if (looked_up(type " prepare")) put(found ";")
    }
    fillers = fillers "static inline void fill_" type "(" type " *p)\n{\n" filling "}\n\n"
    fill_prototypes = fill_prototypes "static inline void fill_" type "(" type " *p);\n"
}

# the numbers in {1, 2, 3}
function list_length(text,    parts) {
    return split(text, parts, ",")
}

function write_pointer(name, argument, type,    store, subject, given, count, output) {
    subject = subject_of(name)
    if (D_const) given = has_value(name, type, argument)
    else given = looked_up(name " " argument)
    store = "store_" name "_" argument
    count = 1
    output = 0
    if (given && found == "none") return 1
    if (given && found == "output") given = 0
    else if (!D_const && !given && type == subject) {
        given = 1
        found = "object"
    } else if (D_const && !given && (type in is_struct)) {
        given = 1
        found = "object"
    } else if (D_const && !given && argument ~ /_or_NULL$/) return 1
    else if (D_const && !given) return 0
    if (!given) {
        store = "room[" rooms "].bytes"
        put("a->" argument " = (" type " *)(void *)" store ";")
        outputs = outputs sprintf("    {\"%s\", %s, ROOM_FOR(%s), %s},\n", argument, store, type,
            (type in is_struct) ? "&type_" type : (type == "vm_real" ? "&type_vm_real" : "NULL"))
        rooms++
        output = 1
    } else if (type == "vm_real") {
        count = list_length(found)
        stores = stores "static vm_real " store "[ROOM];\n"
        put("{")
        put("    const vm_real numbers[] = " found ";")
        put("    memset(" store ", 0, sizeof " store ");")
        put("    memcpy(" store ", numbers, sizeof numbers);")
        put("    a->" argument " = " store ";")
        put("}")
    } else {
        stores = stores "static " type " " store "[4];\n"
        if (found ~ /^vm_[a-z0-9_]+$/ && (found in is_struct)) found = "object"
        if (found == "object") {
            put("fill_" type "(" store ");")
            put("fill_" type "(" store " + 1);")
        } else {
            put(store "[0] = " found ";")
            put(store "[1] = " found ";")
        }
        put("a->" argument " = " store ";")
    }
    if (given && !D_const)
        outputs = outputs sprintf("    {\"%s\", %s, sizeof %s, %s},\n", argument, store, store,
            (type in is_struct) ? "&type_" type : "NULL")
    P_kind = "POINTER"
    P_type = type
    P_count = count
    P_output = output
    return 1
}

# an argument of type void *: the object that the function belongs to, or whatever a callback wants
function write_user(name, argument, has_callback,    type) {
    if (looked_up(name " " argument)) type = found
    else if (has_callback) type = ""
    else type = subject_of(name)
    if (type == "" || type == "none") return has_callback
    stores = stores "static " type " store_" name "_" argument "[2];\n"
    put("fill_" type "(store_" name "_" argument ");")
    put("a->" argument " = store_" name "_" argument ";")
    P_kind = "POINTER"
    P_type = type
    P_count = 1
    P_output = 0
    outputs = outputs sprintf("    {\"%s\", store_%s_%s, sizeof(%s), &type_%s},\n", argument, name, argument, type, type)
    return 1
}

function write_function(name,    parts, n, i, members, table, call, has_callback, text, ok, type, list, judge) {
    n = split_parameters(parameters[name], parts)
    filling = stores = outputs = ""
    rooms = 0
    for (i = 1; i <= n; i++) {
        declare(parts[i])
        if (D_kind == "CODE") has_callback = 1
    }
    for (i = 1; i <= n; i++) {
        declare(parts[i])
        text = D_text
        if (text ~ /\[[^\]]*\]$/) {
            sub(/\[[^\]]*\]$/, "", text)
            sub(/[A-Za-z0-9_]+$/, "*&", text)
            D_kind = "POINTER"
        }
        sub(/^const vm_real$/, "vm_real", text)
        members = members "    " text ";\n"
        call = call (i > 1 ? ", " : "") "a->" D_name
        P_kind = D_kind
        P_type = D_type
        P_count = 1
        P_output = 0
        ok = 1
        if (D_kind == "REAL") put("a->" D_name " = R(" (has_value(name, "vm_real", D_name) ? found : "0.5") ");")
        else if (D_kind == "INTEGER" || D_kind == "LONG")
            put("a->" D_name " = " (has_value(name, D_type, D_name) ? found : (D_name ~ /^n($|_)/ ? 1 : 0)) ";")
        else if (D_kind == "CODE") {
            if (has_value(name, D_type, D_name)) put("a->" D_name " = " found ";")
            else ok = 0
        } else if (D_kind == "STRUCT") {
            if (has_value(name, D_type, D_name)) put("a->" D_name " = " found ";")
            else fill_struct(D_type, "a->" D_name)
        } else if (D_kind == "POINTER") ok = write_pointer(name, D_name, D_type)
        else if (D_kind == "USER") ok = write_user(name, D_name, has_callback)
        else ok = 0
        if (!ok) {
            missing = missing sprintf("no valid value: %s, argument %s: add a line to tests/errors/valid.txt\n", name, D_name)
            return
        }
        table = table entry("arguments_" name, D_name, P_kind, P_type, P_count, P_output)
    }
    for (key in value)
        if (index(key, name " ") == 1 && key ~ /\./) {
            place = substr(key, length(name) + 2)
            argument = place
            sub(/[.-].*/, "", argument)
            put("store_" name "_" argument "[0]" substr(place, length(argument) + (1)) " = " value[key] ";")
            is_used[key] = 1
        }
    if (looked_up(name " prepare")) put(found ";")
    if (members == "") members = "    int nothing;\n"
    printf "typedef struct arguments_%s {\n%s} arguments_%s;\n", name, members, name
    printf "static arguments_%s given_%s;\n%s", name, name, stores
    printf "static void fill_%s(void)\n{\n    arguments_%s *a = &given_%s;\n    memset(a, 0, sizeof *a);\n%s}\n", name, name, name, filling
    printf "static void call_%s(outcome *o)\n{\n    arguments_%s *a = &given_%s;\n    (void)a;\n", name, name, name
    type = result[name]
    call = name "(" call ")"
    if (type == "void") printf "    o->kind = NOTHING;\n    %s;\n", call
    else if (type == "vm_real") printf "    o->kind = NUMBER;\n    o->number = %s;\n", call
    else if (type ~ /char/) printf "    o->kind = TEXT;\n    o->text = %s;\n", call
    else if ((type == "int" || type == "long") && name ~ /(_is_|_are_|_possible$|_valid$)/)
        printf "    o->kind = ANSWER;\n    o->status = %s;\n", call
    else if (type == "int" && name !~ /^vm_/) printf "    o->kind = MINUS_ONE;\n    o->status = %s;\n", call
    else if (type == "int" || type == "long") printf "    o->kind = STATUS;\n    o->status = %s;\n", call
    else {
        printf "    const %s returned = %s;\n", type, call
        if (type in has_judge) printf "    o->kind = STATUS;\n    o->status = judge_%s(&returned);\n", type
        else printf "    o->kind = NUMBER;\n    keep_struct(o, &type_%s, &returned);\n", type
    }
    print "}"
    if (table == "") table = "    {NULL, REAL, NULL, 0, 0, 0},\n"
    printf "static const field fields_%s[] = {\n%s};\n", name, table
    printf "static const type type_%s = {\"\", sizeof(arguments_%s), fields_%s, %d};\n", name, name, name, n
    printf "static const output outputs_%s[] = {\n%s    {NULL, NULL, 0, NULL},\n};\n\n", name, outputs
    trials = trials sprintf("    {\"%s\", &type_%s, &given_%s, fill_%s, call_%s, outputs_%s},\n", name, name, name, name, name, name)
}

function write_all(    i, j, n, parts) {
    for (i = 1; i <= n_structs; i++) {
        n = split(struct_text[structs[i]], parts, ";")
        for (j = 1; j < n; j++) add_fields(structs[i], parts[j])
    }
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
    gsub(/\n/, "\\n\" \\\n    \"", missing)
    printf "#define MISSING \"%s\"\n", missing
    printf "#define FUNCTIONS %d\n", n_functions
    printf "static const type *const types[] = {"
    for (i = 1; i <= n_structs; i++) printf "&type_%s,%s", structs[i], i % 5 ? " " : "\n    "
    print "NULL};"
    print "#include \"tests/errors/main.h\""
    for (key in value) if (!is_used[key]) unused = unused "valid.txt, line " value_line[key] " is not needed: " key "\n"
    printf "%s%s", substr(bad_lines, 2), unused >"/dev/stderr"
}

END { write_all() }
