/* A controller for a vibrating sieve on strongly nonlinear (cubic) supports. While material leaves the sieve, its
   amplitude falls and its frequency rises. Every 10 ms the controller predicts amplitude, frequency and position of
   the sieve from the mass that the sieve's scales report, so that the drive can follow. The program uses float, no
   heap, and of the C library only sqrtf. The Ateb functions come from a plan in flash (plan.h, made by
   examples/print_plan ateb 3). The program runs on an emulated Cortex-M4F: make firmware.

   Material that leaves has the velocity of the sieve. Therefore m x'' + k x^3 = 0, and A = A0 (m/m0)^(1/(alpha+3)) by
   (325) as corrected. */
#define VM_USE_FLOAT
#include "../../varmass.h"
#include "plan.h"
#include "board.h"

enum { TICKS = 300, BUDGET = 1000 /* instructions per tick: about 10 us at 100 MHz */ };

typedef struct sieve {
    float k, m0, A0;  /* N/m^3, kg, m */
    float phase;      /* rad: phase of the Ateb functions, within a period */
    float x, A, rate; /* m, m, rad/s */
} sieve;

/* Computes one tick of dt seconds; m is the mass that the scales report */
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
    uint32_t most = 0;
    int tick;
    s.rate = VM_SQRT(2 * s.k / s.m0) * s.A0;
    board_print("    t, ms    mass, g   amplitude, um   frequency, mHz   position, um\n");
    for (tick = 1; tick <= TICKS; tick++) {
        const float m = 120 - 0.2f * (float)tick; /* 20 kg/s leave */
        uint32_t before, start, end, used;
        before = board_counter();
        start = board_counter();
        predict(&s, m, 0.01f);
        end = board_counter();
        used = board_instructions(start, end) - board_instructions(before, start);
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
