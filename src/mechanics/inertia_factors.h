/* mechanics/inertia_factors.h - inertia tensors as products of factors, and stored in state arrays
   A body with streams needs the inverse of its inertia in every evaluation of its equations of motion. If the tensor is
   written as a product L D L^T (vmi_inertia_ldl explains L and D), a few multiplications give the angular velocity that
   belongs to an angular momentum. In a state array the tensor is stored as six numbers; this chapter has functions that
   read and write them. vmi_inertia_factor_if_possible returns 0 for a tensor that no body can have.

       vm_inertia disc = {1, 1, 2, 0, 0, 0};
       vmi_inertia_ldl f;
       int possible = vmi_inertia_factor_if_possible(&disc, &f); // 1; vmi_inertia_solve(&f, h) then gives omega

   Tests: tests/test_flow.c, tests/test_streams.c, tests/test_scene_mass.c. */
#ifndef VARMASS_MECHANICS_INERTIA_FACTORS_H
#define VARMASS_MECHANICS_INERTIA_FACTORS_H

#include "../base/real.h"
#include "inertia.h"
#include "vectors.h"

/* Reads an inertia tensor from six numbers of a state array. vmi_set_inertia writes a tensor to a state array. */
VM_API vm_inertia vmi_get_inertia(const vm_real *y)
{
    vm_inertia i;
    i.xx = y[0];
    i.yy = y[1];
    i.zz = y[2];
    i.xy = y[3];
    i.xz = y[4];
    i.yz = y[5];
    return i;
}

VM_API void vmi_set_inertia(vm_real *y, const vm_inertia *i)
{
    y[0] = i->xx;
    y[1] = i->yy;
    y[2] = i->zz;
    y[3] = i->xy;
    y[4] = i->xz;
    y[5] = i->yz;
}

/* The factors L and D of an inertia tensor that is written as the product L D L^T. L is a lower triangular matrix with
   ones on the diagonal; xy, xz, yz are its other entries. D is a diagonal matrix; x, y, z are the diagonal entries of
   its inverse. */
typedef struct VM_TAG(vmi_inertia_ldl) {
    vm_real xy, xz, yz, x, y, z;
} vmi_inertia_ldl;

/* Writes the inertia tensor *i as the product L D L^T, and stores L and the inverse of D in *f (vmi_inertia_ldl).
   Returns 0 if a diagonal entry of D is not positive or not larger than its rounding error, else 1. */
VM_INLINE int vmi_inertia_factor(const vm_inertia *i, vmi_inertia_ldl *f)
{
    vm_real y, z, t;
    f->x = 1 / i->xx;
    f->xy = i->xy * f->x;
    f->xz = i->xz * f->x;
    y = i->yy - f->xy * i->xy;
    t = i->yz - f->xz * i->xy;
    f->y = 1 / y;
    f->yz = t * f->y;
    z = i->zz - f->xz * i->xz - f->yz * t;
    f->z = 1 / z;
    return i->xx > 0 && y > VMI_LOST_SHARE * i->yy && z > VMI_LOST_SHARE * i->zz;
}

/* The angular velocity w for the angular momentum h: the solution of the equation i w = h for the inertia tensor i. *f
   is the result of vmi_inertia_factor for i. */
VM_INLINE vm_vec3 vmi_inertia_solve(const vmi_inertia_ldl *f, vm_vec3 h)
{
    vm_vec3 w;
    w.y = h.y - f->xy * h.x;
    w.z = (h.z - f->xz * h.x - f->yz * w.y) * f->z;
    w.y = w.y * f->y - f->yz * w.z;
    w.x = h.x * f->x - f->xy * w.y - f->xz * w.z;
    return w;
}

/* Returns 1 if a body, which may be thin, can have the inertia i within a tolerance. One moment of a flat body equals
   the sum of the other two, but the rounding errors of all steps of an integration add up and disturb this equality.
   The tolerance is sqrt(eps) times the trace of i, which is enough for about 1/sqrt(eps) steps. */
VMI_APART int vmi_thin_inertia_is_possible(const vm_inertia *i)
{
    const vm_real slack = VM_MANT_DIG > 24 ? VM_C(1.5e-8) : VM_C(3.5e-4); /* the tolerance divided by the trace */
    return vmi_inertia_is_finite(i) && vmi_inertia_is_within(i, slack * (i->xx + i->yy + i->zz));
}

/* Returns 1 if a body can have the inertia i, which must have positive principal moments. Every step of an integration
   calls this test, so a cheap condition comes first: tr(i)/2 E - i (trace tr, unit matrix E) is positive definite if
   each diagonal entry of this matrix exceeds |xy| + |xz| + |yz|. Most bodies satisfy this condition. */
VM_INLINE int vmi_running_inertia_is_possible(const vm_inertia *i)
{
    const vm_real half = (i->xx + i->yy + i->zz) / 2;
    const vm_real least = half - (VM_FABS(i->xy) + VM_FABS(i->xz) + VM_FABS(i->yz));
    return (least > i->xx && least > i->yy && least > i->zz) || vmi_thin_inertia_is_possible(i);
}

/* Computes the factors *f of the inertia *i as vmi_inertia_factor does. Returns 0 also if no body can have the inertia
   *i. */
VM_INLINE int vmi_inertia_factor_if_possible(const vm_inertia *i, vmi_inertia_ldl *f)
{
    return vmi_inertia_factor(i, f) && vmi_running_inertia_is_possible(i);
}

#endif
