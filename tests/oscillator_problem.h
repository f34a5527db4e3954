/* What the tests of oscillators share: x = 1 at rest, a spring of 1, the mass by a law. After ../varmass.h */
#ifndef OSCILLATOR_PROBLEM_H
#define OSCILLATOR_PROBLEM_H

static vm_osc_problem problem(double alpha, vm_law mass, double reactive, double damping)
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
