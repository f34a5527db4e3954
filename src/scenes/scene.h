/* scenes/scene.h - what a scene is made of: bodies, effects, events

   A scene is a model that is put together from parts: bodies, the effects that act on them, and the events that change
   them. Its right-hand side evaluates the effects that are listed and nothing else. Each constructor refers to the one
   function that its body, effect or event needs, so that the executable holds no other. All arrays are the caller's.

       vm_scene_body bodies[] = {vm_scene_body_line(2, 0.1, 0)};             // 2 kg, at x = 0.1 m, at rest
       vm_effect effects[] = {vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 0),  // loses 10 g/s, which keeps its velocity
                              vm_effect_spring(0, 0, VM_GROUND, 0, 50, 3, 0)};
       vm_scene scene;
       vm_real t = 0, y[2], work[VM_SCENE_WORK(2)];                          // 2 = vm_scene_size(&scene)
       vm_scene_fault fault;
       int status;
       memset(&scene, 0, sizeof scene);                                      // what is not set is absent
       scene.bodies = bodies;
       scene.n_bodies = 1;
       scene.effects = effects;
       scene.n_effects = 2;
       status = vm_scene_start(&scene, t, y, &fault);                        // checks the scene, and fills y
       if (status < 0) printf("%s %d: %s\n", fault.kind, fault.index, vm_strerror(status));
       else status = vm_scene_run(&scene, &t, 10, y, work, NULL);            // y[0] = x(10), y[1] = v(10)

   Bodies, effects and events are known by their index. With events, scene.events, scene.located (as many) and
   scene.n_events are set as well, before the start. From the start on all arrays stay where they are. A start begins
   everything anew, as the constructors have made it; a second vm_scene_run goes on where the first one ended.
   An evaluation takes about 80 instructions for a body on a line and 20 to 40 for an effect, beyond the arithmetic of
   its force. That is 3 times and 0.3 times the C library's sin.

   The state y has so many numbers for each body, from y[bodies[i].at] on, positions first:
     line   x, v                                 point  r (3), v (3)
     axle   angle, omega                         free   r (3), q (4), v (3), omega (3, in body axes)
     plane  x, y, angle, vx, vy, omega
   One more number follows where the mass is a state. For a growing body two further groups follow: where the mass
   centre is, in body axes and from where it was at the start (2 numbers in the plane, else 3), and the inertia about it
   (1 number in the plane, else xx, yy, zz, xy, xz, yz).

   An effect acts on a coordinate: 0 for a line or an axle; 0, 1, 2 for x, y, angle in the plane; 0, 1, 2 for x, y, z of
   a point or a free body. On an axle, the moment of inertia takes the place of the mass and a torque that of the force.

   Tests: tests/test_scenes.c and tests/test_scene_*.c. Flash that each part takes: docs/scene-sizes.md. */
#ifndef VARMASS_SCENES_SCENE_H
#define VARMASS_SCENES_SCENE_H

#include "../base/real.h"
#include "../integrators/runs.h"
#include "../mechanics/bodies.h"
#include "../mechanics/inertia.h"
#include "../mechanics/streams.h"
#include "../mechanics/vectors.h"

enum {
    VM_LINE = 1, /* along a line */
    VM_AXLE,     /* about a fixed axle */
    VM_PLANE,    /* in the plane: translation and rotation */
    VM_POINT,    /* in space, without rotation */
    VM_FREE      /* in space, with rotation */
}; /* the motions of a body */

enum { VM_GROUND = -1 }; /* in place of the index of a body: an effect acts against the ground */

/* Sums of what acts on a body at one evaluation. Every evaluation clears them, and then each effect adds its part. */
typedef struct VM_TAG(vm_load) {
    vm_real mass;       /* kg (on an axle kg m^2): the mass now */
    vm_real extra_mass; /* kg: M'(v) (v - u) of a mass law M(v), which accelerates together with the mass */
    vm_real mass_rate;  /* kg/s, where the mass is a state */
    vm_real force[6];   /* N (N m on an angle), on each coordinate; 3 to 5: the torque on a free body, inertial axes */
    vm_real mass_by_v;  /* kg s/m: M'(v) of a mass law M(v) */
    vm_real joining_v;  /* m/s: the velocity of the mass that joins or leaves by such a law */
    /* for growing bodies alone */
    vm_vec3 drift;           /* m/s: r' - v, since the mass centre moves in the body; inertial axes */
    vm_vec3 centre_rate;     /* m/s, of the mass centre in the body, body axes */
    vm_inertia inertia_rate; /* kg m^2/s, body axes */
    /* where the scene keeps a budget */
    vm_real reactive[6];    /* N, N m: the part of `force` that is reactive */
    vm_real brought[6];     /* N, N m: momentum and angular momentum that streams bring per second */
    vm_real brought_energy; /* W: kinetic energy that streams bring per second */
    vm_real mixing;         /* W: energy that is lost as this mass takes on the velocity of the body */
} vm_load;

typedef struct VM_TAG(vm_scene_body) vm_scene_body;

/* A body of a scene, made by vm_scene_body_line and its like; the caller changes no field. */
struct VM_TAG(vm_scene_body) {
    /* set by the constructor */
    int motion;        /* VM_LINE, ... */
    int mass_is_state; /* 1: the mass is a number of the state, so that streams can change it */
    int grows;         /* 1: mass centre and inertia are numbers of the state as well */
    int absent;        /* 1: the body is not present until an event brings it in */
    int positions;     /* how many numbers of its state are positions */
    int coordinates;   /* how many are velocities */
    /* set by vm_scene_start, and kept up to date by a run */
    int at;      /* index into y of the first number of its state */
    int mass_at; /* index into y of the mass, where it is a state */
    int away;    /* 1 while the body is not present */
    /* What the motion needs, as pointers, so that a scene links only the motions of its bodies.
       accelerate: the derivatives of the state from the load; returns a status.
       begin: NULL, or what a growing body prepares before the effects of an evaluation. */
    int (*accelerate)(const vm_scene_body *b, const vm_real *state, vm_real *rates);
    void (*begin)(vm_scene_body *b, const vm_real *state);
    vm_real mass; /* kg: the mass, where it is neither a state nor given by a law */
    vm_load load; /* what acts on it at the last evaluation */
    void (*put)(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state);  /* writes the state */
    void (*get)(const vm_scene_body *b, const vm_real *state, vm_body *now);           /* reads the state */
    int (*check)(const vm_body *start); /* NULL, or a check of its inertia, which returns a status */
    vm_body start;                      /* as it starts; of a line mass, r.x, v.x; of an axle mass (kg m^2), omega.z */
    vm_real angle;                      /* rad: the angle at which an axle or a body in the plane starts */
    vm_real law_offset;     /* kg: what jumps, and switching the mass law, have added to the mass by its law */
    vm_inertia inertia;     /* kg m^2: now, body axes */
    vm_inertia invertible;  /* kg m^2: the same with a dummy moment about each axis that has none */
    vmi_mat3 axes;          /* of a growing body: its axes now, in inertial ones */
    int listed_orders;      /* bits (1 << order) of the effects on it so far, while vm_scene_check runs */
    int status;             /* VM_OK, or why the constructor could not make it */
    vm_real noted_mass;     /* kg: the mass before an event, which switching an effect must not change */
};

/* Position (m), velocity (m/s) and acceleration (m/s^2) at time t of a point whose motion is given */
typedef void (*vm_moving_point)(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx);
typedef struct VM_TAG(vm_scene) vm_scene;
typedef struct VM_TAG(vm_effect) vm_effect;
typedef struct VM_TAG(vm_event) vm_event;

/* What a mass law M(t, x, v) returns: the mass and its partial derivatives */
typedef struct VM_TAG(vm_mass_law_values) {
    vm_real mass; /* kg (on an axle kg m^2) */
    vm_real by_t; /* dM/dt, kg/s (on an axle kg m^2/s) */
    vm_real by_x; /* dM/dx, kg/m (on an axle kg m^2/rad) */
    vm_real by_v; /* dM/dv, kg s/m (on an axle kg m^2 s/rad) */
} vm_mass_law_values;

/* The place of an effect in the list of effects on its body */
enum {
    VMI_ORDER_MASS_LAW = 0, /* first, since the others need the mass */
    VMI_ORDER_FORCE = 1,
    VMI_ORDER_LINK = 2 /* last, since its force is the reaction to the others */
};

/* What an effect needs of the mass of its body */
enum { VMI_NEEDS_ANY_MASS = 0, VMI_NEEDS_MASS_STATE = 1, VMI_NEEDS_GROWING_BODY = 2 };

/* Why an effect does not act now, as bits of vm_effect.idle */
enum { VMI_IDLE_SWITCHED_OFF = 1, VMI_IDLE_BODY_AWAY = 2 };

/* An effect, made by vm_effect_spring and its like. To write a new one: effects.h says how, above vmi_effect. */
struct VM_TAG(vm_effect) {
    /* set by the constructor */
    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene); /* adds to the loads */
    int variant; /* which of its variants it is: the kind of mass law, a band in layers, a cord */
    /* set by vm_scene_start, so that an evaluation need not look for it */
    int idle;             /* bits VMI_IDLE_..., 0 while the effect acts */
    int x, v;             /* indices into y: position and velocity of the coordinate on which it acts */
    int other_x, other_v; /* indices into y: position and velocity of the coordinate that takes the reaction */
    vm_load *load;        /* of the body */
    vm_load *other_load;  /* of the body that takes the reaction; NULL for the ground */
    /* set by the constructor, too */
    int body, coordinate;        /* on what it acts */
    int other, other_coordinate; /* against what: another body, or VM_GROUND */
    vm_real p[6];                /* parameters; the enum VMI_<EFFECT>_... of each effect names their places */
    vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx);   /* of vm_effect_force: N or N m */
    vm_mass_law_values (*law)(vm_real t, vm_real x, vm_real v, void *ctx); /* of vm_effect_mass_law */
    vm_moving_point point;                                          /* of vm_effect_link: NULL, or the far end */
    const vm_stream *stream;                                        /* of vm_effect_stream_mass and its like */
    void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx); /* NULL, or of vm_effect_varying */
    int (*check)(const vm_effect *effect); /* NULL, or a check of the parameters, which returns a status */
    void *ctx;                             /* handed to the caller's function */
    unsigned motions;                      /* bit (1 << motion) for each motion of a body on which it can act */
    unsigned other_motions;                /* and of a body against which it can act */
    int needs;                             /* VMI_NEEDS_... */
    int order;                             /* VMI_ORDER_... */
    int off;          /* 1: switched off when the scene starts; the caller may set it before the start */
    int not_on_angle; /* 1: the angle of a body in the plane is no coordinate for it */
};

/* What a jump event does */
enum { VMI_JUMP_NONE = 0, VMI_JUMP_SEPARATES, VMI_JUMP_ATTACHES };

/* An event: when it happens, made by vm_event_at and its like, and what happens then, by vm_then_stop and its like. */
struct VM_TAG(vm_event) {
    vm_real (*when)(const vm_event *event, vm_real t, const vm_real *y); /* crosses zero; NULL: it happens at `time` */
    /* What happens then; returns a status, and VM_STOPPED ends the run. NULL: the event is only counted */
    int (*then)(vm_event *event, vm_real t, vm_real *y);
    vm_real time;  /* s: when it happens, where `when` is NULL; else when it last happened, or when the scene started */
    int direction; /* > 0: `when` rises through zero; < 0: it falls; 0: both */
    /* of events that watch a body: they happen when its coordinate, velocity or mass crosses `value` */
    int watches; /* 1: it watches a body */
    int body, coordinate;
    vm_real value;
    /* of events that switch an effect */
    int switches; /* 1: it switches an effect */
    int effect;   /* index of the effect */
    int off;      /* 1: off; 0: on */
    /* of jumps: check returns a status; jump computes the motion afterwards, on a line, in the plane, or anywhere */
    int (*check)(const vm_scene *scene, const vm_event *event);
    int (*jump)(const vm_event *event, const vm_body *body, vm_body *other, vm_body *result);
    unsigned motions;    /* bit (1 << motion) for each motion of a body that can jump in this way */
    int jump_kind;       /* VMI_JUMP_... */
    int jump_body;       /* the body that loses or gains mass */
    int other;           /* the body that separates from it, or is attached to it */
    vm_body part;        /* the part that separates */
    int relative;        /* 1: the motion of `part` is relative to the body, in its axes */
    vm_impulse external; /* acts from outside during the jump; the caller may set it */
    /* of vm_event_user and vm_then_user */
    vm_real (*user_when)(vm_real t, const vm_real *y, void *ctx);
    int (*user_then)(vm_real t, vm_real *y, void *ctx);
    void *ctx;      /* handed to user_when */
    void *then_ctx; /* handed to user_then */
    /* for the caller */
    long most;  /* it happens so often at the most; 0: without limit. The caller may set it */
    long count; /* how often it has happened */
    /* set by vm_scene_start, and kept up to date by a run */
    long seen;       /* crossings that the integrator had counted when the run last looked */
    vm_scene *scene; /* to which it belongs */
    int status;      /* VM_OK, or why a constructor could not make it */
};

typedef struct VM_TAG(vm_budget) vm_budget;

/* The budget of momentum, angular momentum and energy: what is there, what came in from outside, and the difference.
   vm_scene_keep_budget asks for it, vm_scene_budget_at computes it. */
struct VM_TAG(vm_budget) {
    vm_vec3 impulse;          /* N s, of the effects and of the external impulses of jumps */
    vm_vec3 angular_impulse;  /* N m s, of the same, about the origin */
    vm_vec3 brought;          /* N s: momentum that streams and mass laws brought */
    vm_vec3 brought_angular;  /* N m s: angular momentum that they brought, about the origin */
    vm_real work;             /* J, of the effects, reactive forces excepted */
    vm_real brought_energy;   /* J: kinetic energy that streams and mass laws brought */
    vm_real mixing;           /* J: lost as this mass took on the velocity of the body */
    vm_vec3 momentum;         /* N s, of all bodies that are present */
    vm_vec3 angular_momentum; /* N m s, of all bodies that are present, about the origin */
    vm_real energy;           /* J: their kinetic energy */
    vm_real jump_energy;      /* J: kinetic energy that jumps have added */
    vm_vec3 momentum_defect;  /* N s: what is there, minus what was there at the start, minus what came in */
    vm_vec3 angular_defect;   /* N m s, likewise */
    vm_real energy_defect;    /* J, likewise */
    /* internal; as pointers, so that a scene without a budget links none of it */
    void (*open)(vm_scene *scene, const vm_real *y, vm_real *sums);
    void (*rates)(vm_scene *scene, const vm_real *y, vm_real *rates);
    void (*totals)(const vm_scene *scene, const vm_real *y, vm_budget *budget);
};

/* A scene. Fields that are 0 or NULL mean: there is none. */
struct VM_TAG(vm_scene) {
    /* set by the caller before vm_scene_start */
    vm_scene_body *bodies; /* n_bodies of them */
    int n_bodies;
    vm_effect *effects; /* n_effects of them */
    int n_effects;
    vm_event *events;   /* n_events of them */
    ode_event *located; /* room for n_events, for the integrator, which locates the events */
    int n_events;
    vm_budget *budget; /* by vm_scene_keep_budget: the budget at the start; VM_BUDGET_STATES numbers join the state */
    /* called when a run starts and after each step, or at the times that follow; the run stops where it returns
       another number than 0 */
    int (*output)(vm_real t, const vm_real *y, vm_scene *scene, void *ctx);
    const vm_real *times; /* s: NULL, or n_times rising times; output is then called at them, not after steps */
    int n_times;
    void *output_ctx; /* handed to output */
    int y_size;       /* how many numbers y has room for: a start and a run then check it. 0: they do not */
    int work_size;    /* how many numbers work has room for, likewise */
    /* set by vm_scene_start and by a run, for the caller to read */
    int status;     /* of the right-hand side: VM_OK, or why a body cannot be accelerated or an effect cannot act */
    int ode_status; /* of the integrator: ODE_... */
    int size;       /* how many numbers the state has; 0 before the start */
};

/* Sets of motions, a bit (1 << motion) each */
enum {
    VMI_SINGLE = 1 << VM_LINE | 1 << VM_AXLE, /* one coordinate */
    VMI_FLAT = 1 << VM_PLANE | 1 << VM_POINT,
    VMI_ALL_MOTIONS = VMI_SINGLE | VMI_FLAT | 1 << VM_FREE
};

/* The place of the mass among the numbers of a body, where it is a state */
VM_INLINE int vmi_scene_mass_at(const vm_scene_body *b) { return b->positions + b->coordinates; }

/* How many numbers of the state belong to the body */
VM_INLINE int vmi_scene_body_size(const vm_scene_body *b)
{
    int size = vmi_scene_mass_at(b) + (b->mass_is_state != 0);
    if (b->grows) size += b->motion == VM_PLANE ? 2 + 1 : 3 + 6; /* mass centre and inertia */
    return size;
}

/* Position on which an effect acts, relative to the coordinate that takes the reaction; the ground's position is 0 */
VM_INLINE vm_real vmi_effect_x(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->x] - y[e->other_x] : y[e->x];
}

/* Velocity on which an effect acts, relative to the coordinate that takes the reaction; the ground's velocity is 0 */
VM_INLINE vm_real vmi_effect_v(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->v] - y[e->other_v] : y[e->v];
}

/* Adds the force f to the coordinate of the effect, and -f to the one that takes the reaction */
VM_INLINE void vmi_effect_act(const vm_effect *e, vm_real f)
{
    e->load->force[e->coordinate] += f;
    if (e->other_load) e->other_load->force[e->other_coordinate] -= f;
}

#endif
