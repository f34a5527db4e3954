/* integrators/saved.h - runs that are saved as bytes and resumed later
   A saved run has all the numbers of an rk45, of its work and of its events, but no pointers. The program that resumes
   it calls rk45_init with the f, n, options and events of the saved run, then rk45_resume. The resumed run has the same
   bits as a run that was not interrupted. A plain copy of an rk45 would not do: y, work, options.events and
   options.atol_each are pointers to arrays of the caller, and f, ctx and the fields of the pair point into the program.

       unsigned char bytes[RK45_SAVED(2, 0)]; // n = 2, no events
       double y0[2] = {1, 0}, work[RK45_WORK(2)], other_work[RK45_WORK(2)];
       rk45 s, again;
       rk45_init(&s, spring, NULL, 2, 0.0, y0, NULL, work); // spring is the ode_rhs of ode.h
       rk45_solve(&s, 10.0);
       rk45_save(&s, sizeof bytes, bytes); // the bytes may go to a file
       rk45_init(&again, spring, NULL, 2, 0.0, y0, NULL, other_work);
       rk45_resume(&again, sizeof bytes, bytes); // goes on where s is

   Bytes are for the same machine, the same type vm_real and the same version of this header.
   Tests: tests/test_saved_runs.c. */
#ifndef VARMASS_INTEGRATORS_SAVED_H
#define VARMASS_INTEGRATORS_SAVED_H

#include <stdint.h>
#include <string.h>

#include "../base/real.h"
#include "ode.h"
#include "options.h"
#include "pairs.h"
#include "rk45.h"
#include "rk87.h"
#include "runs.h"

/* The numbers at the beginning of a saved run. They tell whether it fits the run that resumes it. */
enum {
    VMI_SAVED_FORMAT,
    VMI_SAVED_REAL,
    VMI_SAVED_LONG,
    VMI_SAVED_METHOD,
    VMI_SAVED_N,
    VMI_SAVED_EVENTS,
    VMI_SAVED_HEAD /* how many numbers these are */
};

enum {
    VMI_SAVED_FORMAT_NOW = 0x7601, /* "v" and the number of this format */
    VMI_SAVED_RUN_INTS = VMI_SAVED_HEAD + 9,
    VMI_SAVED_RUN_BYTES = 7 * sizeof(vm_real) + 6 * sizeof(long) + VMI_SAVED_RUN_INTS * sizeof(int) + sizeof(uint32_t),
    VMI_SAVED_EVENT_BYTES = 4 * sizeof(vm_real) + sizeof(long) + 3 * sizeof(int)
};

/* Number of bytes of a saved run with n components and n_events events */
#define VMI_SAVED(numbers, n_events) \
    (VMI_SAVED_RUN_BYTES + (numbers) * (int)sizeof(vm_real) + (n_events) * VMI_SAVED_EVENT_BYTES)
#define RK45_SAVED(n, n_events) VMI_SAVED(RK45_WORK(n), n_events)
#define RK87_SAVED(n, n_events) VMI_SAVED(RK87_WORK(n), n_events)

/* A place in the bytes of a saved run. The numbers go to the bytes if `saves` is not 0, else they come from them. */
typedef struct VM_TAG(vmi_saved_place) {
    unsigned char *to;
    const unsigned char *from;
    int saves;
} vmi_saved_place;

/* Writes the number x of `size` bytes, or reads it, and goes on to the next place */
VM_API void vmi_saved_move(vmi_saved_place *p, void *x, size_t size)
{
    if (p->saves) {
        memcpy(p->to, x, size);
        p->to += size;
    } else {
        memcpy(x, p->from, size);
        p->from += size;
    }
}

VM_API void vmi_saved_move_event(vmi_saved_place *p, ode_event *e)
{
    vmi_saved_move(p, &e->count, sizeof e->count);
    vmi_saved_move(p, &e->t, sizeof e->t);
    vmi_saved_move(p, &e->from, sizeof e->from);
    vmi_saved_move(p, &e->slack, sizeof e->slack);
    vmi_saved_move(p, &e->quiet, sizeof e->quiet);
    vmi_saved_move(p, &e->side, sizeof e->side);
    vmi_saved_move(p, &e->side_ahead, sizeof e->side_ahead);
    vmi_saved_move(p, &e->happens, sizeof e->happens);
}

/* Number of vm_reals in the work of the run s that belong to the integrator */
VM_API long vmi_saved_numbers(const rk45 *s) { return (long)(VMI_K + s->pair.derivatives) * s->n; }

/* Writes all numbers of the run, its work and its events, or reads them */
VM_API void vmi_saved_move_run(vmi_saved_place *p, rk45 *s)
{
    int i;
    vmi_saved_move(p, &s->t, sizeof s->t);
    vmi_saved_move(p, &s->t_low, sizeof s->t_low);
    vmi_saved_move(p, &s->t_old, sizeof s->t_old);
    vmi_saved_move(p, &s->t_old_low, sizeof s->t_old_low);
    vmi_saved_move(p, &s->h, sizeof s->h);
    vmi_saved_move(p, &s->h_done, sizeof s->h_done);
    vmi_saved_move(p, &s->inverse_error, sizeof s->inverse_error);
    vmi_saved_move(p, &s->steps, sizeof s->steps);
    vmi_saved_move(p, &s->rejected, sizeof s->rejected);
    vmi_saved_move(p, &s->evals, sizeof s->evals);
    vmi_saved_move(p, &s->missed, sizeof s->missed);
    vmi_saved_move(p, &s->next_miss, sizeof s->next_miss);
    vmi_saved_move(p, &s->attempts, sizeof s->attempts);
    vmi_saved_move(p, &s->rhs_status, sizeof s->rhs_status);
    vmi_saved_move(p, &s->event, sizeof s->event);
    vmi_saved_move(p, &s->k1, sizeof s->k1);
    vmi_saved_move(p, &s->extended, sizeof s->extended);
    vmi_saved_move(p, &s->failure, sizeof s->failure);
    vmi_saved_move(p, &s->stiff, sizeof s->stiff);
    vmi_saved_move(p, &s->stiff_wait, sizeof s->stiff_wait);
    vmi_saved_move(p, &s->stiff_hits, sizeof s->stiff_hits);
    vmi_saved_move(p, &s->stiff_misses, sizeof s->stiff_misses);
    vmi_saved_move(p, s->work, (size_t)vmi_saved_numbers(s) * sizeof *s->work);
    for (i = 0; i < s->options.n_events; i++) vmi_saved_move_event(p, s->options.events + i);
}

/* The numbers at the beginning of a saved run */
VM_API void vmi_saved_head(const rk45 *s, int *head)
{
    head[VMI_SAVED_FORMAT] = VMI_SAVED_FORMAT_NOW;
    head[VMI_SAVED_REAL] = (int)sizeof(vm_real);
    head[VMI_SAVED_LONG] = (int)sizeof(long);
    head[VMI_SAVED_METHOD] = s->pair.method;
    head[VMI_SAVED_N] = s->n;
    head[VMI_SAVED_EVENTS] = s->options.n_events;
}

/* A checksum of bytes (FNV-1a), which a saved run ends with, so that damaged bytes are refused */
VM_API uint32_t vmi_saved_checksum(const unsigned char *bytes, long count)
{
    uint32_t sum = 2166136261u;
    long i;
    for (i = 0; i < count; i++) sum = (sum ^ bytes[i]) * 16777619u;
    return sum;
}

/* Number of bytes of the saved run s */
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
    vmi_saved_move(&place, head, sizeof head);
    vmi_saved_move_run(&place, &copy);
    sum = vmi_saved_checksum(bytes, (long)(place.to - bytes));
    vmi_saved_move(&place, &sum, sizeof sum);
    return ODE_OK;
}

/* Does the work of rk45_resume for the pair whose number is `method` */
VM_API int vmi_resume(rk45 *s, int method, long size, const unsigned char *bytes)
{
    vmi_saved_place place;
    int head[VMI_SAVED_HEAD];
    uint32_t sum;
    long before; /* number of bytes before the checksum */
    if (!s || !bytes || size < 0 || s->pair.method != method) return ODE_BAD_ARGUMENT;
    if (size < vmi_saved_size(s)) return ODE_WORK_TOO_SMALL;
    before = vmi_saved_size(s) - (long)sizeof sum;
    vmi_saved_head(s, head);
    if (memcmp(head, bytes, sizeof head) != 0) return ODE_BAD_ARGUMENT;
    memcpy(&sum, bytes + before, sizeof sum);
    if (sum != vmi_saved_checksum(bytes, before)) return ODE_BAD_ARGUMENT;
    place.to = NULL;
    place.from = bytes + sizeof head;
    place.saves = 0;
    vmi_saved_move_run(&place, s);
    return ODE_OK;
}

/* Saves a run of rk45 between two calls as bytes, of which there is room for size >= RK45_SAVED(n, number of events).
   The arrays `times` and `states` of events, ctx and the options are not in the bytes: they are the caller's. The cost
   is that of a copy. Returns ODE_OK, ODE_BAD_ARGUMENT for a null pointer or a run by rk87, or ODE_WORK_TOO_SMALL. */
VM_API int rk45_save(const rk45 *s, long size, unsigned char *bytes) { return vmi_save(s, VMI_RK45, size, bytes); }

/* Takes the numbers of a saved run of rk45 into s, which rk45_init has made with the f, n, options and events of the
   saved run. The next step has the same bits as that of the saved run. Returns ODE_OK, ODE_WORK_TOO_SMALL if size is
   less than the bytes of such a run, or ODE_BAD_ARGUMENT for a null pointer, for bytes of a run with another method, n,
   number of events or type, and for damaged bytes; s is then unchanged. */
VM_API int rk45_resume(rk45 *s, long size, const unsigned char *bytes) { return vmi_resume(s, VMI_RK45, size, bytes); }

/* Saves a run of rk87 as bytes, of which there is room for size >= RK87_SAVED(n, number of events).
   All else is as in rk45_save. */
VM_API int rk87_save(const rk87 *s, long size, unsigned char *bytes) { return vmi_save(s, VMI_RK87, size, bytes); }

/* Takes the numbers of a saved run of rk87 into s, which rk87_init has made. All else is as in rk45_resume. */
VM_API int rk87_resume(rk87 *s, long size, const unsigned char *bytes) { return vmi_resume(s, VMI_RK87, size, bytes); }

#endif
