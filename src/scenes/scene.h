/* scenes/scene.h - what a scene is made of: bodies, effects, events

   A scene is a model that is put together from parts: bodies, the effects that act on them, and the events that change
   them. The right-hand side of its equations of motion evaluates only the effects that are listed. A constructor is a
   function that makes a body, an effect or an event. It refers only to the functions that this part needs, so that the
   program contains no other functions. The caller provides all arrays.

       vm_scene_body bodies[] = {vm_scene_body_line(2, 0.1, 0)};             // 2 kg, at x = 0.1 m, at rest
       vm_effect effects[] = {vm_effect_mass(0, VM_MASS_OF_T, -0.01, 0, 0),  // loses 10 g/s without a reactive force
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

   Functions refer to a body, an effect or an event by its index in its array. A scene with events also needs
   scene.events, scene.n_events and scene.located, an array of n_events elements, before the start. After the start all
   arrays must stay at their places in memory. A second vm_scene_run continues where the first ended; vm_scene_start
   begins anew, with all bodies, effects and events as the constructors made them. Each listed effect takes time in
   each evaluation of the right-hand side; a motor, for example, adds at most 35 machine instructions.

   The numbers of body i in the state y begin at y[bodies[i].at], and the positions come first. r is the position of the
   mass centre, v its velocity, q the attitude and omega the angular velocity:
     line   x, v                                 point  r (3), v (3)
     axle   angle, omega                         free   r (3), q (4), v (3), omega (3, in body axes)
     plane  x, y, angle, vx, vy, omega
   If the mass is a number of the state (vm_scene_body_with_mass_state), it follows the velocities. A growing body
   (growing.h) has two further groups of numbers: the displacement of the mass centre in the body since the start, in
   body axes (2 numbers in the plane, else 3), and the inertia about the mass centre (1 number in the plane, else xx,
   yy, zz, xy, xz, yz).

   An effect acts on a coordinate of a body. The number of the coordinate is 0 on a line or an axle; 0, 1, 2 for x, y,
   angle in the plane; 0, 1, 2 for x, y, z of a point or a free body. On an axle, a moment of inertia replaces the
   mass, and a torque replaces the force.

   Tests: tests/test_scenes.c and tests/test_scene_*.c. docs/scene-sizes.md lists the flash memory that each part of a
   scene needs. */
#ifndef VARMASS_SCENES_SCENE_H
#define VARMASS_SCENES_SCENE_H

#include "../base/real.h"
#include "../integrators/options.h"
#include "../mechanics/bodies.h"
#include "../mechanics/inertia.h"
#include "../mechanics/streams.h"
#include "../mechanics/vectors.h"

enum {
    VM_LINE = 1, /* motion along a line */
    VM_AXLE,     /* rotation about a fixed axle */
    VM_PLANE,    /* translation and rotation in the plane */
    VM_POINT,    /* translation in space */
    VM_FREE      /* translation and rotation in space */
}; /* the motions of a body */

enum { VM_GROUND = -1 }; /* number that stands for the ground in place of the index of a body */

/* Sums of the loads on a body at one evaluation of the right-hand side. Every evaluation sets the sums to 0, and then
   each effect adds its loads. */
typedef struct VM_TAG(vm_load) {
    vm_real mass;       /* kg (on an axle kg m^2): the present mass */
    vm_real extra_mass; /* kg: dM/dv (reactive v - u) by a mass law M(v), which acts like an additional mass (mass.h) */
    vm_real mass_rate;  /* kg/s: rate of the mass, if the mass is a number of the state */
    vm_real force[6];   /* N (N m on an angle): force on each coordinate; free body: [3] to [5] torque, inertial axes */
    vm_real mass_by_v;  /* kg s/m: the derivative dM/dv of a mass law M(v) */
    vm_real joining_v;  /* m/s: velocity of the mass that joins or leaves by a mass law */
    /* fields for growing bodies only */
    vm_vec3 drift;           /* m/s, inertial axes: rate of the mass centre's position r, minus the velocity v */
    vm_vec3 centre_rate;     /* m/s, body axes: velocity at which the mass centre moves in the body */
    vm_inertia inertia_rate; /* kg m^2/s, body axes: rate of the inertia of the body */
    /* fields used only if the scene keeps a budget */
    vm_real reactive[6];    /* N, N m: the reactive part of `force` */
    vm_real brought[6];     /* N, N m: momentum and angular momentum that streams bring per second */
    vm_real brought_energy; /* W: kinetic energy that streams bring per second */
    vm_real mixing;         /* W: kinetic energy lost per second because mass of streams takes on the body's velocity */
} vm_load;

typedef struct VM_TAG(vm_scene_body) vm_scene_body;

/* A body of a scene. A constructor such as vm_scene_body_line makes it; the caller changes no field. */
struct VM_TAG(vm_scene_body) {
    /* fields set by the constructor */
    int motion;        /* VM_LINE, VM_AXLE, VM_PLANE, VM_POINT or VM_FREE */
    int mass_is_state; /* 1: the mass is a number of the state, so that streams can change it */
    int grows;         /* 1: the mass centre and the inertia are numbers of the state, too */
    int absent;        /* 1: the body is not present until an event brings it in */
    int positions;     /* number of positions in the state of the body */
    int coordinates;   /* number of velocities in the state of the body */
    /* fields set by vm_scene_start and kept up to date by a run */
    int at;      /* index in y of the first number of the body */
    int mass_at; /* index in y of the mass, if the mass is a number of the state */
    int away;    /* 1 while the body is not present */
    /* Functions for the kind of motion of the body. They are pointers, so that a program links only the functions for
       the kinds of motion that its bodies have. `accelerate` computes the derivatives of the state from the load and
       returns a status. `begin` is NULL, or a function that prepares a growing body in each evaluation, before the
       effects act. */
    int (*accelerate)(const vm_scene_body *b, const vm_real *state, vm_real *rates);
    void (*begin)(vm_scene_body *b, const vm_real *state);
    vm_real mass; /* kg: the mass, if it is neither a number of the state nor given by a law */
    vm_load load; /* the loads on the body at the last evaluation */
    void (*put)(vm_scene_body *b, const vm_body *now, vm_real angle, vm_real *state);  /* writes *now to the state */
    void (*get)(const vm_scene_body *b, const vm_real *state, vm_body *now);           /* reads *now from the state */
    int (*check)(const vm_body *start); /* NULL, or a function that checks the inertia and returns a status */
    vm_body start;                      /* motion at the start; a line uses mass, r.x, v.x; an axle mass, omega.z */
    vm_real angle;                      /* rad: the angle of an axle or of a body in the plane at the start */
    vm_vec3 centre;         /* m, body axes: the vector by which jumps have moved the mass centre */
    vm_real law_offset;     /* kg: added to the mass that a law gives; jumps and switching of the law change it */
    vm_inertia inertia;     /* kg m^2, body axes: the present inertia */
    vm_inertia invertible;  /* kg m^2: `inertia` with an arbitrary moment > 0 about axes without moment of inertia */
    vmi_mat3 axes;          /* the present body axes of a growing body, in inertial axes */
    int listed_orders;      /* bit (1 << order) for the `order` of each effect on the body that is checked so far */
    int status;             /* VM_OK, or the reason why the constructor could not make the body */
    vm_real noted_mass;     /* kg: the mass that the body must have after an event */
    void (*shift)(vm_scene_body *b, vm_vec3 step, const vm_real *state); /* adds `step` to `centre`; may be NULL */
};

/* Function of the caller that writes position (m), velocity (m/s) and acceleration (m/s^2) of a point at time t */
typedef void (*vm_moving_point)(vm_real t, vm_vec3 *r, vm_vec3 *v, vm_vec3 *a, void *ctx);
typedef struct VM_TAG(vm_scene) vm_scene;
typedef struct VM_TAG(vm_effect) vm_effect;
typedef struct VM_TAG(vm_event) vm_event;

/* What a mass law M(t, x, v) returns: the mass, and its partial derivatives with respect to time t, position x and
   velocity v */
typedef struct VM_TAG(vm_mass_law_values) {
    vm_real mass; /* kg (on an axle kg m^2): the mass M */
    vm_real by_t; /* kg/s (on an axle kg m^2/s): dM/dt */
    vm_real by_x; /* kg/m (on an axle kg m^2/rad): dM/dx */
    vm_real by_v; /* kg s/m (on an axle kg m^2 s/rad): dM/dv */
} vm_mass_law_values;

/* The place that an effect must have in the list of effects, among the effects on its body */
enum {
    VMI_ORDER_MASS_LAW = 0, /* a mass law stands before all other effects on its body, since they may need the mass */
    VMI_ORDER_FORCE = 1,
    /* a link stands after all other effects on its bodies, since its force depends on all other forces on them */
    VMI_ORDER_LINK = 2,
    VMI_ORDER_JOINTS = 3 /* joints stand after all other effects on their bodies; see vmi_joints_check */
};

/* The kind of mass that an effect needs: any mass, a mass that is a number of the state, or the mass of a growing
   body */
enum { VMI_NEEDS_ANY_MASS = 0, VMI_NEEDS_MASS_STATE = 1, VMI_NEEDS_GROWING_BODY = 2 };

/* Reasons why an effect does not act now, as bits of vm_effect.idle */
enum { VMI_IDLE_SWITCHED_OFF = 1, VMI_IDLE_BODY_AWAY = 2 };

/* An effect. A constructor such as vm_effect_spring makes it. A comment in effects.h, above vmi_effect_between,
   explains how to write the constructor of a new kind of effect. */
struct VM_TAG(vm_effect) {
    /* fields set by the constructor */
    void (*apply)(const vm_effect *effect, vm_real t, const vm_real *y, vm_scene *scene); /* adds to the loads */
    int variant; /* number of the effect's variant: for example which mass law, or whether a band lies in layers */
    /* fields that vm_scene_start sets once, so that evaluations need not compute them */
    int idle;             /* bits VMI_IDLE_... that say why the effect does not act; 0 while the effect acts */
    int x, v;             /* indices in y: position and velocity of the coordinate on which the effect acts */
    int other_x, other_v; /* indices in y: position and velocity of the coordinate on which the opposite force acts */
    vm_load *load;        /* load of the body on which the effect acts */
    vm_load *other_load;  /* load of the body on which the opposite force acts; NULL if that is the ground */
    /* further fields set by the constructor */
    int body, coordinate;        /* index of the body and its coordinate on which the effect acts */
    int other, other_coordinate; /* body and coordinate on which the opposite force acts, or VM_GROUND */
    vm_real p[6];                /* parameters; each kind of effect has an enum that names the indices */
    vm_real (*force)(vm_real t, vm_real x, vm_real v, void *ctx);   /* function given to vm_effect_force */
    vm_mass_law_values (*law)(vm_real t, vm_real x, vm_real v, void *ctx); /* function given to vm_effect_mass_law */
    vm_moving_point point;                                          /* NULL, or the function for vm_effect_link */
    const vm_stream *stream;                                        /* stream of vm_effect_stream_mass, _force, ... */
    void (*vary)(vm_real t, const vm_real *y, vm_stream *stream, void *ctx); /* function given to vm_effect_varying */
    int (*check)(const vm_effect *effect); /* NULL, or a function that checks the parameters and returns a status */
    void *ctx;                             /* pointer that the caller's function receives */
    unsigned motions;                      /* bit (1 << motion) for each kind of motion that `body` may have */
    unsigned other_motions;                /* bit (1 << motion) for each kind of motion that `other` may have */
    int needs;                             /* what kind of mass the effect needs: VMI_NEEDS_... */
    int order;                             /* VMI_ORDER_...: its place among the effects on its body */
    int off;          /* 1: the effect is switched off at the start; the caller may set this field before the start */
    int not_on_angle; /* 1: the effect cannot act on the angle of a body in the plane */
    /* NULL, or a function that checks the effect and needs the scene for this. It is called after the bodies of the
       effect have been checked, and before the parameters p are checked. It returns a status. */
    int (*check_in_scene)(const vm_scene *scene, const vm_effect *effect);
    int (*settle)(const vm_effect *effect, vm_real *y, vm_scene *scene); /* NULL, or gives impulses after a jump */
    const void *parts; /* the vm_point_spring, vm_contact or vm_joints with which the caller made the effect */
};

/* Which part of the action of an event the next run must still do, after a mass law has failed: nothing, the whole
   action, or only the last part of the action, which adjusts the masses after a jump or a switching */
enum { VMI_LEFT_NOTHING = 0, VMI_LEFT_ALL, VMI_LEFT_MASSES };

/* What a jump event does */
enum { VMI_JUMP_NONE = 0, VMI_JUMP_SEPARATES, VMI_JUMP_ATTACHES };

/* An event. A constructor such as vm_event_at says when it happens, and a function such as vm_then_stop says what it
   does. */
struct VM_TAG(vm_event) {
    vm_real (*when)(const vm_event *event, vm_real t, const vm_real *y); /* NULL, or its value is 0 at the event */
    /* NULL if the event is only counted, or the function that the event calls. It returns a status; VM_STOPPED ends the
       run. */
    int (*then)(vm_event *event, vm_real t, vm_real *y);
    vm_real time;  /* s: the set time of the event; if `when` is not NULL: the last crossing, at first the start */
    int direction; /* > 0: the event happens if `when` rises through 0; < 0: if it falls through 0; 0: in both cases */
    /* Each is NULL, or a function that returns a status. check_when checks the condition for the event, `check` checks
       its action. */
    int (*check_when)(const vm_scene *scene, const vm_event *event);
    int (*check)(const vm_scene *scene, const vm_event *event);
    /* fields for an event that happens when a coordinate, a velocity or the mass of a body crosses `value` */
    int body, coordinate;
    vm_real value;
    /* fields for an event that switches effects */
    int effect;    /* index of the first effect */
    int n_effects; /* number of effects that are switched; they follow each other in the list */
    int off;       /* 1: the effects are switched off; 0: on */
    /* fields for a jump; `jump` is a function that computes the motion after the jump: one for a line or an axle, one
       for the plane, or one for any kind of motion */
    int (*jump)(const vm_event *event, const vm_body *body, vm_body *other, vm_body *result);
    unsigned motions;    /* bit (1 << motion) for each kind of motion that a body may have for this jump */
    int jump_kind;       /* VMI_JUMP_NONE, VMI_JUMP_SEPARATES or VMI_JUMP_ATTACHES */
    int jump_body;       /* index of the body that loses or gains mass */
    int other;           /* index of the body that separates from jump_body, or is attached to it */
    vm_body part;        /* the part that separates */
    int relative;        /* 1: the motion of `part` is given relative to the body, in body axes */
    vm_impulse external; /* impulse from outside during the jump; the caller may set this field */
    /* fields for vm_event_user and vm_then_user */
    vm_real (*user_when)(vm_real t, const vm_real *y, void *ctx);
    int (*user_then)(vm_real t, vm_real *y, void *ctx);
    void *ctx;      /* pointer that user_when receives */
    void *then_ctx; /* pointer that user_then receives */
    /* fields for the caller */
    long most;  /* largest number of times that the event happens; 0: no limit. The caller may set this field */
    long count; /* how often the event has happened */
    /* fields set by vm_scene_start and kept up to date by a run */
    long seen;       /* number of crossings that the integrator has found and the run has already handled */
    vm_scene *scene; /* the scene to which the event belongs */
    int status;      /* VM_OK, or the reason why a constructor could not make the event */
    const void *parts; /* the caller's vm_contact, which the event uses */
    vm_event *actions; /* NULL, or the array of n_actions events whose actions this event does (vm_then_all) */
    int n_actions;
    /* fields for an action that a failing mass law has interrupted; the next run does the rest of the action */
    int left;        /* VMI_LEFT_...: how much of the action is left */
    int next_action; /* index of the interrupted action in the list of actions */
    int so_far;      /* status of the actions before the interrupted action */
    vm_real energy;  /* J: kinetic energy of all bodies before a jump */
};

typedef struct VM_TAG(vm_budget) vm_budget;

/* The budget of momentum, angular momentum and energy of a scene: what the bodies have, what was supplied from outside
   since the start, and the defects, which are the differences. vm_scene_keep_budget makes a scene keep a budget, and
   vm_scene_budget_at computes it. */
struct VM_TAG(vm_budget) {
    vm_vec3 impulse;          /* N s: sum of the impulses of effects, of the external impulses of jumps, and of the
                                 impulses of landings and of joints at the ground */
    vm_vec3 angular_impulse;  /* N m s, about the origin: sum of the angular impulses that belong to `impulse` */
    vm_vec3 brought;          /* N s: momentum that streams and mass laws brought to the bodies */
    vm_vec3 brought_angular;  /* N m s, about the origin: angular momentum that streams and mass laws have brought */
    vm_real work;             /* J: work of the effects, without reactive forces */
    vm_real brought_energy;   /* J: kinetic energy that streams and mass laws brought to the bodies */
    vm_real mixing;           /* J: kinetic energy lost as the mass of streams took on the velocity of the body */
    vm_vec3 momentum;         /* N s: momentum of all bodies that are present */
    vm_vec3 angular_momentum; /* N m s, about the origin: angular momentum of all bodies that are present */
    vm_real energy;           /* J: kinetic energy of all bodies that are present */
    vm_real jump_energy;      /* J: kinetic energy that jumps have added */
    /* Defects: the part of the change since the start that was not supplied from outside. The index 0 marks values at
       the start.
         momentum_defect  momentum - momentum_0 - impulse - brought, in N s
         angular_defect   angular_momentum - angular_momentum_0 - angular_impulse - brought_angular, in N m s
         energy_defect    energy - energy_0 - work - brought_energy + mixing - jump_energy, in J */
    vm_vec3 momentum_defect;
    vm_vec3 angular_defect;
    vm_real energy_defect;
    /* functions for internal use; they are pointers, so that a program without a budget does not link these
       functions */
    void (*open)(vm_scene *scene, const vm_real *y, vm_real *sums);
    void (*rates)(vm_scene *scene, const vm_real *y, vm_real *rates);
    void (*totals)(const vm_scene *scene, const vm_real *y, vm_budget *budget);
};

/* A scene. If the field for a part, such as `budget`, is 0 or NULL, the scene does not have this part. */
struct VM_TAG(vm_scene) {
    /* fields set by the caller before vm_scene_start */
    vm_scene_body *bodies; /* array of n_bodies bodies */
    int n_bodies;
    vm_effect *effects; /* array of n_effects effects */
    int n_effects;
    vm_event *events;   /* array of n_events events */
    ode_event *located; /* array of n_events elements, with which the integrator locates the events */
    int n_events;
    vm_budget *budget; /* NULL, or the budget of vm_scene_keep_budget; y then has VM_BUDGET_STATES more numbers */
    /* NULL, or a function of the caller that writes or keeps results. If `times` is NULL, a run calls it at its start
       and after each step; else only at the times of this array. If this function returns a number other than 0, the
       run stops. */
    int (*output)(vm_real t, const vm_real *y, vm_scene *scene, void *ctx);
    const vm_real *times; /* s: NULL, or an array of n_times increasing times at which output is called */
    int n_times;
    void *output_ctx; /* pointer that output receives */
    int y_size;       /* number of elements of y, which vm_scene_start and vm_scene_run check; 0 means no check */
    int work_size;    /* number of elements of work, which vm_scene_run checks; 0 means no check */
    /* fields set by vm_scene_start and by a run, for the caller to read */
    int status;     /* VM_OK, or the reason why a body cannot be accelerated or an effect cannot act */
    int ode_status; /* status of the integrator: ODE_OK or another status of ode.h */
    int size;       /* number of elements of the state; 0 before the start */
};

/* Sets of kinds of motion, with the bit (1 << motion) for each kind */
enum {
    VMI_SINGLE = 1 << VM_LINE | 1 << VM_AXLE, /* motions with one coordinate */
    VMI_FLAT = 1 << VM_PLANE | 1 << VM_POINT, /* a body in the plane, and a point in space */
    VMI_ALL_MOTIONS = VMI_SINGLE | VMI_FLAT | 1 << VM_FREE
};

/* The index of the mass among the numbers of a body, if the mass is a number of the state */
VM_INLINE int vmi_scene_mass_at(const vm_scene_body *b) { return b->positions + b->coordinates; }

/* The number of elements of the state that belong to the body */
VM_INLINE int vmi_scene_body_size(const vm_scene_body *b)
{
    int size = vmi_scene_mass_at(b) + (b->mass_is_state != 0);
    if (b->grows) size += b->motion == VM_PLANE ? 2 + 1 : 3 + 6; /* mass centre and inertia */
    return size;
}

/* Position of the coordinate on which an effect acts, relative to the coordinate on which the opposite force acts,
   or to the ground */
VM_INLINE vm_real vmi_effect_x(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->x] - y[e->other_x] : y[e->x];
}

/* Velocity of the coordinate on which an effect acts, relative to the coordinate on which the opposite force acts,
   or to the ground */
VM_INLINE vm_real vmi_effect_v(const vm_effect *e, const vm_real *y)
{
    return e->other_load ? y[e->v] - y[e->other_v] : y[e->v];
}

/* Adds the force f to the coordinate on which the effect acts. If it acts against another body, adds the opposite
   force -f to the coordinate of that body. */
VM_INLINE void vmi_effect_act(const vm_effect *e, vm_real f)
{
    e->load->force[e->coordinate] += f;
    if (e->other_load) e->other_load->force[e->other_coordinate] -= f;
}

#endif
