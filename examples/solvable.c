/* A nonlinear oscillator with variable mass that has an exact solution. Snow settles on a cart with a cubic spring.
   The mass of the cart grows as m = m0 (1 + a t)^(6/5), and the snow has no velocity before it lands, so that
     d(m x')/dt + k x^3 = 0.
   Only for the power 6/5 the disturbance G0 in the law of order five is zero at all times (docs/law.md). Therefore the
   amplitude and the phase of x and V = x' + p x, with p = a/(5 (1 + a t)), follow the mean motion without any error:
     x = A0 s ca(psi),   x' = -(W/2) A0 s sa(psi) - p x   with s = (1 + a t)^(-1/5),
     psi = psi0 + 5 W0 ((1 + a t)^(1/5) - 1)/a,   W = W0 (1 + a t)^(-4/5).
   Here A0, psi0 and W0 are the amplitude, the phase and the rate of the phase at t = 0. The program compares this
   formula with the law of order five and with integration by rk87. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../varmass.h"

static const double m0 = 2, k = 8, a = 0.05, x0 = 0.3, v0 = 0.1; /* kg, N/m^3, 1/s, m, m/s */

/* x by the formula above */
static double exact(double t)
{
    const double growth = 1 + a * t, omega0 = sqrt(k / m0), p0 = a / 5;
    double start_amplitude, psi, sa, ca, start_rate;
    vm_osc_amplitude_phase(x0, v0 + p0 * x0, omega0, 3, &start_amplitude, &psi);
    start_rate = sqrt(2) * omega0 * start_amplitude;
    psi += 5 * start_rate * (pow(growth, 0.2) - 1) / a;
    ateb_saca(psi, 3, &sa, &ca);
    return start_amplitude * pow(growth, -0.2) * ca;
}

int main(void)
{
    vm_osc_problem cart;
    vm_osc_plan plan;
    double t;
    memset(&cart, 0, sizeof cart);
    cart.alpha = 3;
    cart.mass = vm_law_power(m0, a, 1.2);
    cart.stiffness = vm_law_linear(k, 0);
    cart.reactive = 1;
    cart.x = x0;
    cart.v = v0;
    if (vm_osc_plan_init(&plan, &cart) != VM_OK) return 1;
    puts("Snow on a cart with a cubic spring: d/dt(m x') + k x^3 = 0, m = m0 (1 + a t)^(6/5)");
    puts("     t, s      mass, kg   x by the formula, m   error of order five, m   error of rk87, m");
    for (t = 0; t <= 400; t += 50) {
        vm_osc_motion law, integrated;
        const double x = exact(t);
        if (vm_osc_plan_by_route(&plan, VM_ROUTE_ORDER5, t, 0, &law) != VM_OK) return 1;
        if (vm_osc_plan_by_route(&plan, VM_ROUTE_RK87, t, 1e-9, &integrated) < 0) return 1;
        printf("%9.0f %12.4f %20.15f %18.1e %21.1e\n", t, m0 * pow(1 + a * t, 1.2), x, fabs(law.x - x),
               fabs(integrated.x - x));
    }
    return 0;
}
