/* mechanics/jump_energy.h - the kinetic energy that bodies gain or lose in a jump
   Kinetic energy is not conserved when bodies separate or join. Without an impulse, a separation adds the kinetic
   energy that the bodies have relative to the whole, and an attachment takes this energy away. This is Carnot's
   theorem, equations (113) and (118) of the dissertation [1].

       vm_body rest; // whole and part are known vm_bodies
       vm_real gain = VM_NAN;
       if (vm_separate(&whole, &part, NULL, &rest) == VM_OK) gain = vm_energy_gain(&whole, 1, &part, NULL, &rest);

   Tests: tests/test_jumps.c, tests/test_jump_equations.c. */
#ifndef VARMASS_MECHANICS_JUMP_ENERGY_H
#define VARMASS_MECHANICS_JUMP_ENERGY_H

#include "../base/real.h"
#include "bodies.h"
#include "relative.h"
#include "vectors.h"

/* The sum of the kinetic energies that the n `bodies` and `one_more` have in their motions relative to `whole`. Returns
   NaN for a null pointer or n < 0. */
VM_API vm_real vmi_relative_energy(const vm_body *whole, int n, const vm_body *bodies, const vm_body *one_more)
{
    vm_real sum = 0;
    vm_body b;
    int i;
    if (!whole || !one_more || n < 0 || (n > 0 && !bodies)) return VM_NAN;
    for (i = 0; i < n; i++) {
        b = vmi_relative_motion(whole, bodies[i]);
        sum += vm_kinetic_energy(&b);
    }
    b = vmi_relative_motion(whole, *one_more);
    return sum + vm_kinetic_energy(&b);
}

/* Work of an impulse on a body, J. It is v.linear + omega.moment. v and omega are the velocity and angular velocity of
   the body; `moment` is the moment of the impulse about the body's mass centre. Returns 0 for a null pointer. */
VM_API vm_real vmi_impulse_work(const vm_body *body_or_NULL, const vm_impulse *external_or_NULL)
{
    const vm_body *b = body_or_NULL;
    const vm_impulse *j = external_or_NULL;
    if (!b || !j) return 0;
    return vm_dot(b->v, j->linear) + vm_dot(b->omega, vmi_impulse_moment(j, b->r));
}

/* Energy gained at a separation, J: the kinetic energy of the n parts and of the rest, minus that of the whole (113),
   (118). It is computed as the kinetic energy of parts and rest relative to the whole, plus the work of the external
   impulse on the whole (0 without an impulse). Without rounding errors this sum equals the difference of the energies.
   The difference itself would lose digits at high speed. `whole` is the body before the separation; `parts` and `rest`
   are the bodies after it; they are not checked. After VM_NULL_AXIS the true difference is smaller by omega.h, where
   omega is the angular velocity of the whole and h the angular momentum that was lost. Returns NaN for a null pointer
   or n < 0. */
VM_API vm_real vm_energy_gain(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                              const vm_body *rest)
{
    return vmi_relative_energy(whole, n, parts, rest) + vmi_impulse_work(whole, external_or_NULL);
}

/* Energy lost at an attachment, J: the kinetic energy of `body` and of the n bodies `added` minus that of the whole
   (Carnot's loss). It is computed as the kinetic energy of these bodies relative to the whole, minus the work of the
   impulse on the whole. `body` and `added` are the bodies before the attachment; `whole` is the body after it; they are
   not checked. After VM_NULL_AXIS the result does not contain the energy of the angular momentum that was lost. Returns
   NaN for a null pointer or n < 0. */
VM_API vm_real vm_energy_loss(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                              const vm_body *whole)
{
    return vmi_relative_energy(whole, n, added, body) - vmi_impulse_work(whole, external_or_NULL);
}

#endif
