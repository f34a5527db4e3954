#!/usr/bin/env python3
"""The kit from Python: the headers compiled into a shared library, called by ctypes. A pendulum-like oscillator
x'' + x^3 = 0 by its exact Ateb functions, and what is left of a satellite that throws off a panel.

usage: python3 examples/python/swing.py, from the top of the project; needs a C compiler ($CC or cc) and nothing else"""
import ctypes
import os
import subprocess
import tempfile


def build(folder):
    """varmass.h with every function exported: VM_API, by default static inline, is made empty."""
    library = os.path.join(folder, "libvarmass.so")
    subprocess.run([os.environ.get("CC", "cc"), "-std=c99", "-O2", "-shared", "-fPIC", "-DVM_API=", "-x", "c", "varmass.h",
                    "-o", library, "-lm"], check=True)
    return ctypes.CDLL(library)


class Vec3(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in "xyz"]


class Inertia(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("xx", "yy", "zz", "xy", "xz", "yz")]


class Quat(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in "wxyz"]


class Body(ctypes.Structure):
    """vm_body"""
    _fields_ = [("mass", ctypes.c_double), ("inertia", Inertia), ("q", Quat), ("r", Vec3), ("v", Vec3), ("omega", Vec3)]


with tempfile.TemporaryDirectory() as folder:
    kit = build(folder)
    real = ctypes.c_double
    kit.vm_osc_period.restype = real
    kit.vm_osc_period.argtypes = [real] * 3
    kit.vm_osc_exact.argtypes = [real] * 4 + [ctypes.POINTER(real)] * 2
    kit.vm_separate.argtypes = [ctypes.POINTER(Body)] * 2 + [ctypes.c_void_p, ctypes.POINTER(Body)]
    kit.vm_kinetic_energy.restype = real
    kit.vm_kinetic_energy.argtypes = [ctypes.POINTER(Body)]

    period = kit.vm_osc_period(1, 1, 3)
    print(f"x'' + x^3 = 0, x(0) = 1: period {period:.12f} s")
    x, v = real(), real()
    for i in range(5):
        kit.vm_osc_exact(i * period / 8, 1, 1, 3, x, v)
        print(f"  t = {i * period / 8:.4f}   x = {x.value:+.9f}   v = {v.value:+.9f}   energy {v.value**2 / 2 + x.value**4 / 4:.15f}")

    satellite = Body(500, Inertia(120, 150, 180, 0, 0, 0), Quat(1, 0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0.1))
    panel = Body(20, Inertia(2, 3, 4, 0, 0, 0), Quat(1, 0, 0, 0), Vec3(1.2, 0, 0), Vec3(0.3, 0.12, 0), Vec3(0, 0, 0.1))
    rest = Body()
    status = kit.vm_separate(satellite, panel, None, rest)
    print(f"a panel is thrown off ({status}): the rest spins at {rest.omega.z:.6f} rad/s instead of {satellite.omega.z}, "
          f"moves at ({rest.v.x:.5f}, {rest.v.y:.5f}) m/s")
    gained = kit.vm_kinetic_energy(rest) + kit.vm_kinetic_energy(panel) - kit.vm_kinetic_energy(satellite)
    print(f"energy gained {gained:.9f} J")
