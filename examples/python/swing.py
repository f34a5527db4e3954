#!/usr/bin/env python3
"""The kit from Python, by the module varmass beside this file: an oscillator x'' + x^3 = 0 by its exact Ateb
functions, and what is left of a satellite that throws off a panel.

usage: python3 examples/python/swing.py; needs a C compiler ($CC or cc) and nothing else"""
import varmass

period = varmass.vm_osc_period(1, 1, 3)
print(f"x'' + x^3 = 0, x(0) = 1: period {period:.12f} s")
times = [i * period / 8 for i in range(5)]
for t, x, v in zip(times, *varmass.vm_osc_exact(times, 1, 1, 3)):
    print(f"  t = {t:.4f}   x = {x:+.9f}   v = {v:+.9f}   energy {v**2 / 2 + x**4 / 4:.15f}")

satellite = varmass.Body(500, inertia=(120, 150, 180), omega=(0, 0, 0.1))
panel = varmass.Body(20, inertia=(2, 3, 4), r=(1.2, 0, 0), v=(0.3, 0.12, 0), omega=(0, 0, 0.1))
rest = varmass.separate(satellite, panel)
print(f"a panel is thrown off: the rest spins at {rest.omega[2]:.6f} rad/s instead of {satellite.omega[2]}, "
      f"moves at ({rest.v[0]:.5f}, {rest.v[1]:.5f}) m/s")
gained = rest.kinetic_energy() + panel.kinetic_energy() - satellite.kinetic_energy()
print(f"energy gained {gained:.9f} J")
