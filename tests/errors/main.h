/* main.h - the end of the program that generate.awk writes: each function with valid arguments, then with each mistake
   in turn. One line of output for each outcome that is not the one of the table of errors or of exceptions.txt:
   function, argument, mistake, what it is, what it should be, with tabs between them. */
#ifndef ERRORS_MAIN_H
#define ERRORS_MAIN_H

static sigjmp_buf back;
static volatile sig_atomic_t is_calling;
static const char *in_trial = "none";

/* A crash in a function that is tried ends the call; one elsewhere ends the program. */
static void give_up(int number)
{
    if (!is_calling) {
        fprintf(stderr, "a crash outside of a call: %s\n", in_trial);
        _exit(2);
    }
    siglongjmp(back, number);
}

static const char *name_of(long status)
{
    static char text[32];
    size_t i;
    for (i = 0; i < sizeof status_names / sizeof *status_names; i++)
        if (status_names[i].status == status) return status_names[i].name;
    snprintf(text, sizeof text, "%ld", status);
    return text;
}

static int matches(const char *pattern, const char *text)
{
    if (*pattern == 0) return *text == 0;
    if (*pattern == '*') return matches(pattern + 1, text) || (*text && matches(pattern, text + 1));
    return *pattern == *text && matches(pattern + 1, text + 1);
}

/* Patterns with | between them */
static int matches_one(const char *patterns, const char *text)
{
    char pattern[64];
    const char *end;
    for (;; patterns = end + 1) {
        end = strchr(patterns, '|');
        if (!end) return matches(patterns, text);
        snprintf(pattern, sizeof pattern, "%.*s", (int)(end - patterns), patterns);
        if (matches(pattern, text)) return 1;
    }
}

/* The exception for a mistake: that of the function and its argument, or that of a struct and its field */
static exception *exception_for(const trial *t, const search *s)
{
    exception *e;
    int i;
    for (e = exceptions; e->function; e++) {
        if (!matches_one(e->mistake, s->mistake)) continue;
        if (matches(e->function, t->name) && matches(e->argument, s->path)) return e;
        for (i = 0; i < s->depth; i++)
            if (*s->owner[i] && !strcmp(e->function, s->owner[i]) && matches(e->argument, s->name[i])) return e;
    }
    return NULL;
}

/* ---- One call ---- */

static unsigned char kept[ROOMS][ROOM_BYTES]; /* the outputs as they were */

static void keep_outputs(const trial *t)
{
    int k;
    for (k = 0; t->outputs[k].memory; k++) memcpy(kept[k], t->outputs[k].memory, t->outputs[k].size);
}

/* A field named status tells why a call was refused, so it may change: what was kept gets the same status. */
static void follow_status(const output *o, unsigned char *before)
{
    int i;
    if (!o->type) return;
    for (i = 0; i < o->type->n_fields; i++) {
        const field *f = o->type->fields + i;
        if (f->kind == INTEGER && ends_with(f->name, "status"))
            memcpy(before + f->offset, (char *)o->memory + f->offset, sizeof(int));
    }
}

static void follow_statuses(const trial *t)
{
    int k;
    for (k = 0; t->outputs[k].memory; k++) follow_status(t->outputs + k, kept[k]);
}

/* The first output that a call has changed; working memory is none, nor is what tells where a fault is. */
static const char *touched_output(const trial *t)
{
    int k;
    for (k = 0; t->outputs[k].memory; k++) {
        const output *o = t->outputs + k;
        if (!strcmp(o->name, "work") || (o->type && !strcmp(o->type->name, "vm_scene_fault"))) continue;
        if (memcmp(kept[k], o->memory, o->size) != 0) return o->name;
    }
    return NULL;
}

/* Is one of the numbers that were written not finite? */
static int an_output_is_not_finite(const trial *t)
{
    size_t i;
    int k;
    vm_real x;
    for (k = 0; t->outputs[k].memory; k++) {
        if (memcmp(kept[k], t->outputs[k].memory, t->outputs[k].size) == 0) continue;
        for (i = 0; i + sizeof x <= t->outputs[k].size; i += sizeof x) {
            memcpy(&x, (char *)t->outputs[k].memory + i, sizeof x);
            if (!VM_IS_FINITE(x)) return 1;
        }
    }
    return 0;
}

static const char *signal_name(int number)
{
    if (number == SIGALRM) return "does not return";
    return "crashes";
}

/* Returns what kind of crash there was, 0 for none. */
static int call(const trial *t, outcome *o)
{
    int number;
    memset(o, 0, sizeof *o);
    number = sigsetjmp(back, 1);
    is_calling = number == 0;
    if (number) return number;
    alarm(2);
    t->call(o);
    alarm(0);
    is_calling = 0;
    follow_statuses(t);
    return 0;
}

/* What the function did with valid arguments */
static outcome valid_outcome;
static unsigned char valid_outputs[ROOMS][ROOM_BYTES];
static int valid_changes[ROOMS]; /* whether an output was changed */

/* Did the call do the same as with valid arguments? Then it does not use what was spoiled. */
static int did_the_same(const trial *t, const outcome *o)
{
    int k;
    if (o->status != valid_outcome.status || memcmp(&o->number, &valid_outcome.number, sizeof o->number) != 0) return 0;
    if (memcmp(o->returned, valid_outcome.returned, sizeof o->returned) != 0) return 0;
    for (k = 0; t->outputs[k].memory; k++) {
        const output *one = t->outputs + k;
        if (!valid_changes[k] && memcmp(kept[k], one->memory, one->size) == 0) continue;
        if (memcmp(valid_outputs[k], one->memory, one->size) != 0) return 0;
    }
    return 1;
}

static void keep_valid(const trial *t, const outcome *o)
{
    int k;
    valid_outcome = *o;
    for (k = 0; t->outputs[k].memory; k++) {
        memcpy(valid_outputs[k], t->outputs[k].memory, t->outputs[k].size);
        valid_changes[k] = memcmp(kept[k], t->outputs[k].memory, t->outputs[k].size) != 0;
    }
}

static search start_probing(const trial *t, long mistake, int probes)
{
    search s;
    int k;
    for (k = 0; t->outputs[k].memory; k++) memset(t->outputs[k].memory, STAIN, t->outputs[k].size);
    t->fill();
    s = make_mistake(t, mistake, probes);
    keep_outputs(t);
    return s;
}

static search start(const trial *t, long mistake) { return start_probing(t, mistake, 0); }

/* ---- Verdicts ---- */

static long passed; /* a mistake that did not pass has its line */

static void verdict(const trial *t, const search *s, const char *is, const char *should_be)
{
    if (s->mistake) printf("%s\t%s\t%s\t%s\t%s\n", t->name, s->path, s->mistake, is, should_be);
    else printf("%s\tall\tvalid\t%s\t%s\n", t->name, is, should_be);
}

/* What a call did, in a word: the status, NaN, or what else it did */
static const char *describe(const outcome *o)
{
    static char text[64];
    if (o->kind == STATUS) return name_of(o->status);
    if (o->kind == MINUS_ONE) snprintf(text, sizeof text, "%ld", o->status);
    if (o->kind == ANSWER) snprintf(text, sizeof text, "answer %ld", o->status);
    if (o->kind == TEXT) snprintf(text, sizeof text, "%s", o->text ? "a text" : "no text");
    if (o->kind == NUMBER) snprintf(text, sizeof text, "%g", (double)o->number);
    if (o->kind == NOTHING) snprintf(text, sizeof text, "finite outputs");
    return text;
}

static int works(const trial *t, const outcome *o)
{
    switch (o->kind) {
    case STATUS:
    case MINUS_ONE: return o->status >= 0;
    case ANSWER: return o->status == 1;
    case TEXT: return o->text != NULL;
    case NUMBER: return o->number == o->number;
    default: return !an_output_is_not_finite(t);
    }
}

static int try_valid(const trial *t)
{
    outcome o;
    const search s = start(t, -1);
    const int number = call(t, &o);
    if (number) verdict(t, &s, signal_name(number), "works");
    else if (!works(t, &o)) verdict(t, &s, describe(&o), "works");
    else passed++;
    keep_valid(t, &o);
    return !number && works(t, &o);
}

/* Is a mistake refused as the table of errors says? */
static int is_refused(const trial *t, const search *s, const outcome *o)
{
    const int may_do_nothing = is_one_of(s->mistake, " null negative ");
    switch (o->kind) {
    case STATUS: return o->status == s->status;
    case MINUS_ONE: return o->status == -1;
    case ANSWER: return o->status == 0;
    case TEXT: return o->text != NULL;
    case NUMBER: return o->number != o->number;
    default: return an_output_is_not_finite(t) || (may_do_nothing && !touched_output(t));
    }
}

/* Does the function not use the field, the element or the time that was spoiled? An integer might have been taken
   for the choice of the valid call: the function does not use it if it does the same with another choice, too. */
static int is_unused(const trial *t, long mistake, const search *s, const outcome *o)
{
    outcome other;
    if (!strpbrk(s->path, ".[") && strcmp(s->path, "t") != 0) return 0;
    if (!did_the_same(t, o)) return 0;
    if (!is_one_of(s->mistake, " negative choice ")) return 1;
    start_probing(t, mistake, 1);
    return call(t, &other) == 0 && did_the_same(t, &other);
}

/* The exceptions that hold for all functions:
   - A field of an object, an element of a state, and the time may be anything where the function does not use it.
   - A function of numbers may return an infinite number where it is given one.
   - A right-hand side may give derivatives that are not finite instead of a status, so that the integrator tries a
     shorter step. */
static int is_harmless(const trial *t, const search *s, const outcome *o)
{
    const int is_number = !is_one_of(s->mistake, " null negative choice ");
    const int is_infinite = !strcmp(s->mistake, "infinite");
    if (is_infinite && o->kind == NUMBER && !VM_IS_FINITE(o->number)) return 1;
    if (is_infinite && o->kind == NOTHING && an_output_is_not_finite(t)) return 1;
    return is_number && t->is_right_hand_side && o->status == 0 && an_output_is_not_finite(t);
}

static int is_as_excepted(const trial *t, const outcome *o, const char *instead)
{
    if (!strcmp(instead, "anything")) return 1;
    if (!strcmp(instead, "works")) return works(t, o);
    return o->kind == STATUS && !strcmp(name_of(o->status), instead);
}

static const char *rule_for(const search *s, const outcome *o)
{
    if (o->kind == STATUS) return name_of(s->status);
    if (o->kind == MINUS_ONE) return "-1";
    if (o->kind == ANSWER) return "answer 0";
    if (o->kind == TEXT) return "a text";
    return "NaN";
}

/* Returns whether the mistake was refused with the status of the table. */
static int try_mistake(const trial *t, long mistake, search *s)
{
    char is[128];
    const char *touched;
    outcome o;
    exception *e;
    int number;
    *s = start(t, mistake);
    if (!s->mistake) return 0;
    e = exception_for(t, s);
    if (e && !strcmp(e->instead, "untried")) {
        e->used = 1;
        return 0;
    }
    number = call(t, &o);
    touched = touched_output(t);
    if (number) verdict(t, s, signal_name(number), e ? e->instead : "a refusal");
    else if (is_refused(t, s, &o)) {
        if (touched && (o.kind == STATUS || o.kind == MINUS_ONE)) {
            snprintf(is, sizeof is, "%s, but %s is changed", describe(&o), touched);
            verdict(t, s, is, "outputs untouched");
            return 0;
        }
        passed++;
        return o.kind == STATUS;
    } else if (is_harmless(t, s, &o) || is_unused(t, mistake, s, &o)) {
        passed++;
    } else if (e && is_as_excepted(t, &o, e->instead)) {
        e->used = 1;
        passed++;
    } else {
        snprintf(is, sizeof is, "%s", describe(&o));
        verdict(t, s, is, e && strcmp(e->instead, "works") ? e->instead : rule_for(s, &o));
    }
    return 0;
}

/* ---- Two mistakes at once: the status names the first of them in the order of the table ---- */

static const int order[] = {VM_BAD_ARGUMENT, VM_NOT_FINITE, VM_BAD_MASS, VM_BAD_STIFFNESS, VM_BAD_INERTIA, VM_DOMAIN};
enum { STATUSES = sizeof order / sizeof *order };

/* The mistakes of a function that have each status; 108 are the most that a function has */
enum { MOST_MISTAKES = 512 };
typedef struct mistakes {
    long of[STATUSES][MOST_MISTAKES];
    int n[STATUSES];
} mistakes;

static void keep_mistake(mistakes *seen, int status, long mistake)
{
    int i;
    for (i = 0; i < STATUSES; i++)
        if (order[i] == status && seen->n[i] < MOST_MISTAKES) seen->of[i][seen->n[i]++] = mistake;
}

/* Makes two mistakes: the later one first, since it does not change the numbers of those before it. */
static void try_two(const trial *t, int status, long mistake, long other)
{
    const long earlier = mistake < other ? mistake : other, later = mistake < other ? other : mistake;
    search s = start(t, later);
    const search first = make_mistake(t, earlier, 0);
    outcome o;
    int number;
    if (!strcmp(s.path, first.path)) return;
    keep_outputs(t);
    number = call(t, &o);
    if (!number && o.status == status) {
        passed++;
        return;
    }
    snprintf(s.path + strlen(s.path), sizeof s.path - strlen(s.path), " and %s", first.path);
    s.mistake = "two mistakes";
    if (number) verdict(t, &s, signal_name(number), name_of(status));
    else verdict(t, &s, describe(&o), name_of(status));
}

static void try_pairs(const trial *t, const mistakes *seen)
{
    int i, j, k, m;
    for (i = 0; i < STATUSES; i++)
        for (j = i + 1; j < STATUSES; j++)
            for (k = 0; k < seen->n[i]; k++)
                for (m = 0; m < seen->n[j]; m++) try_two(t, order[i], seen->of[i][k], seen->of[j][m]);
}

static void try_function(const trial *t)
{
    mistakes seen;
    search s;
    long k;
    memset(&seen, 0, sizeof seen);
    if (!try_valid(t)) return;
    for (k = 0;; k++) {
        if (try_mistake(t, k, &s)) keep_mistake(&seen, s.status, k);
        if (!s.mistake) break;
    }
    try_pairs(t, &seen);
}

static void catch_signals(void)
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = give_up;
    sigaction(SIGSEGV, &action, NULL);
    sigaction(SIGFPE, &action, NULL);
    sigaction(SIGBUS, &action, NULL);
    sigaction(SIGALRM, &action, NULL);
}

int main(void)
{
    const size_t n = sizeof trials / sizeof *trials;
    const exception *e;
    size_t i;
    catch_signals();
    for (i = 0; i < n; i++) {
        in_trial = trials[i].name;
        try_function(trials + i);
    }
    fprintf(stderr, "%s", MISSING);
    for (e = exceptions; e->function; e++) {
        if (e->used) continue;
        fprintf(stderr, "exceptions.txt, line %d is not needed: %s %s %s\n", e->line, e->function, e->argument,
                e->mistake);
    }
    for (i = 0; types[i]; i++) {}
    fprintf(stderr, "%ld passed, %ld missing, %ld functions, %ld structs\n", passed, FUNCTIONS - (long)n, (long)n,
            (long)i);
    return 0;
}

#endif
