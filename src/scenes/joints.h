/* scenes/joints.h - pins and rods between points of bodies

   A pin holds a point of a body at a point of another body or of the ground: in the plane it is a hinge, in space a
   ball joint. A rod keeps the distance of two points constant. Pins and rods are called joints. All joints of a scene
   are in one list, and the forces of all joints are computed together, by Lagrange's multipliers. Therefore chains,
   closed mechanisms and several joints on one body are possible. points.h explains how a point is given.

       vm_vec3 end = {-0.5, 0, 0}, pivot = {0, 0, 0};
       vm_joint list[] = {vm_joint_pin(0, end, VM_GROUND, pivot)};       // body 0 hangs at the pivot
       vm_real room[VM_JOINTS_WORK(1)];                                  // for one joint
       vm_joints joints = {list, 1, 10, room, VM_LENGTH(room)};          // deviations decrease as exp(-10 t)
       vm_effect effects[] = {vm_effect_gravity(0, 1, -9.81), vm_effect_joints(&joints)}; // joints stand last

   Let C be the deviation of a joint from its condition; for a pin C is the vector between the two points. The joint
   exerts the force with which C obeys the equation C'' + 2 rate C' + rate^2 C = 0, so that C decreases to 0; `rate` is
   a field of vm_joints. After a jump of a body, impulses of the joints take away the velocities with which the points
   of a joint would move apart; the budget includes these impulses. list[0].force is the reaction of the first joint on
   its body at the last evaluation.

   Accuracy: the errors of forces and accelerations are a few eps times the largest force or acceleration. This also
   holds for joints that nearly contradict each other, such as two rods almost in line, and for light bodies between
   heavy bodies, since the forces are refined until they fit the equations. An example is a point that two rods of 1 m
   hold near the line through their other ends. If the point is 1e-5 m beside this line, the relative errors of the
   forces of the rods are 4e-16; if it is 1e-7 m beside the line, they are 4e-11. These numbers are for deviations C
   that are computed as exactly 0. Otherwise the rounding of C, about eps times the length l of a rod, adds about rate^2
   eps l to the error of the acceleration C''. If the point is 2e-8 m beside the line, or closer, the run ends with
   VM_SINGULAR.

   Tests: tests/test_scene_joints.c. */
#ifndef VARMASS_SCENES_JOINTS_H
#define VARMASS_SCENES_JOINTS_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/linear.h"
#include "../base/real.h"
#include "../base/status.h"
#include "../mechanics/vectors.h"
#include "effects.h"
#include "motions.h"
#include "points.h"
#include "scene.h"

enum { VMI_JOINT_ROWS = 3 }; /* the largest number of equations that a joint has */

/* The number of elements that the array `work` of n joints must have */
#define VM_JOINTS_WORK(n) (3 * (n) * (3 * (n) + 3))

/* One equation of a joint. It prescribes the component of C'' along the unit vector `along`, where C is the deviation
   of the joint. Index 0 of an array belongs to the field `body` of the joint, index 1 to its field `other`. The joint
   pushes `body` with a force along `along`, and `other` with the opposite force. The fields turn, move and spin tell
   how each of the two bodies responds to a force of 1 N along `along`: `turn` is the torque on the body, `move` the
   acceleration of its mass centre, and `spin` its angular acceleration. */
typedef struct VM_TAG(vmi_joint_row) {
    vm_vec3 along;            /* unit vector, inertial axes */
    vm_vec3 turn[2];          /* m: torque per N */
    vm_vec3 move[2];          /* 1/kg */
    vm_vec3 spin[2];          /* 1/(kg m) */
    vm_real gap;              /* m: the deviation C; for a pin its component along `along` */
    vm_real gap_rate;         /* m/s: C'; for a pin its component along `along` */
    vm_real gap_acceleration; /* m/s^2: C'' without the forces of the joints; for a pin its component along `along` */
} vmi_joint_row;

/* An end of a joint: its point, and the acceleration of this point without the joints */
typedef struct VM_TAG(vmi_joint_end) {
    vmi_body_point point;
    vm_vec3 a; /* m/s^2 */
} vmi_joint_end;

typedef struct VM_TAG(vm_joint) vm_joint;

/* A joint. vm_joint_pin or vm_joint_rod makes it; the caller changes no field. */
struct VM_TAG(vm_joint) {
    /* fields set by the constructor */
    void (*equations)(vm_joint *joint, const vm_scene *scene, const vmi_joint_end *ends); /* writes the equations */
    int body, other;      /* indices of the bodies; `other` may be VM_GROUND */
    vm_vec3 at, other_at; /* m: the points of `body` and `other`, in the axes of these bodies */
    vm_real length;       /* m: length of a rod */
    /* field that the caller may read; each evaluation in which the joints act sets it, to 0 while a body of the joint
       is not present */
    vm_vec3 force; /* N, inertial axes: reaction on `body`; the reaction on `other` is opposite */
    /* fields of the last evaluation */
    int n_rows; /* number of equations */
    vmi_joint_row row[VMI_JOINT_ROWS];
};

/* The list of all joints of a scene */
typedef struct VM_TAG(vm_joints) {
    vm_joint *joints; /* array of n_joints joints */
    int n_joints;
    vm_real rate;  /* 1/s: deviations of the joints from their conditions decrease as exp(-rate t); > 0 */
    vm_real *work; /* array of VM_JOINTS_WORK(n_joints) numbers */
    int work_size; /* number of elements of work, which vm_scene_start checks; 0 means no check */
} vm_joints;

/* Computes an end of a joint, and the acceleration that its point would have without the joints:
     a + alpha x arm + omega x (omega x arm - drift).
   Here a is the acceleration of the mass centre, alpha and omega are angular acceleration and angular velocity of the
   body, and `arm` leads from the mass centre to the point. drift is 0 except for a growing body: it is the velocity
   with which the mass centre moves through the material of the body. drift is subtracted because a is the rate of the
   velocity of the material at the mass centre, and at each instant there is other material at this place. For a growing
   body of which a stream has a store this is not exact (see vmi_point_of_body). */
VM_API void vmi_joint_end_now(const vm_scene *s, int body, vm_vec3 at, const vm_real *y, vmi_joint_end *end)
{
    const vmi_body_point *p = &end->point;
    const vm_scene_body *b;
    vm_vec3 alpha, moving;
    vmi_point_now(s, body, at, y, &end->point);
    end->a = vmi_vec3(0, 0, 0);
    if (body < 0) return;
    b = s->bodies + body;
    alpha = vmi_point_spin(b, &p->axes, vmi_scene_turning(b, b->load.force), p->omega);
    moving = vm_cross(p->omega, p->arm);
    if (b->grows) moving = vm_sub(moving, b->load.drift);
    end->a = vmi_point_move(b, vmi_scene_moving(b, b->load.force));
    end->a = vm_add(end->a, vm_add(vm_cross(alpha, p->arm), vm_cross(p->omega, moving)));
}

/* Begins a further equation of a joint: computes how each of its bodies responds to a force of 1 N along the unit
   vector `along` */
VM_API vmi_joint_row *vmi_joint_add_row(vm_joint *joint, const vm_scene *s, const vmi_joint_end *ends, vm_vec3 along)
{
    const vm_vec3 zero = {0, 0, 0};
    const int bodies[2] = {joint->body, joint->other};
    vmi_joint_row *row = joint->row + joint->n_rows++;
    int i;
    row->along = along;
    for (i = 0; i < 2; i++) {
        const vmi_body_point *p = &ends[i].point;
        row->turn[i] = row->move[i] = row->spin[i] = zero;
        if (bodies[i] < 0) continue;
        row->turn[i] = vm_cross(p->arm, along);
        row->move[i] = vmi_point_move(s->bodies + bodies[i], along);
        row->spin[i] = vmi_point_spin(s->bodies + bodies[i], &p->axes, row->turn[i], zero);
    }
    return row;
}

/* -- The kinds of joints -- */

/* Returns 1 if a body can move out of the plane of x and y, else 0 */
VM_API int vmi_joint_is_in_space(const vm_scene *s, int body)
{
    return body >= 0 && (s->bodies[body].motion == VM_POINT || s->bodies[body].motion == VM_FREE);
}

/* Writes the equations of a pin: three, along x, y and z, if one of its bodies is a point or free in space; else two,
   along x and y. The deviation C is the vector between the points. */
VM_API void vmi_pin_equations(vm_joint *joint, const vm_scene *s, const vmi_joint_end *ends)
{
    const int in_space = vmi_joint_is_in_space(s, joint->body) || vmi_joint_is_in_space(s, joint->other);
    const vm_vec3 C = vm_sub(ends[0].point.r, ends[1].point.r), v = vm_sub(ends[0].point.v, ends[1].point.v);
    const vm_vec3 a = vm_sub(ends[0].a, ends[1].a);
    const int n = in_space ? 3 : 2;
    int i;
    for (i = 0; i < n; i++) {
        const vm_vec3 along = vmi_vec3((vm_real)(i == 0), (vm_real)(i == 1), (vm_real)(i == 2));
        vmi_joint_row *row = vmi_joint_add_row(joint, s, ends, along);
        row->gap = vm_dot(along, C);
        row->gap_rate = vm_dot(along, v);
        row->gap_acceleration = vm_dot(along, a);
    }
}

/* Writes the equation of a rod. Its deviation is C = (d^2 - length^2)/(2 |d|), where d is the vector between its
   points. Since the rod keeps |d| nearly constant, C' = d v/|d| and C'' = (d a + v^2)/|d|, as for a link; v and a are
   the rates d' and d''. */
VM_API void vmi_rod_equations(vm_joint *joint, const vm_scene *s, const vmi_joint_end *ends)
{
    const vm_vec3 d = vm_sub(ends[0].point.r, ends[1].point.r), v = vm_sub(ends[0].point.v, ends[1].point.v);
    const vm_real l = vm_norm(d);
    vmi_joint_row *row = vmi_joint_add_row(joint, s, ends, vmi_over(d, l));
    row->gap = (l - joint->length) * (l + joint->length) / (2 * l);
    row->gap_rate = vm_dot(row->along, v);
    row->gap_acceleration = vm_dot(row->along, vm_sub(ends[0].a, ends[1].a)) + vm_dot(v, v) / l;
}

/* A pin between the point `at` of a body and the point other_at of the body `other`, or of the ground. In the plane it
   is a hinge, in space a ball joint. */
VM_API vm_joint vm_joint_pin(int body, vm_vec3 at, int other, vm_vec3 other_at)
{
    vm_joint joint;
    memset(&joint, 0, sizeof joint);
    joint.equations = vmi_pin_equations;
    joint.body = body;
    joint.other = other;
    joint.at = at;
    joint.other_at = other_at;
    joint.length = 1; /* any positive number */
    return joint;
}

/* A rigid rod without mass between the point `at` of a body and the point other_at of the body `other`, or of the
   ground. The rod keeps the distance of the points equal to `length` (m), by a force along the line between them. */
VM_API vm_joint vm_joint_rod(int body, vm_vec3 at, int other, vm_vec3 other_at, vm_real length)
{
    vm_joint joint = vm_joint_pin(body, at, other, other_at);
    joint.equations = vmi_rod_equations;
    joint.length = length;
    return joint;
}

/* -- The solution -- */

/* Returns the acceleration C'' that a force of 1 N of the equation `by` of joint j causes in the equation `row` of
   joint i */
VM_API vm_real vmi_joint_coupling(const vm_joint *i, const vmi_joint_row *row, const vm_joint *j,
                                  const vmi_joint_row *by)
{
    const int bodies[2] = {i->body, i->other}, others[2] = {j->body, j->other};
    vm_real sum = 0;
    int k, m;
    for (k = 0; k < 2; k++)
        for (m = 0; m < 2; m++) {
            vm_real part;
            if (bodies[k] < 0 || bodies[k] != others[m]) continue;
            part = vm_dot(row->along, by->move[m]) + vm_dot(row->turn[k], by->spin[m]);
            sum += k == m ? part : -part;
        }
    return sum;
}

/* Writes the equations of all joints whose bodies are present, and returns their number */
VM_API int vmi_joints_equations(const vm_joints *joints, const vm_scene *s, const vm_real *y)
{
    int i, n = 0;
    for (i = 0; i < joints->n_joints; i++) {
        vm_joint *joint = joints->joints + i;
        vmi_joint_end ends[2];
        joint->n_rows = 0;
        joint->force = vmi_vec3(0, 0, 0);
        if (s->bodies[joint->body].away || (joint->other >= 0 && s->bodies[joint->other].away)) continue;
        vmi_joint_end_now(s, joint->body, joint->at, y, ends);
        vmi_joint_end_now(s, joint->other, joint->other_at, y, ends + 1);
        joint->equations(joint, s, ends);
        n += joint->n_rows;
    }
    return n;
}

/* Writes to the array a one row of the matrix of the linear equations for the forces: the row of the equation `row` of
   `joint`. Each number of the row belongs to one equation of the joints. It is the acceleration C'' that a force of 1
   N of this equation causes in the equation `row` */
VM_API void vmi_joints_matrix_row(const vm_joints *joints, const vm_joint *joint, const vmi_joint_row *row, vm_real *a)
{
    int j, m, at = 0;
    for (j = 0; j < joints->n_joints; j++) {
        const vm_joint *other = joints->joints + j;
        for (m = 0; m < other->n_rows; m++) a[at++] = vmi_joint_coupling(joint, row, other, other->row + m);
    }
}

/* Tells what the function vmi_joints_solve computes from the equations: forces or impulses. Forces must change C'' so
   that C'' + 2 rate C' + rate^2 C = 0, and impulses must change C' so that C' = 0. */
enum { VMI_JOINT_FORCES, VMI_JOINT_IMPULSES };

VM_API vm_real vmi_joint_lacks(const vmi_joint_row *row, vm_real rate, int wanted)
{
    if (wanted == VMI_JOINT_IMPULSES) return -row->gap_rate;
    return -(row->gap_acceleration + 2 * rate * row->gap_rate + rate * rate * row->gap);
}

/* Computes the acceleration *move of the mass centre and the angular acceleration *spin that the forces of all
   equations give a body */
VM_API void vmi_joints_accelerate(const vm_joints *joints, const vm_real *forces, int body, vm_vec3 *move,
                                  vm_vec3 *spin)
{
    int i, k, m;
    *move = *spin = vmi_vec3(0, 0, 0);
    for (i = 0; i < joints->n_joints; i++) {
        const vm_joint *joint = joints->joints + i;
        const int bodies[2] = {joint->body, joint->other};
        for (m = 0; m < joint->n_rows; m++, forces++)
            for (k = 0; k < 2; k++) {
                const vm_real force = k == 0 ? *forces : -*forces;
                if (bodies[k] != body) continue;
                *move = vm_add(*move, vm_scale(force, joint->row[m].move[k]));
                *spin = vm_add(*spin, vm_scale(force, joint->row[m].spin[k]));
            }
    }
}

/* Writes the remainder of each equation to `rest`: the change of C'' or C' that is needed (vmi_joint_lacks), minus the
   change that the computed forces cause. The second change is computed from the accelerations of the bodies, and not
   by the matrix of the equations: if large forces nearly cancel, the accelerations still have digits that the numbers
   of this matrix have lost. */
VM_API void vmi_joints_rest(const vm_joints *joints, const vm_real *forces, int wanted, vm_real *rest)
{
    int i, k, m;
    for (i = 0; i < joints->n_joints; i++) {
        const vm_joint *joint = joints->joints + i;
        const int bodies[2] = {joint->body, joint->other};
        vm_vec3 move[2], spin[2];
        for (k = 0; k < 2 && joint->n_rows; k++) {
            move[k] = spin[k] = vmi_vec3(0, 0, 0);
            if (bodies[k] >= 0) vmi_joints_accelerate(joints, forces, bodies[k], move + k, spin + k);
        }
        for (m = 0; m < joint->n_rows; m++) {
            const vmi_joint_row *row = joint->row + m;
            const vm_real first = vm_dot(row->along, move[0]) + vm_dot(row->turn[0], spin[0]);
            const vm_real second = vm_dot(row->along, move[1]) + vm_dot(row->turn[1], spin[1]);
            *rest++ = vmi_joint_lacks(row, joints->rate, wanted) - (first - second);
        }
    }
}

/* Refines the forces once: solves the equations for their remainders, with the decomposed matrix that joints->work
   contains, and adds the solution to the forces. Returns 1 if this changed a force by more than sqrt(VM_EPSILON) times
   the largest force, so that a further refinement is worth its time, else 0. */
VM_API int vmi_joints_refine(const vm_joints *joints, int n, int wanted)
{
    const vm_real *a = joints->work;
    vm_real *forces = joints->work + n * n, *scale = forces + n, *rest = scale + n, largest = 0, change = 0;
    int i;
    vmi_joints_rest(joints, forces, wanted, rest);
    vmi_solve_decomposed(n, a, scale, rest);
    for (i = 0; i < n; i++) {
        forces[i] += rest[i];
        largest = vmi_larger(VM_FABS(forces[i]), largest);
        change = vmi_larger(VM_FABS(rest[i]), change);
    }
    return change > VM_SQRT(VM_EPSILON) * largest;
}

/* Solves the n equations for the forces, or for the impulses, and writes the results to joints->work from index n^2
   on. The numbers of the matrix are products of the coefficients of the equations. Therefore a solution by the matrix
   loses twice as many digits as the equations themselves if joints nearly contradict each other; vmi_joints_refine
   restores these digits. Returns VM_SINGULAR if the equations have no unique solution, VM_NOT_FINITE if a number is
   not finite, and else VM_OK. */
VM_API int vmi_joints_solve(const vm_joints *joints, int n, int wanted)
{
    enum { MOST_REFINEMENTS = 4 };
    vm_real *a = joints->work, *forces = a + n * n, *scale = forces + n;
    int i, k, status, at = 0;
    for (i = 0; i < joints->n_joints; i++) {
        const vm_joint *joint = joints->joints + i;
        for (k = 0; k < joint->n_rows; k++) {
            vmi_joints_matrix_row(joints, joint, joint->row + k, a + at * n);
            forces[at++] = vmi_joint_lacks(joint->row + k, joints->rate, wanted);
        }
    }
    if (!vmi_all_finite(n * n + n, a)) return VM_NOT_FINITE;
    status = vmi_decompose_mass(n, a, scale);
    if (status) return status;
    vmi_solve_decomposed(n, a, scale, forces);
    for (i = 0; i < MOST_REFINEMENTS; i++)
        if (!vmi_joints_refine(joints, n, wanted)) break;
    return VM_OK;
}

/* The force of a joint on the body with the index joint->body: the vector sum of the forces of the equations of the
   joint */
VM_API vm_vec3 vmi_joint_force(const vm_joint *joint, const vm_real *forces)
{
    vm_vec3 sum = {0, 0, 0};
    int k;
    for (k = 0; k < joint->n_rows; k++) sum = vm_add(sum, vm_scale(forces[k], joint->row[k].along));
    return sum;
}

/* Adds the force of a joint to the loads of its bodies */
VM_API void vmi_joint_push(const vm_joint *joint, const vm_real *y, vm_scene *s)
{
    vmi_body_point p;
    vmi_point_now(s, joint->body, joint->at, y, &p);
    vmi_point_push(s->bodies + joint->body, &p, joint->force);
    if (joint->other < 0) return;
    vmi_point_now(s, joint->other, joint->other_at, y, &p);
    vmi_point_push(s->bodies + joint->other, &p, vm_scale(-1, joint->force));
}

VM_API void vmi_apply_joints(const vm_effect *e, vm_real t, const vm_real *y, vm_scene *s)
{
    const vm_joints *joints = (const vm_joints *)e->parts;
    const int n = vmi_joints_equations(joints, s, y), status = vmi_joints_solve(joints, n, VMI_JOINT_FORCES);
    const vm_real *forces = joints->work + n * n;
    int i;
    (void)t;
    if (status) s->status = status;
    if (status) return;
    for (i = 0; i < joints->n_joints; i++) {
        vm_joint *joint = joints->joints + i;
        if (joint->n_rows == 0) continue;
        joint->force = vmi_joint_force(joint, forces);
        vmi_joint_push(joint, y, s);
        forces += joint->n_rows;
    }
}

/* Gives a body an impulse at its point `at`; an impulse on the ground changes nothing. Returns a status of
   vmi_point_kick. */
VM_API int vmi_joint_kick(const vm_scene *s, int body, vm_vec3 at, vm_vec3 impulse, vm_real *y)
{
    vmi_body_point p;
    if (body < 0) return VM_OK;
    vmi_point_now(s, body, at, y, &p);
    return vmi_point_kick(s->bodies + body, &p, impulse, y);
}

/* After a jump, gives the bodies the impulses after which the points of each joint do not move apart, and adds the
   impulses that come from the ground to the budget. The equations are those of the last evaluation of the loads. */
VM_API int vmi_joints_settle(const vm_effect *e, vm_real *y, vm_scene *s)
{
    const vm_joints *joints = (const vm_joints *)e->parts;
    const vm_real *impulses;
    int i, n = 0, status;
    for (i = 0; i < joints->n_joints; i++) n += joints->joints[i].n_rows;
    impulses = joints->work + n * n;
    status = vmi_joints_solve(joints, n, VMI_JOINT_IMPULSES);
    if (status) return status;
    for (i = 0; i < joints->n_joints; i++) {
        const vm_joint *joint = joints->joints + i;
        const vm_vec3 impulse = vmi_joint_force(joint, impulses);
        impulses += joint->n_rows;
        if (joint->n_rows == 0) continue;
        status = vmi_first_error(status, vmi_joint_kick(s, joint->body, joint->at, impulse, y));
        status = vmi_first_error(status, vmi_joint_kick(s, joint->other, joint->other_at, vm_scale(-1, impulse), y));
        if (joint->other >= 0 || !s->budget) continue;
        s->budget->impulse = vm_add(s->budget->impulse, impulse);
        s->budget->angular_impulse = vm_add(s->budget->angular_impulse, vm_cross(joint->other_at, impulse));
    }
    return status;
}

/* -- Checks -- */

/* Computes an end of a joint at the start of the scene, when the accelerations are not yet known. Adds to *size the
   magnitudes of the position of the point and of its distance from the mass centre. Adds to *speed the magnitude of
   the velocity of the point, and that of the part which comes from the rotation of the body. vmi_joint_fits compares
   deviations with *size and *speed. */
VM_API void vmi_joint_end_at_start(const vm_scene *s, int body, vm_vec3 at, vmi_joint_end *end, vm_real *size,
                                   vm_real *speed)
{
    /* number of state variables of a free growing body: its motion, mass, mass centre and inertia */
    enum { MOST = 13 + 1 + 3 + 6 };
    vm_real state[MOST] = {0};
    vmi_body_point *p = &end->point;
    end->a = vmi_vec3(0, 0, 0);
    if (body >= 0) {
        vm_scene_body now = s->bodies[body];
        now.centre = vmi_vec3(0, 0, 0);
        now.put(&now, &now.start, now.angle, state);
        vmi_point_of_body(&now, at, state, p);
    } else vmi_point_now(s, body, at, NULL, p);
    *size += vmi_norm1(p->r) + vmi_norm1(p->arm);
    *speed += vmi_norm1(p->v) + vmi_norm1(p->omega) * vmi_norm1(p->arm);
}

/* Returns 1 if the bodies fit a joint at the start, else 0. They fit if the deviation is at most the fraction `loose`
   of `size`, a sum of lengths, and if the rate of the deviation is at most the same fraction of `speed`, a sum of
   velocities. */
VM_API int vmi_joint_fits(vm_joint *joint, const vm_scene *s)
{
    const vm_real loose = VM_C(1e-6) + 512 * VM_EPSILON;
    vm_real size = 0, speed = 0;
    vmi_joint_end ends[2];
    int k;
    vmi_joint_end_at_start(s, joint->body, joint->at, ends, &size, &speed);
    vmi_joint_end_at_start(s, joint->other, joint->other_at, ends + 1, &size, &speed);
    joint->n_rows = 0;
    joint->equations(joint, s, ends);
    for (k = 0; k < joint->n_rows; k++) {
        const vmi_joint_row *row = joint->row + k;
        if (!(VM_FABS(row->gap) <= loose * size && VM_FABS(row->gap_rate) <= loose * speed)) return 0;
    }
    return 1;
}

VM_API int vmi_joint_check(vm_joint *joint, const vm_scene *s)
{
    int status = vmi_first_error(vmi_point_check(s, joint->body, joint->at),
                                 vmi_point_check(s, joint->other, joint->other_at));
    if (joint->body < 0) status = vmi_first_error(status, VM_NO_SUCH_BODY);
    if (!VM_IS_FINITE(joint->length)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (joint->length <= 0) status = vmi_first_error(status, VM_DOMAIN);
    if (joint->body == joint->other) status = vmi_first_error(status, VM_SAME_BODY);
    if (!joint->equations) status = VM_BAD_ARGUMENT;
    if (status) return status;
    if (s->bodies[joint->body].absent || (joint->other >= 0 && s->bodies[joint->other].absent)) return VM_OK;
    return vmi_joint_fits(joint, s) ? VM_OK : VM_NOT_JOINED;
}

/* With `enter` = 1, marks each body of the joints as a body with a link, so that no other effect on it may follow.
   With `enter` = 0, returns VM_TWO_LINKS if a body already has a link or joints of another list, else VM_OK. */
VM_API int vmi_joints_enter_links(const vm_joints *joints, const vm_scene *s, int enter)
{
    const int link = 1 << VMI_ORDER_LINK;
    int i, k;
    for (i = 0; i < joints->n_joints; i++) {
        const int bodies[2] = {joints->joints[i].body, joints->joints[i].other};
        for (k = 0; k < 2; k++) {
            if (bodies[k] < 0) continue;
            if (enter) s->bodies[bodies[k]].listed_orders |= link;
            else if (s->bodies[bodies[k]].listed_orders & link) return VM_TWO_LINKS;
        }
    }
    return VM_OK;
}

VM_API int vmi_joints_check(const vm_scene *s, const vm_effect *e)
{
    const vm_joints *joints = (const vm_joints *)e->parts;
    int i, status = VM_OK;
    if (!joints->work) return VM_BAD_ARGUMENT;
    if (s->bodies[e->body].absent) return VM_IS_AWAY;
    for (i = 0; i < joints->n_joints; i++) status = vmi_first_error(status, vmi_joint_check(joints->joints + i, s));
    if (!VM_IS_FINITE(joints->rate)) status = vmi_first_error(status, VM_NOT_FINITE);
    if (joints->rate <= 0) status = vmi_first_error(status, VM_DOMAIN);
    if (joints->work_size && joints->work_size < VM_JOINTS_WORK(joints->n_joints))
        status = vmi_first_error(status, VM_SHORT_ARRAY);
    if (!status) status = vmi_joints_enter_links(joints, s, 0);
    if (!status) status = vmi_joints_enter_links(joints, s, 1);
    return status;
}

/* The joints of a scene, solved together. *joints and its arrays are not copied and must stay at their places in
   memory. The effect must stand after all other effects on the bodies of the joints. A pin has 2 equations in the
   plane and 3 in space, a rod has 1. To solve n equations, an evaluation makes about n^3/3 multiplications; to refine
   the solution, it makes about 10 n^2 more. A high rate makes the equations of motion stiff, so that the steps become
   short. vm_scene_start returns VM_BAD_ARGUMENT if a pointer is NULL or the list is empty; VM_NOT_FINITE if a number
   is infinite or NaN; VM_DOMAIN if rate or the length of a rod is not positive; VM_SHORT_ARRAY if work is too small;
   VM_NO_SUCH_BODY if a body does not exist; VM_IS_AWAY if the body of the first joint is absent at the start;
   VM_SAME_BODY if a joint connects a body with itself; VM_BAD_POINT if a body cannot have the point of its joint
   (points.h); VM_NOT_JOINED if the points of a joint do not fit at the start or move apart; VM_TWO_LINKS if a body
   also has a link or joints of another list; and VM_LINK_NOT_LAST if another effect on one of the bodies follows the
   joints. A run ends with VM_SINGULAR if joints are redundant or contradict each other, if they hold a point that
   cannot move, or if a mechanism reaches a position in which it is locked. It ends with VM_NOT_FINITE if the points of
   a rod coincide. A joint does not act while one of its bodies is not present. */
VM_API vm_effect vm_effect_joints(const vm_joints *joints)
{
    const int is_list = joints && joints->joints && joints->n_joints > 0;
    const int body = is_list ? joints->joints[0].body : 0;
    vm_effect e = vmi_effect(body, 0, is_list ? vmi_apply_joints : NULL);
    e.order = VMI_ORDER_JOINTS;
    e.parts = joints;
    e.check_in_scene = vmi_joints_check;
    e.settle = vmi_joints_settle;
    return e;
}

#endif
