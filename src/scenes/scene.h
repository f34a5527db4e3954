/* scenes/scene.h - what a scene is: bodies, effects, events */
#ifndef VARMASS_SCENES_SCENE_H
#define VARMASS_SCENES_SCENE_H

#include "../base/real.h"
#include "../integrators/runs.h"
#include "../mechanics/bodies.h"
#include "../mechanics/inertia.h"
#include "../mechanics/streams.h"
#include "../mechanics/vectors.h"

/* -- Scenes --

   A scene is what a sketch shows: bodies, the effects that act on them, the events that change it. Its right-hand
   side goes through the effects that are listed, and nothing else; what is not listed is not linked either, since
   each constructor below binds the one function that it needs. All arrays are the caller's.

       vm_scene_body bodies[] = {vm_scene_body_line(2, 0.1, 0)};                 // 2 kg, at x = 0.1 m, at rest
       vm_effect effects[] = {vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 1),  // loses 10 g/s, which keeps its velocity
                              vm_effect_spring(0, 0, VM_GROUND, 0, 50, 3, 0)};
       vm_scene scene;
       vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                          // 2 = vm_scene_size(&scene)
       vm_scene_fault culprit;
       int status;
       memset(&scene, 0, sizeof scene);                                      // what is not set is zero: not there
       scene.bodies = bodies;
       scene.n_bodies = 1;
       scene.effects = effects;
       scene.n_effects = 2;
       status = vm_scene_start(&scene, t, y, &culprit);                      // checks, and fills y
       if (status < 0) printf("%s %d: %s\n", culprit.kind, culprit.index, vm_strerror(status));
       else status = vm_scene_run(&scene, &t, 10, y, work, NULL);            // y[0] = x(10), y[1] = v(10)

   With events, scene.events and scene.located (as many) and scene.n_events are set as well, before the start. Bodies,
   effects and events are known by their index. A start begins everything anew, as the bodies, effects and events were
   made; a second vm_scene_run goes on where the first ended. From the start on all arrays stay where they are.
   Where scene.y_size = VM_LENGTH(y) and scene.work_size = VM_LENGTH(work) are set, a start and a run check that the
   arrays are long enough: VM_SHORT_ARRAY.
   An evaluation takes some 80 instructions a line body and 20 to 40 an effect, beyond what its force takes: 3 and 0.3
   times the C library's sin.

   The state has so many numbers a body: a line, an axle 2 (angle and angular velocity), the plane 6, a point 6, free
   in space 13; one more where the mass is itself a state. Positions come first, from bodies[i].at on:
     line   x, v                                     point  r (3), v (3)
     axle   angle, omega                             free   r (3), q (4), v (3), omega (3, in body axes)
     plane  x, y, angle, vx, vy, omega               then the mass; of a growing body the mass centre in its axes
   from where it was first, 2 in the plane or 3, and the inertia about it, 1 or 6 (xx, yy, zz, xy, xz, yz).
   An effect acts on coordinates: 0 of a line or an axle; x, y, angle = 0, 1, 2 in the plane; x, y, z = 0, 1, 2 of a
   point or a free body. What is called mass is the moment of inertia on an axle, and then a force is a torque. */
enum { VM_LINE = 1, VM_AXLE, VM_PLANE, VM_POINT, VM_FREE }; /* how a body can move */
enum { VM_GROUND = -1 };                                    /* instead of a body */

typedef struct VM_TAG(vm_load) {
    vm_real mass;      /* now */
    vm_real extra;     /* to be added to the mass that accelerates, (M'(v) (v - u)) of mass laws M(v) */
    vm_real mass_rate; /* of a mass that is a state */
    vm_real force[6];  /* of each coordinate; 3 to 5 the torque on a free body, inertial axes */
    vm_real by_v, own; /* M'(v), and the velocity of what joins or leaves then */
    /* only of growing bodies: of r' beyond v, m/s, inertial axes; of the mass centre in the body, of the inertia,
       body axes */
    vm_vec3 drift, centre_rate;
    vm_inertia inertia_rate;
    /* only where there is a book: */
    vm_real reactive[6], brought[6]; /* of force, what is reactive; momentum that streams bring, by the second */
    vm_real brought_energy, mixing;  /* their energy, and what is lost as they take on the body's velocity, W */
} vm_load;                           /* what acts on a body at the moment */

typedef struct VM_TAG(vm_scene_body) vm_scene_body;

struct VM_TAG(vm_scene_body) {
    int motion;                 /* VM_LINE, ... */
    int mass_is_state;          /* so that streams can change it */
    int grows;                  /* so are the mass centre in the body and the inertia */
    int absent;                 /* not there until an event brings it in */
    int positions, coordinates; /* numbers of the state that are positions, velocities */
    int at, mass_at; /* where its state begins, the mass in it; set by vm_scene_start, as all that follows */
    int away;        /* not there now */
    /* what the motion needs, so that others are not linked; begin, of growing bodies, before the effects */
    int (*accelerate)(const vm_scene_body *b, const vm_real *state, vm_real *rates);
    void (*begin)(vm_scene_body *b, const vm_real *state);
    vm_real mass; /* now, where neither a state nor a law says it */
    vm_load load; /* what acts on it now */
    void (*put)(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state);
    void (*get)(const vm_scene_body *b, const vm_real *state, vm_body *now);
    int (*check)(const vm_body *start); /* null, or of its inertia */
    vm_body start;  /* as it starts: of a line mass, r.x, v.x; of an axle mass (kg m^2), omega.z and angle */
    vm_real angle;  /* rad, of an axle or in the plane */
    vm_real jumped; /* what jumps, and switching it off and on, have added to the mass of a law */
    vm_inertia inertia, filled; /* now; the same with something about the null axes of a rod or a point */
    vmi_mat3 axes;              /* of a growing body, now */
    int acted;                  /* a mark of vm_scene_check */
    int status;                 /* VM_OK, or why its constructor could not make it */
    vm_real held;               /* its mass before an event, which switching effects must not change */
};

/* Position (m), velocity and acceleration of a point that moves as given */
typedef void (*vm_moving_point)(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx);
typedef struct VM_TAG(vm_scene) vm_scene;
typedef struct VM_TAG(vm_effect) vm_effect;
typedef struct VM_TAG(vm_event) vm_event;

/* What a mass law returns: the mass now, kg (on an axle kg m^2), and its derivatives, M(t, x, v) */
typedef struct VM_TAG(vm_mass_now) {
    vm_real mass, by_t, by_x, by_v;
} vm_mass_now;

struct VM_TAG(vm_effect) {
    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene);
    int idle; /* now: 1 switched off, 2 since a body is not there, 3 both; of vm_scene_start, as x to other_load */
    int x, v, other_x, other_v;  /* y[x], y[v]: position and velocity on which it acts, and those against which */
    vm_load *load, *other_load;  /* of the bodies; null for the ground */
    int body, coordinate;        /* on what it acts */
    int other, other_coordinate; /* against what: another body or VM_GROUND */
    vm_real p[6];                /* parameters, in the order of the constructor's arguments */
    vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx);   /* of vm_effect_force, N or N m */
    vm_mass_now (*law)(vm_real t, vm_real x, vm_real v, void *ctx); /* of vm_effect_mass_law */
    vm_moving_point point;                                          /* of vm_effect_link */
    const vm_stream *stream;                                        /* of vm_effect_stream_mass and its like */
    void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx); /* null, or of vm_effect_varying */
    int (*check)(const vm_effect *effect);                                   /* null, or of the parameters */
    void *ctx;
    unsigned motions, other_motions; /* bit (1 << motion) for each motion that it can act on, against */
    int needs_mass_state;            /* streams do, some of them a growing body (2) */
    int order;                       /* 0 mass laws, 1 the others, 2 links, which are reactions to the others */
    int off;                         /* at the start it is switched off */
    int not_on_angle;                /* set where the angle of a body in the plane is no coordinate for it */
};

struct VM_TAG(vm_event) {
    vm_real (*when)(const vm_event *event, vm_real t, const vm_real *y); /* crosses zero; null: at time */
    int (*then)(vm_event *event, vm_real t, vm_real *y); /* a status; VM_STOPPED ends the run; null: only counted */
    vm_real time;                  /* s, where when is null; of a crossing when it was last, or the start */
    int direction;                 /* > 0 rising, < 0 falling, 0 both */
    int watches, body, coordinate; /* set where it watches a body: what passes */
    vm_real value;                 /* this value */
    int switches, effect, off;     /* set where it switches an effect on or off */
    /* null, or of a jump: what it is on a line, in the plane, or any, and on what motions; 1 where other separates
       from jump_body, -1 where it is attached to it */
    int (*check)(const vm_scene *scene, const vm_event *event);
    int (*jump)(const vm_event *event, const vm_body *body, vm_body *other, vm_body *result);
    unsigned motions;
    int jumps, jump_body, other;
    vm_body part; /* what separates; its motion relative to the body, in its axes, where relative is set */
    int relative;
    vm_impulse external; /* acts during the jump */
    vm_real (*user_when)(vm_real t, const vm_real *y, void *ctx);
    int (*user_then)(vm_real t, vm_real *y, void *ctx);
    void *ctx, *then_ctx; /* of the one, of the other */
    long most;            /* it happens so often; 0: as often as it may */
    long count;           /* it has happened so often */
    long seen;            /* the scene's own from here on */
    vm_scene *scene;
    int status; /* VM_OK, or why a constructor could not make it */
};

/* What came in from outside, and whether it balances: vm_scene_keep_budget asks for it */
typedef struct VM_TAG(vm_budget) vm_budget;

struct VM_TAG(vm_budget) {
    vm_vec3 impulse, angular_impulse;        /* of the effects, about the origin */
    vm_vec3 brought, brought_angular;        /* momentum and angular momentum that streams and mass laws brought */
    vm_real work, brought_energy, mixing;    /* of the effects; of the streams; lost as they mix */
    vm_vec3 momentum, angular_momentum;      /* of all bodies */
    vm_real energy;                          /* kinetic */
    vm_real jump_energy;                     /* that jumps have added */
    vm_vec3 momentum_defect, angular_defect; /* what is there less what was there and what came */
    vm_real energy_defect;
    /* by pointers, so that without a book they are not linked */
    void (*open)(vm_scene *scene, const vm_real *y, vm_real *sums);
    void (*rates)(vm_scene *scene, const vm_real *y, vm_real *rates);
    void (*totals)(const vm_scene *scene, const vm_real *y, vm_budget *book);
};

struct VM_TAG(vm_scene) {
    vm_scene_body *bodies;
    int n_bodies;
    vm_effect *effects;
    int n_effects;
    vm_event *events;
    ode_event *located; /* n_events of them too, for the integrator */
    int n_events;
    vm_budget *book; /* of vm_scene_keep_budget: what was there at the start; VM_BUDGET numbers join the state */
    int (*output)(vm_real t, const vm_real *y, vm_scene *scene,
                  void *ctx); /* null, or called as a run starts and after each step; nonzero stops */
    const vm_real *times; /* null, or n_times increasing times: then output is called at them, not after steps */
    int n_times;
    void *output_ctx;
    int status, ode_status; /* of the right-hand side (an effect that cannot act sets it); of the integrator */
    int y_size, work_size;  /* 0, or how many numbers y and work have room for: then a start and a run check it */
    int size;               /* of the state when it was started, 0 before */
};

enum {
    VMI_SINGLE = 1 << VM_LINE | 1 << VM_AXLE,
    VMI_FLAT = 1 << VM_PLANE | 1 << VM_POINT,
    VMI_ALL_MOTIONS = VMI_SINGLE | VMI_FLAT | 1 << VM_FREE
};

VM_INLINE int vmi_scene_mass_at(const vm_scene_body *b) { return b->positions + b->coordinates; }

VM_INLINE int vmi_scene_body_size(const vm_scene_body *b)
{
    return vmi_scene_mass_at(b) + (b->mass_is_state != 0) + (b->grows ? b->motion == VM_PLANE ? 3 : 9 : 0);
}

/* Position and velocity on which an effect acts, relative to those against which; the ground's are 0 */
VM_INLINE vm_real vmi_effect_x(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->x] - y[e->other_x] : y[e->x];
}

VM_INLINE vm_real vmi_effect_v(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->v] - y[e->other_v] : y[e->v];
}

/* f on the body of e, -f on what it acts against */
VM_INLINE void vmi_effect_act(const vm_effect *e, vm_real f)
{
    e->load->force[e->coordinate] += f;
    if (e->other_load) e->other_load->force[e->other_coordinate] -= f;
}

#endif
