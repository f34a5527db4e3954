/* mechanics/broken_rotor_stability.h - steady motion of the broken rotor, its stability, growth at resonance

   After the break the remainder can turn steadily at the angular velocity psi' = Omega, with its mass centre on a
   circle, as in the equations (76), (77) of the dissertation [1]. This chapter computes
     - the radius of this circle,
     - the characteristic polynomial (81) of small deviations from the steady motion, its roots, and the first column of
       Routh's scheme,
     - the stability (82): the steady motion is stable only below resonance, where |Omega| < omega,
     - the radius of the growing orbit of a rotor that starts from rest, if its torque drives it at or above resonance.
   In the formulas, omega^2 = stiffness/mass, p^2 = mass/inertia, k* = damping/inertia, and s is the field s of the
   rotor. At resonance |Omega| = omega.

       vm_broken_rotor rest = {2, 1, 20, 1, 3, VM_C(0.1)};       // 0.1 m from the shaft to the mass centre
       vm_real radius = vm_broken_rotor_steady_radius(&rest, 2); // m, at 2 rad/s
       int stable = vm_broken_rotor_is_stable(&rest, 2);

   Tests: tests/test_broken_rotor_stability.c. */
#ifndef VARMASS_MECHANICS_BROKEN_ROTOR_STABILITY_H
#define VARMASS_MECHANICS_BROKEN_ROTOR_STABILITY_H

#include <string.h>

#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/polynomial.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "../base/sums.h"
#include "../base/words.h"
#include "broken_rotor.h"

/* The detuning from resonance, (omega^2 - Omega^2) mass, where omega^2 = stiffness/mass. The function computes it in
   three words (as a sum of three vm_reals), because close to resonance the two terms cancel. */
VM_API vm_real vmi_broken_rotor_detuning(const vm_broken_rotor *r, vm_real Omega)
{
    const vm_two momentum = vmi_two_product(r->mass, Omega);
    const vmi_three load =
        vmi_three_times(vmi_three_words(momentum.hi, momentum.lo, 0), vmi_three_words(-Omega, 0, 0));
    const vmi_three left = vmi_three_plus(vmi_three_words(r->stiffness, 0, 0), load);
    return left.hi + (left.mid + left.lo);
}

/* Radius of the mass centre's circle in steady motion at psi' = Omega, m: s omega^2/(omega^2 - Omega^2), (76), (77).
   Omega is in rad/s. The motion is steady only if torque = damping Omega (47). For Omega^2 < omega^2 the radius is
   positive and the direction of the mass centre is phi = psi + pi, as in (77). For Omega^2 > omega^2 the radius is
   negative and phi = psi, as in (76). The relative error is within 3 eps, even very close to resonance. Returns
   infinity at resonance (NaN for s = 0 or stiffness = 0), and NaN for a null pointer or for a rotor with a value that
   vm_broken_rotor does not allow. */
VM_API vm_real vm_broken_rotor_steady_radius(const vm_broken_rotor *rotor, vm_real Omega)
{
    const vm_real smaller = vmi_ldexp(1, -64); /* with it the splitting of a mass into words does not overflow */
    vm_broken_rotor r;
    vm_real detuning, share;
    if (!rotor || vmi_check_broken_rotor(rotor) || !VM_IS_FINITE(Omega)) return VM_NAN;
    r = *rotor;
    detuning = vmi_broken_rotor_detuning(&r, Omega);
    if (!VM_IS_FINITE(detuning)) {
        r.mass *= smaller;
        r.stiffness *= smaller;
        detuning = vmi_broken_rotor_detuning(&r, Omega);
    }
    if (VM_IS_FINITE(detuning)) return r.s * (r.stiffness / detuning);
    share = rotor->stiffness / (rotor->mass * Omega) / Omega; /* omega^2/Omega^2; mass Omega^2 has overflowed */
    return -rotor->s * (share / (1 - share));
}

/* The quantities w2 = omega^2, O2 = Omega^2, k = k*, D and G in the polynomial of vm_broken_rotor_characteristic. The
   comment of that function explains D and G. */
typedef struct VM_TAG(vmi_broken_rotor_steady) {
    vm_real w2, O2, k, D, G;
} vmi_broken_rotor_steady;

/* Sets the fields of *a for the steady motion at the angular velocity psi' = Omega. Returns VM_BAD_ARGUMENT for a null
   pointer; VM_NOT_FINITE if Omega is infinite or NaN; an error of vmi_check_broken_rotor if the rotor is invalid;
   VM_DOMAIN at resonance; VM_OK otherwise. */
VM_API int vmi_broken_rotor_about_steady(const vm_broken_rotor *r, vm_real Omega, vmi_broken_rotor_steady *a)
{
    int status;
    vm_real detuning;
    if (!r) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(Omega)) return VM_NOT_FINITE;
    status = vmi_check_broken_rotor(r);
    if (status) return status;
    detuning = vmi_broken_rotor_detuning(r, Omega);
    if (detuning == 0) return VM_DOMAIN;
    a->w2 = r->stiffness / r->mass;
    a->O2 = Omega * Omega;
    a->k = r->damping / r->inertia;
    a->D = detuning / r->mass;
    a->G = r->s * (r->stiffness / detuning) * (r->s * r->stiffness / r->inertia);
    return VM_OK;
}

enum { VM_BROKEN_ROTOR_ROOTS = 5 /* degree of the characteristic polynomial */ };

/* Writes the coefficients of the characteristic polynomial. */
VM_API void vmi_broken_rotor_polynomial(const vmi_broken_rotor_steady *a, vm_real *p)
{
    p[0] = 1;
    p[1] = a->k;
    p[2] = 2 * (a->w2 + a->O2) + a->G;
    p[3] = 2 * a->k * (a->w2 + a->O2);
    p[4] = a->D * a->D + a->G * (a->w2 + 3 * a->O2);
    p[5] = a->k * (a->D * a->D);
}

/* Characteristic polynomial of small motions about the steady motion, (81) corrected.
   A small deviation from the steady motion at psi' = Omega (rad/s) is a sum of multiples of exp(l t), where l is a root
   of the polynomial. The array c gets the VM_BROKEN_ROTOR_ROOTS + 1 coefficients of the polynomial, that of the highest
   power first:
     l^5 + k* l^4 + (2 (w^2 + O^2) + G) l^3 + 2 k* (w^2 + O^2) l^2 + (D^2 + G (w^2 + 3 O^2)) l + k* D^2,
   with w = omega, O = Omega, D = w^2 - O^2, G = s^2 p^2 w^4/D. The left side of (81) should be l times this
   polynomial, but the last term of (81) is printed without the factor l^2. The corrected (81) has the additional root
   l = 0 because the phase of the steady motion is arbitrary. Returns VM_BAD_ARGUMENT for a null pointer; VM_NOT_FINITE
   if an argument or the result is infinite or NaN; VM_BAD_MASS or VM_BAD_INERTIA if the mass or the inertia of the
   rotor is not positive; VM_BAD_STIFFNESS if the stiffness is negative; VM_DOMAIN at resonance, where O^2 = w^2; VM_OK
   otherwise. */
VM_API int vm_broken_rotor_characteristic(const vm_broken_rotor *rotor, vm_real Omega, vm_real *c)
{
    vmi_broken_rotor_steady a;
    vm_real p[VM_BROKEN_ROTOR_ROOTS + 1];
    int status;
    if (!c) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_about_steady(rotor, Omega, &a);
    if (status) return status;
    vmi_broken_rotor_polynomial(&a, p);
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_ROOTS + 1, p, c);
}

/* First column of Routh's scheme of the characteristic polynomial: 1, k*, G, k* D, 4 G Omega^2, k* D^2. The function
   writes these VM_BROKEN_ROTOR_ROOTS + 1 numbers to the array `column`. The steady motion is asymptotically stable if
   all these numbers are positive. vm_broken_rotor_characteristic explains the letters k*, G, D and has the same
   statuses. */
VM_API int vm_broken_rotor_routh(const vm_broken_rotor *rotor, vm_real Omega, vm_real *column)
{
    vmi_broken_rotor_steady a;
    vm_real p[VM_BROKEN_ROTOR_ROOTS + 1];
    int status;
    if (!column) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_about_steady(rotor, Omega, &a);
    if (status) return status;
    p[0] = 1;
    p[1] = a.k;
    p[2] = a.G;
    p[3] = a.k * a.D;
    p[4] = 4 * a.G * a.O2;
    p[5] = a.k * (a.D * a.D);
    return vmi_copy_if_finite(VM_BROKEN_ROTOR_ROOTS + 1, p, column);
}

/* Tests whether the steady motion at psi' = Omega is asymptotically stable (82).
   Returns 1 if Omega^2 < omega^2, damping > 0, s != 0 and Omega != 0, which together are the condition for stability.
   Returns 0 otherwise, and also for a null pointer and an invalid rotor. (If damping, s or Omega is 0, some small
   deviations from the steady motion neither grow nor decay.) */
VM_API int vm_broken_rotor_is_stable(const vm_broken_rotor *rotor, vm_real Omega)
{
    if (!rotor || vmi_check_broken_rotor(rotor) || !VM_IS_FINITE(Omega)) return 0;
    return rotor->damping > 0 && rotor->s != 0 && Omega != 0 && vmi_broken_rotor_detuning(rotor, Omega) > 0;
}

/* Divides the coefficients c of the characteristic polynomial by powers of a number, so that its roots become multiples
   of this number, and returns the number. It is the sum of |Omega|, omega, |k*| and sqrt(|G|), with which no
   coefficient becomes larger than 10. If a coefficient would underflow, the number is a power of two near the size of
   the roots without damping; then a large k* makes some coefficients large. `speed` is |Omega|. */
VM_API vm_real vmi_broken_rotor_scale(const vmi_broken_rotor_steady *a, vm_real speed, vm_real *c)
{
    const vm_real root = VM_SQRT(VM_FABS(a->G)), size = speed + VM_SQRT(a->w2) + VM_FABS(a->k) + root;
    const vm_real unit = vmi_power_below(speed + VM_SQRT(a->w2) + root);
    vmi_broken_rotor_steady b = *a;
    vm_real d[VM_BROKEN_ROTOR_ROOTS + 1], power = 1;
    int i, is_normal = 1;
    b.w2 /= unit * unit;
    b.O2 /= unit * unit;
    b.D /= unit * unit;
    b.G /= unit * unit;
    b.k /= unit;
    vmi_broken_rotor_polynomial(&b, d);
    for (i = 1; i <= VM_BROKEN_ROTOR_ROOTS; i++) {
        power /= size;
        is_normal = is_normal && (d[i] == 0 || (VM_FABS(c[i]) >= VM_MIN && VM_FABS(c[i] * power) >= VM_MIN));
        c[i] *= power;
    }
    if (is_normal && power >= VM_MIN) return size;
    memcpy(c, d, sizeof d);
    return unit;
}

/* Roots re + i im of the characteristic polynomial, 1/s.
   re and im are arrays of VM_BROKEN_ROTOR_ROOTS numbers. The roots are sorted by increasing |im|. In a pair of
   conjugate roots, the root with im > 0 comes first. If each term of the coefficients, such as D^2 or G w^2, changed by
   the relative amount eps, each root would change; the error of a root is at most three times this change. This holds
   for |k*|/w from 1e-30 to 1e30 (float: 1e-12 to 1e12), even if the smallest root is many orders of magnitude smaller
   than the largest one. The real part of a root may have the wrong sign if it is much smaller than the imaginary part;
   vm_broken_rotor_is_stable is always right. The statuses are those of vm_broken_rotor_characteristic; VM_NOT_FINITE
   also means that no roots were found. */
VM_API int vm_broken_rotor_eigenvalues(const vm_broken_rotor *rotor, vm_real Omega, vm_real *re, vm_real *im)
{
    vmi_broken_rotor_steady a;
    vm_real c[VM_BROKEN_ROTOR_ROOTS + 1], x[VM_BROKEN_ROTOR_ROOTS], y[VM_BROKEN_ROTOR_ROOTS], size;
    int i, status;
    if (!re || !im) return VM_BAD_ARGUMENT;
    status = vmi_broken_rotor_about_steady(rotor, Omega, &a);
    if (!status) status = vm_broken_rotor_characteristic(rotor, Omega, c);
    if (status) return status;
    size = vmi_broken_rotor_scale(&a, VM_FABS(Omega), c);
    if (!vmi_all_finite(VM_BROKEN_ROTOR_ROOTS + 1, c)) return VM_NOT_FINITE;
    vmi_poly_roots(VM_BROKEN_ROTOR_ROOTS, c, x, y);
    for (i = 0; i < VM_BROKEN_ROTOR_ROOTS; i++) {
        x[i] *= size;
        y[i] *= size;
    }
    if (!vmi_all_finite(VM_BROKEN_ROTOR_ROOTS, x)) return VM_NOT_FINITE;
    status = vmi_copy_if_finite(VM_BROKEN_ROTOR_ROOTS, y, im);
    if (!status) memcpy(re, x, sizeof x);
    return status;
}

/* Returns ln(1 + x) - x + x^2/2 = x^3/3 - x^4/4 + ... for x >= 0. This is the dimensionless time in which the orbit of
   vm_broken_rotor_resonance_radius grows to the dimensionless radius x. For x <= 1 the formula with the logarithm would
   lose digits. The function then sums a series in w = x/(2 + x) <= 1/3 with positive terms only. The series is twice
   the sum of c_n w^n for n = 3, 4, 5, ..., where c_n is n - 2 for even n and n - 2 + 1/n for odd n. */
VM_API vm_real vmi_broken_rotor_growth_time(vm_real x)
{
    const int terms = VM_MANT_DIG > 24 ? 45 : 21;
    const vm_real w = x / (2 + x);
    vm_real sum = 0;
    int n;
    if (x > 1) return (vmi_log(1 + x).hi - x) + x * x / 2;
    for (n = terms; n >= 3; n--) {
        vm_real coefficient = (vm_real)(n - 2);
        if (n & 1) coefficient += 1 / (vm_real)n;
        sum = w * sum + coefficient;
    }
    return 2 * w * w * w * sum;
}

/* Returns the root x > 0 of the equation ln(1 + x) - x + x^2/2 = tau for tau > 0. The left side is a convex function of
   x. Newton's method starts from x = (3 tau)^(1/3) + (2 tau)^(1/2), which is above the root. Therefore every step
   decreases x, and the loop ends when rounding errors prevent a further decrease. */
VM_API vm_real vmi_broken_rotor_growth_root(vm_real tau)
{
    const int most_steps = 60;
    vm_real x = vmi_pow_checked(3 * tau, VM_C(1.) / 3) + VM_SQRT(2 * tau), fall;
    int i;
    for (i = 0; i < most_steps; i++) {
        fall = (vmi_broken_rotor_growth_time(x) - tau) * (1 + x) / (x * x);
        if (!(fall > 0)) break;
        x -= fall;
    }
    return x;
}

/* Radius of the orbit that grows at or above resonance, t seconds after a start from rest, m.
   Omega = torque/damping (rad/s) must be at or above omega; vm_broken_rotor explains omega, p, k* and s. The angular
   velocity psi' stays at omega, and the surplus of the torque makes the orbit grow. The radius is r = |s|/4 + R, where
   R = 0 at t = 0 and, with R' = dR/dt,
     R R' = k* (Omega - omega)/(2 p^2 omega) + k* |s|/(4 p^2 R).
   It follows that
     R = (3 k* |s| t/(4 p^2))^(1/3) at resonance,  R -> (k* (Omega - omega) t/(p^2 omega))^(1/2) above it.
   For large r/|s| the radius r can be expanded in a series, whose first term is R and whose second term is |s|/4.
   Terms of order s^2/r and the time until psi' reaches omega are neglected. The resulting error is small: for the
   rotor of Fig. 18 (s = 0.5 m, omega = 1 rad/s), after 400 s, the radius r differs by less than 0.002 m from the
   radius of the numerically integrated motion for Omega = 1, 1.01 and 1.1 rad/s.
   Returns NaN below resonance, for t < 0, damping < 0, omega = 0, a null pointer and an invalid rotor, and where mass
   Omega^2 overflows. The solution of R R' = A + B/R, with constants A and B, is t A^3/B^2 = ln(1 + x) - x + x^2/2 with
   x = A R/B. */
VM_API vm_real vm_broken_rotor_resonance_radius(const vm_broken_rotor *rotor, vm_real t, vm_real Omega)
{
    vm_real over, w, A, B, R, z;
    if (!rotor || vmi_check_broken_rotor(rotor) || !(t >= 0) || !VM_IS_FINITE(t) || !VM_IS_FINITE(Omega))
        return VM_NAN;
    over = -vmi_broken_rotor_detuning(rotor, Omega);
    w = VM_SQRT(rotor->stiffness / rotor->mass);
    if (!(over >= 0) || !(w > 0) || !(rotor->damping >= 0)) return VM_NAN;
    A = rotor->damping * (over / rotor->mass / (VM_FABS(Omega) + w)) / (2 * rotor->mass * w);
    B = rotor->damping * VM_FABS(rotor->s) / (4 * rotor->mass);
    R = vmi_pow_checked(3 * B * t, VM_C(1.) / 3);
    if (A == 0 || t == 0) return VM_FABS(rotor->s) / 4 + R;
    z = A * R / B; /* A is negligible for z < eps, and B/R for z > 1/eps or B = 0 */
    if (!(z < 1 / VM_EPSILON)) R = VM_SQRT(2 * A * t);
    else if (z > VM_EPSILON) R = vmi_broken_rotor_growth_root(z * z * z / 3) * B / A;
    return VM_FABS(rotor->s) / 4 + R;
}

#endif
