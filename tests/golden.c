/* The same bits everywhere: a fixed program that calls every public function of the four headers, the results of each
   of its sections folded into one number. Prints 'golden float|double SECTION HASH' lines, which tests/cross.sh
   compares between targets, compilers and flags; tests/golden/ has the sections, a file for each part of the headers.
   Needs neither stdio nor a heap nor libm beyond what the headers use: on bare metal GOLDEN_PUTS writes a line.
   Arguments are drawn one after the other, since the order in which those of a call are evaluated is open.

   -DGOLDEN_SECTION=jacobi   only that section, where flash is small
   -DGOLDEN_SHOW             before that the bits of each value that is folded: a diff shows what differs first */
#include "../varmass.h"

#ifdef GOLDEN_PUTS
void GOLDEN_PUTS(const char *line);
#else
#include <stdio.h>
#define GOLDEN_PUTS puts
#endif

#ifndef GOLDEN_SHOW
#define GOLDEN_SHOW 0
#endif

enum { COUNT = 200 }; /* random arguments of a quick function */

/* ---- folding ---- */

static uint32_t hash, random_state;

static char *write_hex(char *p, vmi_bits bits, int digits)
{
    static const char digit[] = "0123456789abcdef";
    while (digits-- > 0) *p++ = digit[bits >> 4 * digits & 15];
    *p = 0;
    return p;
}

static void show(vmi_bits bits)
{
    char line[20];
    write_hex(line, bits, 2 * (int)sizeof bits);
    GOLDEN_PUTS(line);
}

/* FNV-1a over the bits, most significant byte first, so that byte order does not matter. Every NaN is folded as 0. */
static void fold(vm_real x)
{
    const vmi_bits bits = x == x ? vmi_to_bits(x) : 0;
    int shift;
    if (GOLDEN_SHOW) show(bits);
    for (shift = 8 * (int)sizeof bits - 8; shift >= 0; shift -= 8)
        hash = (hash ^ (uint32_t)((bits >> shift) & 255)) * 16777619u;
}

static void fold_int(long n) { fold((vm_real)n); } /* a status, a count */

static void fold_text(const char *text)
{
    while (*text) hash = (hash ^ (unsigned char)*text++) * 16777619u;
}

static void fold_all(int n, const vm_real *x)
{
    while (n-- > 0) fold(*x++);
}

static void fold3(vm_vec3 a)
{
    fold(a.x);
    fold(a.y);
    fold(a.z);
}

static void fold_quat(vm_quat q)
{
    fold(q.w);
    fold(q.x);
    fold(q.y);
    fold(q.z);
}

static void fold_inertia(vm_inertia i)
{
    fold(i.xx);
    fold(i.yy);
    fold(i.zz);
    fold(i.xy);
    fold(i.xz);
    fold(i.yz);
}

static void fold_body(const vm_body *b)
{
    fold(b->mass);
    fold_inertia(b->inertia);
    fold_quat(b->q);
    fold3(b->r);
    fold3(b->v);
    fold3(b->omega);
}

static void fold_body2(const vm_body2 *b)
{
    fold(b->mass);
    fold(b->inertia);
    fold(b->x);
    fold(b->y);
    fold(b->angle);
    fold(b->vx);
    fold(b->vy);
    fold(b->omega);
}

/* For outputs that a refusal leaves as they are, so that they have a value to be folded */
#define CLEAR(x) memset(&(x), 0, sizeof(x))

/* ---- drawing ---- */

static vm_real uniform(vm_real low, vm_real high) /* 20 bits */
{
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * ((vm_real)(random_state >> 12) / 1048576);
}

static void draw_all(int n, vm_real low, vm_real high, vm_real *x)
{
    while (n-- > 0) *x++ = uniform(low, high);
}

static vm_vec3 vector(vm_real size)
{
    vm_vec3 a;
    a.x = uniform(-size, size);
    a.y = uniform(-size, size);
    a.z = uniform(-size, size);
    return a;
}

/* ---- sections ---- */

#include "golden/jacobi.h"
#include "golden/elliptic.h"
#include "golden/ateb.h"
#include "golden/integrators.h"
#include "golden/attitude.h"
#include "golden/jumps.h"
#include "golden/rotor.h"
#include "golden/lagrange.h"
#include "golden/rotation.h"
#include "golden/streams.h"
#include "golden/drum.h"
#include "golden/oscillators.h"
#include "golden/slow.h"
#include "golden/duffing.h"
#include "golden/scenes.h"
#include "golden/orbit.h"

/* The texts of statuses, apart from the numbers, so that a better text changes no other hash */
static void golden_texts(void)
{
    int i;
    for (i = -40; i < 6; i++) {
        fold_text(vm_strerror(i));
        fold_text(ode_strerror(i));
    }
}

static void begin(void)
{
    hash = 2166136261u;
    random_state = 1;
}

static void end(const char *section)
{
    char line[64], *p = line;
    const char *words[2];
    int i;
    words[0] = VM_MANT_DIG > 24 ? "golden double " : "golden float ";
    words[1] = section;
    for (i = 0; i < 2; i++)
        while (*words[i]) *p++ = *words[i]++;
    *p++ = ' ';
    write_hex(p, hash, 8);
    GOLDEN_PUTS(line);
}

#define RUN(section) RUN_EXPANDED(section)
#define RUN_EXPANDED(section) \
    do {                      \
        begin();              \
        golden_##section();   \
        end(#section);        \
    } while (0)

int main(void)
{
#ifdef GOLDEN_SECTION
    RUN(GOLDEN_SECTION);
#else
    RUN(kernels);
    RUN(jacobi);
    RUN(elliptic);
    RUN(ateb);
    RUN(beta);
    RUN(integrators);
    RUN(output);
    RUN(attitude);
    RUN(jumps);
    RUN(rotor);
    RUN(lagrange);
    RUN(rotation);
    RUN(streams);
    RUN(drum);
    RUN(oscillators);
    RUN(routes);
    RUN(slow);
    RUN(van_der_pol);
    RUN(resonance);
    RUN(duffing);
    RUN(scenes_on_a_line);
    RUN(scenes_in_the_plane);
    RUN(scenes_in_space);
    RUN(orbit);
    RUN(texts);
#endif
    return 0;
}
