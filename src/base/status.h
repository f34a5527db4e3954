/* base/status.h - the statuses that functions return, and their texts */
#ifndef VARMASS_BASE_STATUS_H
#define VARMASS_BASE_STATUS_H

#include <string.h>

#include "arrays.h"
#include "real.h"

enum {
    VM_OK = 0,
    VM_NULL_AXIS = 1,            /* done, but about an axis without inertia (of a rod, a point) the spin stayed as
                                    it was, though angular momentum was left for it: that is lost */
    VM_STOPPED = 2,              /* an event or the caller ended the run */
    VM_TOLERANCE_MISSED = 3,     /* done, but the estimated error is larger than the tolerance */
    VM_BAD_ARGUMENT = -1,        /* a null pointer, a negative count, a choice that does not exist */
    VM_NOT_FINITE = -2,          /* a number that is infinite or NaN, given or arising */
    VM_BAD_MASS = -3,            /* a mass (a stiffness) that is not positive, the rest's included */
    VM_BAD_INERTIA = -4,         /* an inertia that no body has, the rest's included */
    VM_SINGULAR = -5,            /* linear equations without a unique solution */
    VM_DOMAIN = -6,              /* a parameter outside its domain */
    VM_NO_LAW = -7,              /* the route does not exist for this problem */
    VM_NOT_INTEGRATED = -8,      /* oscillators: the integrator gave up */
    VM_BAD_MOTION = -9,          /* scenes: no such motion, or one on which this effect or event cannot act */
    VM_NO_SUCH_BODY = -10,       /* no body has this index */
    VM_NO_SUCH_COORDINATE = -11, /* the body has no such coordinate */
    VM_NO_SUCH_EFFECT = -12,     /* no such effect */
    VM_TWO_MASS_LAWS = -13,      /* two laws for one mass, or a law for a mass that is a state */
    VM_BAD_ORDER = -14,          /* a mass law stands after another effect on its body */
    VM_MASS_IS_NO_STATE = -15,   /* a stream needs a body whose mass is a state */
    VM_TOO_MANY_EVENTS = -16,    /* events do not end */
    VM_BAD_OPTIONS = -17,        /* the integrator refuses its options; this and all that follow are of scenes, */
    VM_STEP_TOO_SMALL = -18,     /* the tolerance asks for steps that the time cannot resolve */
    VM_MAX_STEPS = -19,          /* max_steps attempts did not reach t_end */
    VM_SHORT_ARRAY = -20,        /* of scenes and flows: an array is shorter than what is written into it */
    VM_BAD_TIMES = -21,          /* times of output that do not rise, or a run to a time that is past */
    VM_SAME_BODY = -22,          /* a link or a jump between a body and itself */
    VM_NOT_ON_ANGLE = -23,       /* an effect that cannot act on an angle */
    VM_IS_THERE = -24,           /* a part separates into a body that is there already */
    VM_IS_AWAY = -25,            /* a jump of a body that is not there */
    VM_TWO_LINKS = -26,          /* two links of one body */
    VM_LINK_NOT_LAST = -27,      /* an effect stands after a link of its body */
    VM_STORED_STREAM = -28,      /* of reactive loads, too: a stream with a store */
    VM_DOES_NOT_GROW = -29,      /* a stream that crosses at a point needs a growing body */
    VM_NO_EFFECTIVE_MASS = -30,  /* a mass law M(v): M + M'(v) (v - u) is not positive */
    VM_NOT_STARTED = -31         /* a scene that was not started, or has been changed since */
};

/* How many elements an array has, as in scene.y_size = VM_LENGTH(y). Not of a pointer to them. */
#define VM_LENGTH(array) ((int)(sizeof(array) / sizeof *(array)))

VM_API const char *vm_strerror(int status)
{
    switch (status) {
    case VM_OK: return "success";
    case VM_NULL_AXIS: return "angular momentum about an axis without inertia was lost";
    case VM_STOPPED: return "an event or the caller ended the run";
    case VM_TOLERANCE_MISSED: return "the estimated error is larger than the tolerance";
    case VM_BAD_ARGUMENT: return "null pointer, negative count or unknown choice";
    case VM_NOT_FINITE: return "a number is infinite or NaN";
    case VM_BAD_MASS: return "a mass or a stiffness is not positive";
    case VM_BAD_INERTIA: return "no body has this inertia";
    case VM_SINGULAR: return "linear equations without a unique solution";
    case VM_DOMAIN: return "a parameter outside its domain";
    case VM_NO_LAW: return "the route does not exist for this problem";
    case VM_NOT_INTEGRATED: return "the integrator gave up";
    case VM_BAD_MOTION: return "a motion that does not exist, or that this effect or event cannot act on";
    case VM_NO_SUCH_BODY: return "no body has this index: count from 0, the ground is VM_GROUND";
    case VM_NO_SUCH_COORDINATE: return "the body has no such coordinate";
    case VM_NO_SUCH_EFFECT: return "no such effect";
    case VM_TWO_MASS_LAWS: return "two laws for one mass, or a law for a mass that is a state: leave one out";
    case VM_BAD_ORDER: return "a mass law stands after another effect on its body: list it first";
    case VM_MASS_IS_NO_STATE: return "a stream needs a body whose mass is a state: vm_scene_body_with_mass_state";
    case VM_TOO_MANY_EVENTS: return "events do not end: let an event stop the run where they crowd";
    case VM_BAD_OPTIONS: return "the integrator refuses its options: a tolerance, h0, h_min, h_max or h_max < h_min";
    case VM_STEP_TOO_SMALL: return "the tolerance asks for steps that the time cannot resolve: a force too stiff?";
    case VM_MAX_STEPS: return "max_steps attempts did not reach t_end: run again to go on, or allow more";
    case VM_SHORT_ARRAY: return "an array is shorter than what is written into it: y or work needs more room";
    case VM_BAD_TIMES: return "times of output that do not rise, or a run to a time that is past";
    case VM_SAME_BODY: return "a link or a jump is between two bodies, not between a body and itself";
    case VM_NOT_ON_ANGLE: return "this effect cannot act on an angle: choose another coordinate";
    case VM_IS_THERE: return "a part separates into a body that is there already: make it with vm_scene_body_absent";
    case VM_IS_AWAY: return "a jump of a body that is not there: order the events, or make it present";
    case VM_TWO_LINKS: return "two links of one body: leave one out";
    case VM_LINK_NOT_LAST: return "an effect stands after a link of its body: list the link last";
    case VM_STORED_STREAM: return "a stream with a store is not for this: integrate vm_flow_rhs";
    case VM_DOES_NOT_GROW: return "this stream needs a growing body: vm_scene_body_growing_plane, vm_scene_body_growing_free";
    case VM_NO_EFFECTIVE_MASS: return "M + M'(v) (v - u) of a mass law M(v) is not positive: no force accelerates it";
    case VM_NOT_STARTED: return "the scene was not started, or has been changed since: vm_scene_start";
    default: return "unknown status";
    }
}

/* A result of n numbers, where all are finite */
VM_API int vmi_copy_if_finite(int n, const vm_real *from, vm_real *to)
{
    if (!vmi_all_finite(n, from)) return VM_NOT_FINITE;
    memcpy(to, from, (size_t)n * sizeof *to);
    return VM_OK;
}

#endif
