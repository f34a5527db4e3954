/* oscillator_problem.h - the problem that the tests of one oscillator start from: at rest at x = 1, of stiffness
   1, with a law of mass. Include it after ../varmass.h. */
#ifndef OSCILLATOR_PROBLEM_H
#define OSCILLATOR_PROBLEM_H

static inline vm_osc_problem problem(double alpha, vm_law mass, double reactive, double damping)
{
    vm_osc_problem o;
    memset(&o, 0, sizeof o);
    o.alpha = (vm_real)alpha;
    o.mass = mass;
    o.stiffness = vm_law_linear(1, 0);
    o.reactive = (vm_real)reactive;
    o.damping = (vm_real)damping;
    o.x = 1;
    return o;
}

#endif
