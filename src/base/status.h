/* base/status.h - the statuses that functions return, and what each of them means

   Every function of varmass.h that can fail returns one of these numbers. 0 (VM_OK) means that all went well. A
   positive number means that the function has done its work, but the caller should know something about the result. A
   negative number is an error: the outputs are unchanged. A mistake has the same status in every function. If a call
   has several mistakes, the status names the first in this order, mistakes of a computed body (such as a rest) last:

       a null pointer, a negative count, a choice that does not exist    VM_BAD_ARGUMENT
       an infinite number or NaN                                         VM_NOT_FINITE
       a mass that is not positive                                       VM_BAD_MASS
       a stiffness that is not positive                                  VM_BAD_STIFFNESS
       an inertia that no body can have                                  VM_BAD_INERTIA
       an exponent or another parameter outside its domain               VM_DOMAIN

       vm_body rest;
       int status = vm_separate(&whole, &part, NULL, &rest); // whole and part are vm_bodies
       if (status < 0) printf("%s\n", vm_strerror(status));

   Tests: tests/test_errors.sh, tests/test_refusals_*.c. */
#ifndef VARMASS_BASE_STATUS_H
#define VARMASS_BASE_STATUS_H

#include <string.h>

#include "arrays.h"
#include "real.h"

enum {
    VM_OK = 0,                   /* success */
    VM_NULL_AXIS = 1,            /* done, but a body (a rod or a point) has no inertia about an axis. Its spin about
                                    this axis stays as it was; angular momentum about this axis is lost. */
    VM_STOPPED = 2,              /* done: an event or the caller has ended the run */
    VM_TOLERANCE_MISSED = 3,     /* done, but the estimated error is larger than the tolerance */
    VM_BAD_ARGUMENT = -1,        /* a null pointer, a negative count, or a choice that does not exist */
    VM_NOT_FINITE = -2,          /* an argument, or a number computed from the arguments, is infinite or NaN */
    VM_BAD_MASS = -3,            /* a mass is not positive; in a separation this may be the remaining body's mass */
    VM_BAD_INERTIA = -4,         /* no body can have this inertia; in a separation this may be the remaining body's */
    VM_SINGULAR = -5,            /* a system of linear equations has no unique solution */
    VM_DOMAIN = -6,              /* a parameter lies outside its domain */
    VM_NO_LAW = -7,              /* this problem has no such route (method of solution) or closed form */
    VM_NOT_INTEGRATED = -8,      /* oscillators: the integrator did not reach the end */
    VM_BAD_MOTION = -9,          /* scenes: a kind of motion does not exist, or does not allow this effect or event */
    VM_NO_SUCH_BODY = -10,       /* scenes: no body has this index */
    VM_NO_SUCH_COORDINATE = -11, /* scenes: the body has no such coordinate */
    VM_NO_SUCH_EFFECT = -12,     /* scenes: no effect has this index */
    VM_TWO_MASS_LAWS = -13,      /* scenes: a mass has two laws, or it has a law and is a component of the state too */
    VM_BAD_ORDER = -14,          /* scenes: the law of a body's mass stands after another effect on this body */
    VM_MASS_IS_NO_STATE = -15,   /* scenes: a stream acts on a body whose mass is not a state */
    VM_TOO_MANY_EVENTS = -16,    /* scenes: events follow each other without end */
    VM_BAD_OPTIONS = -17,        /* scenes: the integrator refuses its options */
    VM_STEP_TOO_SMALL = -18,     /* scenes: the tolerance needs steps too short to change the time */
    VM_MAX_STEPS = -19,          /* scenes: max_steps steps were tried before t_end was reached */
    VM_SHORT_ARRAY = -20,        /* scenes and flows: an array is shorter than what is written into it */
    VM_BAD_TIMES = -21,          /* scenes: the times of output do not rise, or t_end lies before the present time */
    VM_SAME_BODY = -22,          /* scenes: a link or a jump connects a body with itself */
    VM_NOT_ON_ANGLE = -23,       /* scenes: this effect cannot act on an angle */
    VM_IS_THERE = -24,           /* scenes: a part would separate into a body that is present already */
    VM_IS_AWAY = -25,            /* scenes: a jump needs a body that is not present */
    VM_TWO_LINKS = -26,          /* scenes: a body has two links, or a link and a landing */
    VM_LINK_NOT_LAST = -27,      /* scenes: another effect on the body stands after its link */
    VM_STORED_STREAM = -28,      /* scenes and reactive loads: a stream comes from a store, which cannot be used here */
    VM_DOES_NOT_GROW = -29,      /* scenes: a stream enters or leaves at a point of a body that is not a growing body */
    VM_NO_EFFECTIVE_MASS = -30,  /* scenes: a mass law M(v) makes the effective mass M + M'(v) (reactive v - u) <= 0 */
    VM_NOT_STARTED = -31,        /* scenes: the scene was not started, or was changed after its start */
    VM_BAD_STIFFNESS = -32,      /* a stiffness is not positive */
    VM_BAD_POINT = -33,          /* scenes: a force at this point would turn a body about an axis without inertia */
    VM_NOT_JOINED = -34          /* scenes: the points of a joint are apart, or move apart, at the start */
};

/* The number of elements of an array, as in scene.y_size = VM_LENGTH(y). The result is wrong for a pointer. */
#define VM_LENGTH(array) ((int)(sizeof(array) / sizeof *(array)))

/* The meaning of any status as a line of text. For an error the text also says, where possible, what to do. */
VM_API const char *vm_strerror(int status)
{
    switch (status) {
    case VM_OK: return "success";
    case VM_NULL_AXIS: return "angular momentum about an axis without inertia was lost";
    case VM_STOPPED: return "an event or the caller ended the run";
    case VM_TOLERANCE_MISSED: return "the estimated error is larger than the tolerance";
    case VM_BAD_ARGUMENT: return "a null pointer, a negative count, or a choice that does not exist";
    case VM_NOT_FINITE: return "a number is infinite or NaN";
    case VM_BAD_MASS: return "a mass is not positive";
    case VM_BAD_INERTIA: return "no body can have this inertia";
    case VM_SINGULAR: return "the linear equations have no unique solution";
    case VM_DOMAIN: return "a parameter is outside its domain";
    case VM_NO_LAW: return "no such route or closed form exists for this problem: choose another route, or integrate";
    case VM_NOT_INTEGRATED: return "the integrator did not reach the end: allow a larger tolerance";
    case VM_BAD_MOTION: return "no body moves in this way, or the effect or event cannot act on a body that does";
    case VM_NO_SUCH_BODY: return "no body has this index: count from 0, the ground is VM_GROUND";
    case VM_NO_SUCH_COORDINATE: return "the body has no such coordinate: count from 0";
    case VM_NO_SUCH_EFFECT: return "no effect has this index: count from 0";
    case VM_TWO_MASS_LAWS: return "a mass has two laws, or has a law and is a state as well: leave one out";
    case VM_BAD_ORDER: return "the law of a mass stands after another effect on its body: list it first";
    case VM_MASS_IS_NO_STATE: return "the stream needs a body whose mass is a state: use vm_scene_body_with_mass_state";
    case VM_TOO_MANY_EVENTS: return "events follow each other without end: let an event stop the run";
    case VM_BAD_OPTIONS: return "the integrator refuses its options: check the tolerances, h0, h_min and h_max";
    case VM_STEP_TOO_SMALL: return "steps became too short to change the time: allow a larger tolerance";
    case VM_MAX_STEPS: return "max_steps steps did not reach t_end: run again to continue, or allow more";
    case VM_SHORT_ARRAY: return "an array is too short: give y or work more room";
    case VM_BAD_TIMES: return "the times of output must rise, and t_end must not lie before the present time";
    case VM_SAME_BODY: return "a link or a jump connects a body with itself: choose two bodies";
    case VM_NOT_ON_ANGLE: return "this effect cannot act on an angle: choose another coordinate";
    case VM_IS_THERE: return "the part that separates is present already: make its body with vm_scene_body_absent";
    case VM_IS_AWAY: return "a jump needs a body that is not present: order the events, or let it be present";
    case VM_TWO_LINKS: return "a body has two links, or a link and a landing: leave one out";
    case VM_LINK_NOT_LAST: return "another effect stands after the link of its body: list the link last";
    case VM_STORED_STREAM: return "a stream from this store cannot be used here: integrate vm_flow_rhs";
    case VM_DOES_NOT_GROW: return "the stream needs a growing body: vm_scene_body_growing_plane or _growing_free";
    case VM_NO_EFFECTIVE_MASS:
        return "M + M'(v) (reactive v - u) of the mass law M(v) is not positive: no force accelerates it";
    case VM_NOT_STARTED: return "the scene was not started, or was changed after its start: call vm_scene_start";
    case VM_BAD_STIFFNESS: return "a stiffness is not positive";
    case VM_BAD_POINT: return "a point body has no other point, and a rod only those on its axis: choose such a point";
    case VM_NOT_JOINED: return "the points of a joint are apart, or move apart, at the start: let the bodies fit";
    default: return "unknown status";
    }
}

/* Returns the rank of an error. Of two errors, the one with the smaller rank is reported. Errors rank in the order -1,
   -2, -3, ..., except that VM_BAD_STIFFNESS ranks directly after VM_BAD_MASS, as at the top of base/status.h. */
VM_API int vmi_error_rank(int status)
{
    if (status == VM_BAD_STIFFNESS) return 2 * -VM_BAD_MASS + 1;
    return 2 * -status;
}

/* Returns the error of two statuses if the other is VM_OK, and of two errors that with the smaller vmi_error_rank. */
VM_API int vmi_first_error(int a, int b)
{
    if (a == VM_OK) return b;
    if (b == VM_OK || vmi_error_rank(a) < vmi_error_rank(b)) return a;
    return b;
}

/* Copies n numbers and returns VM_OK if all of them are finite, else copies nothing and returns VM_NOT_FINITE. */
VM_API int vmi_copy_if_finite(int n, const vm_real *from, vm_real *to)
{
    if (!vmi_all_finite(n, from)) return VM_NOT_FINITE;
    memcpy(to, from, (size_t)n * sizeof *to);
    return VM_OK;
}

#endif
