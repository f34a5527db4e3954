/* varmass.h: the oscillator's constants and laws by their definitions; the words of the status codes. */
#include "../varmass.h"
#include "check.h"

#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';

static void test_status(void)
{
    int status, other;
    for (status = VM_TOO_MANY_EVENTS; status <= VM_TOLERANCE_MISSED; status++) /* each has its own words */
        for (other = status + 1; other <= VM_TOLERANCE_MISSED + 1; other++)
            CHECK(strcmp(vm_strerror(status), vm_strerror(other)) != 0);
}

static void test_oscillator(void)
{
    const double alphas[] = {0, 0.1, 0.5, 1, 4. / 3, 3, 10, 100};
    const vm_real x0 = R(-1.7), omega0 = R(0.8);
    int i, k;
    for (i = 0; i < 8; i++) {
        double alpha = (double)R(alphas[i]), w2 = (double)omega0 * (double)omega0, vmax;
        double E0 = pow(fabs((double)x0), alpha + 1) * w2 / (alpha + 1), unit = (double)VM_EPSILON * (alpha + 1);
        vm_real period = vm_osc_period(x0, omega0, R(alpha)), x, v, T, kp, K;
        vmax = (double)vm_osc_vmax(x0, omega0, R(alpha));
        check_error("vmax^2/2 = E", "", "eps*", fabs(vmax * vmax / 2 / E0 - 1) / unit, 3, alpha, 0);
        for (k = 0; k <= 40; k++) { /* the energy integral (259) along the exact motion */
            double E, t = uniform(0, 3) * (double)period;
            vm_osc_exact(R(t), x0, omega0, R(alpha), &x, &v);
            E = (double)v * (double)v / 2 + w2 * pow(fabs((double)x), alpha + 1) / (alpha + 1);
            check_error("energy (259)", "", "eps*", fabs(E / E0 - 1) / unit, 6, t, alpha);
        }
        for (k = 0; k < 20; k++) { /* x' is the slope of x, for x0 and omega0 of either sign */
            vm_real x_plus, x_minus, h = R(is_float ? 1e-2 : 1e-5), start = k % 2 ? x0 : -x0,
                                     w = k % 4 < 2 ? omega0 : -omega0;
            double t = uniform(0.1, 2) * (double)period, slope;
            vm_osc_exact(R(t), start, w, R(alpha), &x, &v);
            vm_osc_exact(R(t) + h, start, w, R(alpha), &x_plus, &v);
            vm_osc_exact(R(t) - h, start, w, R(alpha), &x_minus, &v);
            vm_osc_exact(R(t), start, w, R(alpha), &x, &v);
            slope = (double)(x_plus - x_minus) / (2 * (double)h);
            if (alpha < 20) CHECK(fabs(slope - (double)v) < (is_float ? 2e-2 : 1e-3) * vmax);
        }
        CHECK(vm_osc_period(x0, -omega0, R(alpha)) == period && (double)vm_osc_vmax(x0, -omega0, R(alpha)) == vmax);
        vm_osc_exact(period / 2, x0, omega0, R(alpha), &x, &v);
        check_error("x(T/2) = -x0", "", "eps", fabs((double)(x + x0)) / (double)VM_EPSILON, 4, alpha, 0);
        /* the three frequencies go with one period: Omega_alpha T = 2 pi, Omega_1* T = 4 K; and (307) */
        T = vm_osc_period(1, 1, R(alpha));
        check_error("Omega_a T/(2 pi)", "", "eps",
                    fabs((double)(vm_osc_omega_trig(R(alpha)) * T) / 6.283185307179586 - 1) / (double)VM_EPSILON, 4,
                    alpha, 0);
        K = jacobi_K(vm_osc_jacobi_parameter(R(alpha)));
        kp = VM_SQRT(1 - vm_osc_jacobi_parameter(R(alpha)));
        check_error("Omega_1 T/(4 K)", "", "eps",
                    fabs((double)(vm_osc_omega_jacobi(R(alpha)) * T / (4 * K)) - 1) / (double)VM_EPSILON, 12, alpha,
                    0);
        check_error("Omega_1 k' = vmax", "", "eps",
                    fabs((double)(vm_osc_omega_jacobi(R(alpha)) * kp / vm_osc_vmax(1, 1, R(alpha))) - 1) /
                        (double)VM_EPSILON,
                    12, alpha, 0);
    }
    for (i = 0; i < 8; i++) { /* no amplitude, no motion */
        vm_real x, v;
        vm_osc_exact(1, 0, 1, R(alphas[i]), &x, &v);
        CHECK(x == 0 && v == 0 && vm_osc_vmax(0, 1, R(alphas[i])) == 0);
        vm_osc_exact(1, 0, 0, R(alphas[i]), &x, &v);
        CHECK(x == 0 && v == 0 && vm_osc_vmax(0, 0, R(alphas[i])) == 0);
    }
}

static void test_laws(void)
{
    const double m = 6, eps = (double)VM_EPSILON;
    int r;
    double alpha, D;
    for (alpha = 0; alpha < 20; alpha = 1.5 * alpha + 0.25) {
        for (D = 0; D < 1; D += 0.3) {
            for (r = 0; r <= 1; r++) { /* the adiabatic invariant sqrt(k/m) A^((alpha+3)/2) exp(int (r m' + b)/m) */
                double A = (double)vm_osc_amplitude_law(R(m), R(D), R(r), R(alpha));
                double v = (double)vm_osc_velocity_law(R(m), R(D), R(r), R(alpha));
                double J = pow(m, -0.5) * pow(A, (alpha + 3) / 2) * pow(m, r) * exp(D);
                check_error("invariant", "", "eps*", fabs(J - 1) / eps / (alpha + 1), 6, alpha, D);
                check_error("v^2 m = A^(a+1)", "", "eps*",
                            fabs(v * v * m / pow(A, alpha + 1) - 1) / eps / (alpha + 1), 6, alpha, D);
            }
        }
    }
    /* m' = -2 b (reactive) keeps the amplitude (348): (m0/m)^(1/(a+3)) exp(-2/(a+3) b ln(m/m0)/m') = 1 */
    check_error("m' = -2 b", "", "eps",
                fabs((double)vm_osc_amplitude_law(R(0.5), R(-0.5 * log(0.5)), 1, R(1.5)) - 1) / eps, 2, 0, 0);
    CHECK(vm_osc_amplitude_law(1, 0, 1, 3) == 1 && vm_osc_velocity_law(1, 0, 0, 3) == 1);
    CHECK(isnan(vm_osc_amplitude_law(-1, 0, 1, 3)) && isnan(vm_osc_velocity_law(0, 0, 1, 3)));
    CHECK(isnan(vm_osc_amplitude_law(2, 0, 1, -1)) && isnan(vm_osc_velocity_law(2, 0, 1, VM_INFINITY)));
    CHECK(isnan(vm_osc_period(1, 1, -1)) && isnan(vm_osc_vmax(1, 1, VM_NAN)) && isnan(vm_osc_omega_trig(R(-0.1))));
    CHECK(isnan(vm_osc_period(VM_INFINITY, 1, 1)) && isnan(vm_osc_vmax(1, VM_INFINITY, 3)) &&
          isnan(vm_osc_vmax(VM_NAN, 1, 3)));
    CHECK(isnan(vm_osc_amplitude_law(2, VM_INFINITY, 1, 3)) && isnan(vm_osc_velocity_law(2, 0, VM_INFINITY, 3)));
    CHECK(isnan(vm_osc_amplitude_law(VM_INFINITY, 0, 1, 3)) && isnan(vm_osc_velocity_law(2, -VM_INFINITY, 1, 3)));
    CHECK(isnan(vm_osc_jacobi_parameter(VM_INFINITY)) && isnan(vm_osc_omega_jacobi(-1)));
}

int main(void)
{
    test_status();
    test_oscillator();
    test_laws();
    return check_finish("varmass.h");
}
