/* arguments.h - fresh arguments for the bench programs of functions: POOL random ones, of which a run takes the
   next WINDOW, so that no branch predictor learns them; loops over them; and the yardstick, the C library's sin
   (float: sinf) of arguments that rise from -10 to 10. Include it after timing.h and a header of the kit. */
#ifndef VARMASS_ARGUMENTS_H
#define VARMASS_ARGUMENTS_H

enum { POOL = 65536, WINDOW = 256, SLOW_WINDOW = 32, ARRAY = 2048 };
static int window = WINDOW; /* arguments of a run; fewer where they take long, lest a run be disturbed */
static vm_real angle[POOL], arg[POOL], parameter[POOL], second[POOL];
static volatile vm_real sink;

static inline double random_number(void) /* 0 <= x < 1 */
{
    static unsigned long long state = 1;
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(state >> 11) / 9007199254740992.;
}

static inline double between(double low, double high) { return low + (high - low) * random_number(); }

/* Where the arguments of this run begin, which takes n of them */
static int next_of(int n) { return bench_position = (bench_position + n) / n % (POOL / n) * n; }

static int next_window(void) { return next_of(window); }

/* Two loops: name_apart over independent arguments (throughput), and name_chain, with the result before, times 0, in
   each argument (latency). x is the angle, u the argument, m the parameter, w a second one; results are a, b, c. */
#define APART(name, ...)                                                             \
    static inline void name##_apart(void)                                            \
    {                                                                                \
        vm_real sum = 0, a = 0, b = 0, c = 0;                                        \
        const int first = next_window();                                             \
        int i;                                                                       \
        for (i = first; i < first + window; i++) {                                   \
            const vm_real x = angle[i], u = arg[i], m = parameter[i], w = second[i]; \
            (void)x;                                                                 \
            (void)u;                                                                 \
            (void)m;                                                                 \
            (void)w;                                                                 \
            __VA_ARGS__;                                                             \
            sum += a + b + c;                                                        \
        }                                                                            \
        sink = sum;                                                                  \
    }
#define CHAIN(name, ...)                                                                         \
    static inline void name##_chain(void)                                                        \
    {                                                                                            \
        vm_real z = 0, a = 0, b = 0, c = 0;                                                      \
        const int first = next_window();                                                         \
        int i;                                                                                   \
        for (i = first; i < first + window; i++) {                                               \
            const vm_real x = angle[i] + z, u = arg[i] + z, m = parameter[i] + z, w = second[i]; \
            (void)x;                                                                             \
            (void)u;                                                                             \
            (void)m;                                                                             \
            (void)w;                                                                             \
            __VA_ARGS__;                                                                         \
            z = 0 * (a + b + c);                                                                 \
        }                                                                                        \
        sink = z;                                                                                \
    }
#define BODY(name, ...)      \
    APART(name, __VA_ARGS__) \
    CHAIN(name, __VA_ARGS__)
BODY(sin, a = VM_LIBM(sin)(x))
BODY(random_sin, a = VM_LIBM(sin)(u))

/* From -10 to 10 in every window, as a loop over time would call sin, which then knows its branches (of random
   arguments it takes more than twice as long: random_sin) */
static void fill_angles(void)
{
    int i;
    for (i = 0; i < POOL; i++) angle[i] = (vm_real)((i % WINDOW + random_number()) * 20 / WINDOW - 10);
}

/* The error, or NO_ERROR where there is no quadruple precision to measure it against */
static inline double known(double error)
{
#ifdef WITH_QUAD
    return error;
#else
    (void)error;
    return NO_ERROR;
#endif
}

/* Lines of a function, of independent arguments and, where a chain is named, in a chain */
static inline void measure_function(const char *job, const char *route, const char *knob, double error,
                                    void (*apart)(void), void (*chain)(void))
{
    char chained[80];
    window = slice(apart, 1) > 5e-4 ? SLOW_WINDOW : WINDOW;
    measure(job, route, knob, known(error), apart, window, "sin", sin_apart, window);
    snprintf(chained, sizeof chained, "%s (chain)", route);
    if (chain) measure(job, chained, knob, known(error), chain, window, "sin (chain)", sin_chain, window);
    window = WINDOW;
}

/* The line of a function of arrays of ARRAY */
static inline void measure_array(const char *job, const char *route, const char *knob, double error,
                                 void (*body)(void))
{
    measure(job, route, knob, known(error), body, ARRAY, "sin", sin_apart, WINDOW);
}

#endif
