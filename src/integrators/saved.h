/* integrators/saved.h - runs that are saved as bytes and resumed later

   A saved run has the numbers of an rk45 except its options, and those of its work and of its events, but no pointers.
   The program that resumes it calls rk45_init with the f, n, options and events of the saved run, then rk45_resume. The
   resumed run has the same bits as a run that was not interrupted. A plain copy of an rk45 is not enough: y, work,
   options.events and options.atol_each are pointers to arrays of the caller, and f, ctx and the fields of the pair
   point to functions and data of the program.

       unsigned char bytes[RK45_SAVED(2, 0)]; // n = 2, no events
       double y0[2] = {1, 0}, work[RK45_WORK(2)], other_work[RK45_WORK(2)];
       rk45 s, again;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       rk45_solve(&s, 10.0);
       rk45_save(&s, sizeof bytes, bytes); // the bytes may go to a file
       rk45_init(&again, spring, NULL, 2, 0.0, y0, NULL, other_work);
       rk45_resume(&again, sizeof bytes, bytes); // continues from the time of s

   A saved run can be resumed only with the same type vm_real and the same version of this header. The bytes are the
   same on every machine, so that a run that was saved on one machine can be resumed on another one, with the same bits.
   Tests: tests/test_saved_runs.c. */
#ifndef VARMASS_INTEGRATORS_SAVED_H
#define VARMASS_INTEGRATORS_SAVED_H

#include <limits.h>
#include <stdint.h>
#include <string.h>

#include "../base/bits.h"
#include "../base/real.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"
#include "rk45.h"
#include "rk87.h"
#include "runs.h"

/* Indices of the numbers at the beginning of a saved run, its head. A run can resume a saved run only if its own head
   would have the same numbers. */
enum {
    VMI_SAVED_FORMAT,
    VMI_SAVED_REAL,
    VMI_SAVED_LONG,
    VMI_SAVED_METHOD,
    VMI_SAVED_N,
    VMI_SAVED_EVENTS,
    VMI_SAVED_HEAD /* how many numbers the head has */
};

enum {
    VMI_SAVED_FORMAT_NOW = 0x7601, /* "v" and the number of this format */
    VMI_SAVED_RUN_INTS = VMI_SAVED_HEAD + 9,
    VMI_SAVED_INT_BYTES = 4,  /* an int is saved as a number of 32 bits, whatever its size here */
    VMI_SAVED_LONG_BYTES = 8, /* a long is saved as a number of 64 bits */
    VMI_SAVED_SUM_BYTES = 4,
    VMI_SAVED_RUN_BYTES = 7 * sizeof(vm_real) + 6 * VMI_SAVED_LONG_BYTES + VMI_SAVED_RUN_INTS * VMI_SAVED_INT_BYTES +
                          VMI_SAVED_SUM_BYTES,
    VMI_SAVED_EVENT_BYTES = 4 * sizeof(vm_real) + VMI_SAVED_LONG_BYTES + 3 * VMI_SAVED_INT_BYTES
};

/* The number of bytes of a saved run with `numbers` numbers in work and n_events events */
#define VMI_SAVED(numbers, n_events) \
    (VMI_SAVED_RUN_BYTES + (numbers) * (int)sizeof(vm_real) + (n_events) * VMI_SAVED_EVENT_BYTES)
#define RK45_SAVED(n, n_events) VMI_SAVED(RK45_WORK(n), n_events)
#define RK87_SAVED(n, n_events) VMI_SAVED(RK87_WORK(n), n_events)

/* A place in the bytes of a saved run. If `saves` is not 0, the numbers are written to the bytes; else they are read
   from the bytes. */
typedef struct VM_TAG(vmi_saved_place) {
    unsigned char *to;
    const unsigned char *from;
    int saves;
} vmi_saved_place;

/* Writes the lowest `count` bytes of *bits, the lowest byte first, or reads them. Afterwards *p is the place behind
   these bytes */
VM_API void vmi_saved_bits(vmi_saved_place *p, uint64_t *bits, int count)
{
    uint64_t read = 0;
    int i;
    for (i = 0; i < count; i++) {
        if (p->saves) *p->to++ = (unsigned char)(*bits >> (8 * i) & 0xff);
        else read |= (uint64_t)*p->from++ << (8 * i);
    }
    if (!p->saves) *bits = read;
}

/* Writes or reads the bits of a number of type vm_real */
VM_API void vmi_saved_real(vmi_saved_place *p, vm_real *x)
{
    vmi_signed_bits own;
    uint64_t bits;
    memcpy(&own, x, sizeof own);
    bits = (uint64_t)own;
    vmi_saved_bits(p, &bits, (int)sizeof own);
    if (p->saves) return;
    own = (vmi_signed_bits)bits;
    memcpy(x, &own, sizeof own);
}

/* Writes or reads a number of type long. If the number is outside the range of a machine's long, the nearest long is
   read. */
VM_API void vmi_saved_long(vmi_saved_place *p, long *x)
{
    uint64_t bits = (uint64_t)(int64_t)*x;
    int64_t value;
    vmi_saved_bits(p, &bits, VMI_SAVED_LONG_BYTES);
    if (p->saves) return;
    value = (int64_t)bits;
    if (value > LONG_MAX) value = LONG_MAX;
    if (value < LONG_MIN) value = LONG_MIN;
    *x = (long)value;
}

/* Writes or reads a number of type int */
VM_API void vmi_saved_int(vmi_saved_place *p, int *x)
{
    uint64_t bits = (uint64_t)(int64_t)*x;
    vmi_saved_bits(p, &bits, VMI_SAVED_INT_BYTES);
    if (!p->saves) *x = (int)(int32_t)(uint32_t)bits;
}

/* Writes or reads the numbers of an event. */
VM_API void vmi_saved_move_event(vmi_saved_place *p, ode_event *e)
{
    vmi_saved_long(p, &e->count);
    vmi_saved_real(p, &e->t);
    vmi_saved_real(p, &e->from);
    vmi_saved_real(p, &e->slack);
    vmi_saved_real(p, &e->quiet);
    vmi_saved_int(p, &e->side);
    vmi_saved_int(p, &e->side_ahead);
    vmi_saved_int(p, &e->happens);
}

/* Returns the number of vm_real numbers in the work of the run s that belong to the integrator. */
VM_API long vmi_saved_numbers(const rk45 *s) { return (long)(VMI_K + s->pair.derivatives) * s->n; }

/* Writes all numbers of the run, its work and its events, or reads them */
VM_API void vmi_saved_move_run(vmi_saved_place *p, rk45 *s)
{
    const long numbers = vmi_saved_numbers(s);
    long number;
    int i;
    vmi_saved_real(p, &s->t);
    vmi_saved_real(p, &s->t_low);
    vmi_saved_real(p, &s->t_old);
    vmi_saved_real(p, &s->t_old_low);
    vmi_saved_real(p, &s->h);
    vmi_saved_real(p, &s->h_done);
    vmi_saved_real(p, &s->inverse_error);
    vmi_saved_long(p, &s->steps);
    vmi_saved_long(p, &s->rejected);
    vmi_saved_long(p, &s->evals);
    vmi_saved_long(p, &s->missed);
    vmi_saved_long(p, &s->next_miss);
    vmi_saved_long(p, &s->attempts);
    vmi_saved_int(p, &s->rhs_status);
    vmi_saved_int(p, &s->event);
    vmi_saved_int(p, &s->k1);
    vmi_saved_int(p, &s->extended);
    vmi_saved_int(p, &s->failed);
    vmi_saved_int(p, &s->stiff);
    vmi_saved_int(p, &s->stiff_wait);
    vmi_saved_int(p, &s->stiff_hits);
    vmi_saved_int(p, &s->stiff_misses);
    for (number = 0; number < numbers; number++) vmi_saved_real(p, s->work + number);
    for (i = 0; i < s->options.n_events; i++) vmi_saved_move_event(p, s->options.events + i);
}

/* Writes the numbers at the beginning of a saved run. */
VM_API void vmi_saved_head(const rk45 *s, int *head)
{
    head[VMI_SAVED_FORMAT] = VMI_SAVED_FORMAT_NOW;
    head[VMI_SAVED_REAL] = (int)sizeof(vm_real);
    head[VMI_SAVED_LONG] = VMI_SAVED_LONG_BYTES;
    head[VMI_SAVED_METHOD] = s->pair.method;
    head[VMI_SAVED_N] = s->n;
    head[VMI_SAVED_EVENTS] = s->options.n_events;
}

/* Writes or reads the numbers at the beginning of a saved run */
VM_API void vmi_saved_move_head(vmi_saved_place *p, int *head)
{
    int i;
    for (i = 0; i < VMI_SAVED_HEAD; i++) vmi_saved_int(p, head + i);
}

/* Writes or reads a checksum */
VM_API void vmi_saved_move_sum(vmi_saved_place *p, uint32_t *sum)
{
    uint64_t bits = *sum;
    vmi_saved_bits(p, &bits, VMI_SAVED_SUM_BYTES);
    *sum = (uint32_t)bits;
}

/* Returns the checksum of bytes (FNV-1a). A saved run ends with its checksum, so that damaged bytes are refused. */
VM_API uint32_t vmi_saved_checksum(const unsigned char *bytes, long count)
{
    uint32_t sum = 2166136261u;
    long i;
    for (i = 0; i < count; i++) sum = (sum ^ bytes[i]) * 16777619u;
    return sum;
}

/* Returns the number of bytes of the saved run s. */
VM_API long vmi_saved_size(const rk45 *s)
{
    return (long)VMI_SAVED_RUN_BYTES + vmi_saved_numbers(s) * (long)sizeof(vm_real) +
           (long)s->options.n_events * (long)VMI_SAVED_EVENT_BYTES;
}

/* Does the work of rk45_save for the pair whose number is `method` */
VM_API int vmi_save(const rk45 *s, int method, long size, unsigned char *bytes)
{
    vmi_saved_place place;
    int head[VMI_SAVED_HEAD];
    uint32_t sum;
    rk45 copy;
    if (!s || !bytes || size < 0 || s->pair.method != method) return ODE_BAD_ARGUMENT;
    if (size < vmi_saved_size(s)) return ODE_WORK_TOO_SMALL;
    copy = *s;
    place.to = bytes;
    place.from = NULL;
    place.saves = 1;
    vmi_saved_head(s, head);
    vmi_saved_move_head(&place, head);
    vmi_saved_move_run(&place, &copy);
    sum = vmi_saved_checksum(bytes, (long)(place.to - bytes));
    vmi_saved_move_sum(&place, &sum);
    return ODE_OK;
}

/* Does the work of rk45_resume for the pair whose number is `method` */
VM_API int vmi_resume(rk45 *s, int method, long size, const unsigned char *bytes)
{
    vmi_saved_place place;
    int wanted[VMI_SAVED_HEAD], head[VMI_SAVED_HEAD] = {0}, i;
    uint32_t sum = 0;
    long before; /* number of bytes before the checksum */
    if (!s || !bytes || size < 0 || s->pair.method != method) return ODE_BAD_ARGUMENT;
    if (size < vmi_saved_size(s)) return ODE_WORK_TOO_SMALL;
    before = vmi_saved_size(s) - VMI_SAVED_SUM_BYTES;
    place.to = NULL;
    place.from = bytes + before;
    place.saves = 0;
    vmi_saved_move_sum(&place, &sum);
    if (sum != vmi_saved_checksum(bytes, before)) return ODE_BAD_ARGUMENT;
    vmi_saved_head(s, wanted);
    place.from = bytes;
    vmi_saved_move_head(&place, head);
    for (i = 0; i < VMI_SAVED_HEAD; i++)
        if (head[i] != wanted[i]) return ODE_BAD_ARGUMENT;
    vmi_saved_move_run(&place, s);
    return ODE_OK;
}

/* Saves a run of rk45 between two calls as bytes. The array `bytes` has `size` elements, at least RK45_SAVED(n, number
   of events). The arrays `times` and `states` of events, ctx and the options are not saved, because they belong to the
   caller. The time of a call is proportional to the number of bytes. Returns ODE_OK; ODE_BAD_ARGUMENT for a null
   pointer, a negative size or a run by rk87; ODE_WORK_TOO_SMALL if `size` is too small. */
VM_API int rk45_save(const rk45 *s, long size, unsigned char *bytes) { return vmi_save(s, VMI_RK45, size, bytes); }

/* Copies the numbers of a saved run of rk45 into s, which rk45_init has made with the f, n, options and events of the
   saved run. The next step then has the same bits as the next step of the run that was saved. Returns ODE_OK;
   ODE_WORK_TOO_SMALL if size is less than the number of bytes of such a run; ODE_BAD_ARGUMENT for a null pointer, for
   bytes of a run with another method, n, number of events or type, and for damaged bytes. If the status is not ODE_OK,
   s is unchanged. */
VM_API int rk45_resume(rk45 *s, long size, const unsigned char *bytes) { return vmi_resume(s, VMI_RK45, size, bytes); }

/* Saves a run of rk87 as bytes. The array `bytes` has `size` elements, at least RK87_SAVED(n, number of events). All
   else is as in rk45_save. */
VM_API int rk87_save(const rk87 *s, long size, unsigned char *bytes) { return vmi_save(s, VMI_RK87, size, bytes); }

/* Copies the numbers of a saved run of rk87 into s, which rk87_init has made. All else is as in rk45_resume. */
VM_API int rk87_resume(rk87 *s, long size, const unsigned char *bytes) { return vmi_resume(s, VMI_RK87, size, bytes); }

#endif
