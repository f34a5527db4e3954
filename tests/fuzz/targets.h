/* targets.h - the fuzz targets; a slow one runs so many times fewer inputs */
#include "ateb.c"
#include "drum.c"
#include "duffing.c"
#include "elliptic.c"
#include "integrators.c"
#include "jacobi.c"
#include "jumps.c"
#include "lagrange.c"
#include "oscillators.c"
#include "rotation.c"
#include "rotor.c"
#include "scenes.c"
#include "slow.c"
#include "streams.c"

typedef struct fuzz_target {
    const char *name;
    void (*run)(void);
    int slow;
} fuzz_target;

static const fuzz_target targets[] = {
    {"ateb", fuzz_ateb, 2},
    {"drum", fuzz_drum, 0},
    {"duffing", fuzz_duffing, 40},
    {"elliptic", fuzz_elliptic, 0},
    {"integrators", fuzz_integrators, 4},
    {"jacobi", fuzz_jacobi, 0},
    {"jumps", fuzz_jumps, 0},
    {"lagrange", fuzz_lagrange, 0},
    {"oscillators", fuzz_oscillators, 20},
    {"rotation", fuzz_rotation, 0},
    {"rotor", fuzz_rotor, 0},
    {"scenes", fuzz_scenes, 10},
    {"slow", fuzz_slow, 4},
    {"streams", fuzz_streams, 0},
};
