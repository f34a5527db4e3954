/* mechanics/jump_energy.h - the energy that a jump sets free or takes */
#ifndef VARMASS_MECHANICS_JUMP_ENERGY_H
#define VARMASS_MECHANICS_JUMP_ENERGY_H

#include "../base/real.h"
#include "bodies.h"
#include "relative.h"
#include "vectors.h"

/* Kinetic energy of the motions relative to the whole of n bodies and one more; the impulse's work on the whole */
VM_API vm_real vmi_relative_energy(const vm_body *whole, int n, const vm_body *bodies, const vm_body *one_more,
                                   const vm_impulse *external, vm_real *work)
{
    vm_real sum = 0;
    vm_body b;
    int i;
    if (!whole || !one_more || n < 0 || (n > 0 && !bodies)) return VM_NAN;
    for (i = 0; i <= n; i++) {
        b = i < n ? bodies[i] : *one_more;
        vm_to_relative(whole, &b, &b);
        sum += vm_kinetic_energy(&b);
    }
    *work = 0;
    if (external)
        *work = vmi_dot(whole->v, external->linear) + vmi_dot(whole->omega, vmi_impulse_moment(external, whole->r));
    return sum;
}

/* Kinetic energy that the n parts and the rest have more than the whole had, J, as the theorem (113), (118) has it:
   the sum of the kinetic energies of their motions relative to the whole, exact in space, and the impulse's work
   v_S.linear + Omega.moment about S. At high speed it has digits that the difference of the energies has lost. NaN
   for a null pointer and n < 0. */
VM_API vm_real vm_energy_gain(const vm_body *whole, int n, const vm_body *parts, const vm_impulse *external_or_NULL,
                              const vm_body *rest)
{
    vm_real work = 0, sum = vmi_relative_energy(whole, n, parts, rest, external_or_NULL, &work);
    return sum + work;
}

/* What body and the n added have more than the whole has, J: Carnot's loss, the kinetic energies of their motions
   relative to the whole, less the work of the impulse on it. */
VM_API vm_real vm_energy_loss(const vm_body *body, int n, const vm_body *added, const vm_impulse *external_or_NULL,
                              const vm_body *whole)
{
    vm_real work = 0, sum = vmi_relative_energy(whole, n, added, body, external_or_NULL, &work);
    return sum - work;
}

#endif
