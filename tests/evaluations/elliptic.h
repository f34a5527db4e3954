/* elliptic.h - random evaluations of the elliptic integrals, and of the parameters that K and k'K belong to */
#ifndef EVALUATIONS_ELLIPTIC_H
#define EVALUATIONS_ELLIPTIC_H

#include "draws.h"

static trial try_K(random_bits *g)
{
    const vm_real m = random_m(g), K = jacobi_K(m),
                  below = jacobi_K(m > 0 ? vmi_from_bits(vmi_to_bits(m) - 1) : m * (1 + EPS));
    return result(m, 0, 0,
                  m == 1 ? K > VM_MAX
                         : K > 0 && below <= K * (1 + 4 * EPS) && same_size(jacobi_kpK(m), VM_SQRT(1 - m) * K, 8));
}

static trial try_E(random_bits *g)
{
    const vm_real m = random_m(g), E = jacobi_E(m),
                  below = jacobi_E(m > 0 ? vmi_from_bits(vmi_to_bits(m) - 1) : m * (1 + EPS));
    return result(m, 0, 0, E >= 1 && below >= E * (1 - 4 * EPS));
}

static trial try_legendre(random_bits *g) /* E K' + E' K - K K' = pi/2 */
{
    const vm_real m = uniform(g, 1e-9, 1 - 1e-7), K = jacobi_K(m), E = jacobi_E(m), K1 = jacobi_K_m1(m),
                  E1 = jacobi_E_m1(m);
    return result(m, 0, 0, VM_FABS(E * K1 + E1 * K - K * K1 - VM_PI / 2) <= 6 * EPS * (E * K1 + E1 * K + K * K1));
}

/* F and E between their neighbours, and F E >= phi^2 (Schwarz) */
static trial try_incomplete(random_bits *g)
{
    const vm_real m = random_m(g), phi = random_phase(g, R(1.5707963267948966));
    const vm_real x = VM_FABS(phi), F = jacobi_F(x, m), E = jacobi_E_incomplete(x, m);
    return result(phi, m, 0,
                  jacobi_F(-x, m) == -F && jacobi_E_incomplete(-x, m) == -E &&
                      (m > 0 ? E <= F * (1 + 16 * EPS) : F <= E * (1 + 16 * EPS)) &&
                      (x == 0 || (jacobi_F(next_up(x), m) >= F * (1 - 16 * EPS) && F * (E / x) >= x * (1 - 32 * EPS))));
}

/* A characteristic n of Pi, for which 1 - n lies between 2^-10 and 2^20 */
static vm_real random_n(random_bits *g) { return 1 - of_size(g, -10, 20); }

/* Pi lies between F and F/(1 - n). */
static int is_Pi(vm_real P, vm_real F, vm_real n)
{
    const vm_real bound = F / (1 - n);
    if (n < 0) return P <= F * (1 + 20 * EPS) && P >= bound * (1 - 20 * EPS);
    return P >= F * (1 - 20 * EPS) && P <= bound * (1 + 20 * EPS);
}

static trial try_Pi(random_bits *g)
{
    const vm_real m = random_m(g), n = random_n(g), x = VM_FABS(random_phase(g, R(1.5707963267948966)));
    return result(x, n, m, is_Pi(jacobi_Pi_incomplete(x, n, m), jacobi_F(x, m), n));
}

static trial try_carlson(random_bits *g)
{
    const vm_real x = of_size(g, -20, 20), y = of_size(g, -20, 20), z = of_size(g, -20, 20);
    const vm_real D = jacobi_RD(x, y, z), F = jacobi_RF(x, y, z);
    return result(x, y, z,
                  same_size(jacobi_RJ(x, y, z, z), D, 24) && same_size(jacobi_RF(z, x, y), F, 16) &&
                      F * jacobi_RG(x, y, z) >= 1 - 32 * EPS && same_size(jacobi_RF(x, y, y), jacobi_RC(x, y), 16));
}

static trial try_solve_kpK(random_bits *g)
{
    const vm_real c = of_size(g, -5, 5), m1 = jacobi_solve_kpK_m1(c);
    return result(c, 0, 0, m1 < VM_MIN || m1 > VM_MAX / 4 || same_size(VM_SQRT(m1) * jacobi_K_m1(m1), c, 12));
}

static trial try_solve_K(random_bits *g)
{
    const vm_real c = of_size(g, -5, 5), m1 = jacobi_solve_K_m1(c);
    return result(c, 0, 0, m1 < VM_MIN || m1 > VM_MAX / 4 || same_size(jacobi_K_m1(m1), c, 12));
}

static trial try_cn_means(random_bits *g)
{
    const vm_real m = random_m(g);
    vm_real C2, C4, C6;
    jacobi_cn_means(m, &C2, &C4, &C6);
    return result(m, 0, 0,
                  m == 1 || (C2 <= 1 && C4 <= C2 * (1 + 16 * EPS) && C6 <= C4 * (1 + 16 * EPS) && C6 > 0 &&
                             C4 >= C2 * C2 * (1 - 24 * EPS)));
}

/* K = E + m D, up to the errors of the three; with phi or without */
static int makes_K(vm_real K, vm_real E, vm_real D, vm_real m)
{
    return !VM_IS_FINITE(K) || VM_FABS(K - E - m * D) <= 12 * EPS * (K + E + VM_FABS(m) * D);
}

static trial try_D(random_bits *g)
{
    const vm_real m = random_m(g), m1 = random_m1(g), D = jacobi_D(m), D1 = jacobi_D_m1(m1);
    return result(m, m1, 0,
                  D >= 0 && D1 >= 0 && makes_K(jacobi_K(m), jacobi_E(m), D, m) &&
                      makes_K(jacobi_K_m1(m1), jacobi_E_m1(m1), D1, 1 - m1));
}

static trial try_D_incomplete(random_bits *g)
{
    const vm_real m = random_m(g), x = VM_FABS(random_phase(g, R(1.5707963267948966)));
    const vm_real D = jacobi_D_incomplete(x, m);
    return result(x, m, 0, D >= 0 && makes_K(jacobi_F(x, m), jacobi_E_incomplete(x, m), D, m));
}

static trial try_incomplete_m1(random_bits *g)
{
    const vm_real m1 = random_m1(g), x = VM_FABS(random_phase(g, R(1.5707963267948966)));
    const vm_real F = jacobi_F_m1(x, m1), E = jacobi_E_incomplete_m1(x, m1), D = jacobi_D_incomplete_m1(x, m1);
    return result(x, m1, 0, F >= 0 && E >= 0 && D >= 0 && makes_K(F, E, D, 1 - m1));
}

static trial try_Pi_complete(random_bits *g)
{
    const vm_real m = random_m(g), m1 = random_m1(g), n = random_n(g);
    return result(n, m, m1, is_Pi(jacobi_Pi(n, m), jacobi_K(m), n) && is_Pi(jacobi_Pi_m1(n, m1), jacobi_K_m1(m1), n));
}

static trial try_Pi_m1(random_bits *g)
{
    const vm_real m1 = random_m1(g), n = random_n(g), x = VM_FABS(random_phase(g, R(1.5707963267948966)));
    return result(x, n, m1, is_Pi(jacobi_Pi_incomplete_m1(x, n, m1), jacobi_F_m1(x, m1), n));
}

/* m and m1 of the same K or k'K add up to 1; an error of c changes m by the rest. */
static trial try_solve_m(random_bits *g)
{
    const vm_real c = of_size(g, -5, 5), m = jacobi_solve_K(c), mk = jacobi_solve_kpK(c);
    return result(c, 0, 0,
                  m <= 1 && mk <= 1 && VM_FABS(1 - m - jacobi_solve_K_m1(c)) <= EPS * 16 * (1 + VM_FABS(m)) &&
                      VM_FABS(1 - mk - jacobi_solve_kpK_m1(c)) <= EPS * (16 + 4 * c) * (1 + VM_FABS(mk)));
}

#endif
