/* A controller for a vibrating sieve on strongly nonlinear (cubic) supports: while material leaves the sieve, its amplitude
   falls and its frequency rises; every 10 ms the controller predicts both, and where the sieve is, from the mass that its
   scales report, so that the drive can follow. Float, no heap, no C library but sqrtf; the Ateb functions come from a
   plan in flash (plan.h, made by examples/print_plan ateb 3). Runs on an emulated Cortex-M4F: make firmware.

   What leaves has the sieve's velocity: m x'' + k x^3 = 0, A = A0 (m/m0)^(1/(alpha+3)), by (325) corrected. */
#define VM_USE_FLOAT
#include "../../varmass.h"
#include "plan.h"
#include "board.h"

enum { TICKS = 300, BUDGET = 1000 /* instructions a tick: some 10 us at 100 MHz */ };

typedef struct sieve {
    float k, m0, A0;  /* N/m^3, kg, m */
    float phase;      /* of the Ateb functions, rad, within a period */
    float x, A, rate; /* m, m, rad/s */
} sieve;

/* One tick of dt seconds, the scales reporting m */
static void predict(sieve *s, float m, float dt)
{
    const float period = 4 * plan.quarter.hi, before = s->rate;
    float sa, ca;
    s->A = s->A0 * vm_osc_amplitude_law(m / s->m0, 0, 0, 3);
    s->rate = VM_SQRT(2 * s->k / m) * s->A; /* sqrt((alpha+1)/2) sqrt(k/m) A^((alpha-1)/2) */
    s->phase += (before + s->rate) / 2 * dt;
    if (s->phase > period) s->phase -= period;
    ateb_plan_saca(&plan, s->phase, &sa, &ca);
    s->x = s->A * ca;
}

int main(void)
{
    sieve s = {4e8f, 120, 0.005f, 0, 0.005f, 0.005f, 0};
    uint32_t most = 0, empty, start;
    int tick;
    s.rate = VM_SQRT(2 * s.k / s.m0) * s.A0;
    start = board_instructions();
    empty = board_instructions() - start;
    board_print("    t, ms    mass, g   amplitude, um   frequency, mHz   position, um\n");
    for (tick = 1; tick <= TICKS; tick++) {
        const float m = 120 - 0.2f * (float)tick; /* 20 kg/s leave */
        uint32_t used;
        start = board_instructions();
        predict(&s, m, 0.01f);
        used = board_instructions() - start - empty;
        if (used > most) most = used;
        if (tick % 30) continue;
        board_print_number((int32_t)tick * 10, 9);
        board_print_number((int32_t)(m * 1000), 10);
        board_print_number((int32_t)(s.A * 1e6f), 16);
        board_print_number((int32_t)(s.rate / (4 * plan.quarter.hi) * 1e3f), 17);
        board_print_number((int32_t)(s.x * 1e6f), 15);
        board_print("\n");
    }
    board_print("instructions a tick:");
    board_print_number((int32_t)most, 6);
    board_print(" at most, budget");
    board_print_number(BUDGET, 6);
    board_print(most <= BUDGET ? ": kept\n" : ": EXCEEDED\n");
    return most <= BUDGET ? 0 : 1;
}
