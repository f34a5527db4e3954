/* All fuzz targets without a fuzzer, with any compiler: on the stored inputs, named TARGET-*, and on pseudo-random
   ones.     replay [-n COUNT] [-s SEED] [-t TARGET] [INPUT...]     COUNT of each target */
#define _XOPEN_SOURCE 700 /* setitimer */
#define REPLAY
#include "targets.h"
#include <signal.h>
#include <sys/time.h>
#include <time.h>

enum { LONGEST = 768, SECONDS_EACH = 5 };
static unsigned char bytes[LONGEST];

static void print_input(size_t size)
{
    size_t i;
    printf("  input %s: ", fuzz.target);
    for (i = 0; i < size; i++) printf("%02x", bytes[i]);
    printf("\n");
}

/* An input that does not end is a violation too, and the last */
static void endless(int number)
{
    (void)number;
    fuzz_violated(__FILE__, __LINE__, "ends within SECONDS_EACH");
    print_input((size_t)(fuzz.at - bytes));
    fflush(stdout);
    _Exit(1);
}

static uint64_t next_random(uint64_t *state) /* Steele's splitmix64 */
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

/* One input; a violation is printed with its bytes, as hexadecimal digits that TARGET-*.hex files hold */
static void replay(const fuzz_target *target, size_t size)
{
    const struct itimerval limit = {{0, 0}, {SECONDS_EACH, 0}}; /* of this process: load does not count */
    const long before = fuzz.violations;
    fuzz_begin(target->name, bytes, size);
    setitimer(ITIMER_VIRTUAL, &limit, NULL);
    target->run();
    if (fuzz.violations > before) print_input((size_t)(fuzz.at - bytes));
}

static void replay_random(const fuzz_target *target, long count, uint64_t seed)
{
    const clock_t start = clock();
    const long checks = fuzz.checks;
    uint64_t state = seed;
    double seconds;
    long k;
    size_t i;
    for (k = 0; k < count; k++) {
        for (i = 0; i < LONGEST; i += 8) {
            const uint64_t x = next_random(&state);
            memcpy(bytes + i, &x, 8);
        }
        replay(target, LONGEST);
    }
    seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%-12s %s: %ld inputs, %ld checks, %.0f inputs/s\n", target->name, IS_FLOAT ? "float " : "double", count,
           fuzz.checks - checks, seconds > 0 ? (double)count / seconds : 0);
}

static const fuzz_target *target_of(const char *path)
{
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    size_t i;
    for (i = 0; i < sizeof targets / sizeof *targets; i++)
        if (strncmp(name, targets[i].name, strlen(targets[i].name)) == 0 && name[strlen(targets[i].name)] == '-')
            return targets + i;
    return NULL;
}

/* A stored input: bytes, or in files .hex a line of hexadecimal digits after lines # that say what went wrong */
static int replay_file(const char *path)
{
    const fuzz_target *target = target_of(path);
    FILE *file = fopen(path, "rb");
    size_t size = 0;
    if (!target || !file) {
        printf("%s: no such target or file\n", path);
        return 1;
    }
    if (strstr(path, ".hex")) {
        unsigned byte;
        int c;
        while ((c = getc(file)) == '#')
            while ((c = getc(file)) != '\n' && c != EOF) {}
        ungetc(c, file);
        while (size < LONGEST && fscanf(file, "%2x", &byte) == 1) bytes[size++] = (unsigned char)byte;
    } else size = fread(bytes, 1, LONGEST, file);
    fclose(file);
    memset(bytes + size, 0, LONGEST - size);
    replay(target, size);
    return 0;
}

int main(int argc, char **argv)
{
    const char *only = NULL;
    long count = 0, seed = 1, failed = 0;
    size_t k;
    int i, files = 0;
    signal(SIGVTALRM, endless);
    for (i = 1; i < argc; i++)
        if (argv[i][0] == '-' && i + 1 < argc) {
            if (argv[i][1] == 'n') count = strtol(argv[++i], NULL, 10);
            else if (argv[i][1] == 's') seed = strtol(argv[++i], NULL, 10);
            else only = argv[++i];
        } else {
            failed += replay_file(argv[i]);
            files++;
        }
    for (k = 0; k < sizeof targets / sizeof *targets && count > 0; k++)
        if (!only || strcmp(only, targets[k].name) == 0)
            replay_random(targets + k, only || !targets[k].slow ? count : count / targets[k].slow,
                          (uint64_t)seed << 8 | k);
    failed += fuzz.violations;
    printf("fuzz %s: %ld checks, %d stored inputs, %ld violations\n", IS_FLOAT ? "float" : "double", fuzz.checks,
           files, failed);
    return failed != 0;
}
