"""Tests of examples/python/varmass.py: numbers, lists and arrays, jumps, oscillators, rotation, integration, refusals.
usage: python3 tests/python_module.py, from the top of the project"""
import math
import sys

sys.path.insert(0, "examples/python")
import varmass


def close(a, b, bound=1e-12):
    return abs(a - b) <= bound * max(1, abs(b))


def raises(error, function, *arguments):
    try:
        function(*arguments)
    except error:
        return True
    return False


# functions of numbers: known values, a list is the numbers one by one, outside the domain NaN
assert close(varmass.jacobi_K(0), math.pi / 2) and close(varmass.ateb_pi(1), math.pi)
sn, cn, dn = varmass.jacobi_sncndn([0.5, 1.0, 1.5], 0.3)
assert [varmass.jacobi_sn(u, 0.3) for u in (0.5, 1.0, 1.5)] == sn and close(dn[1] ** 2 + 0.3 * sn[1] ** 2, 1)
assert varmass.vm_lambert_w0([]) == [] and math.isnan(varmass.jacobi_K(2))
assert raises(ValueError, varmass.jacobi_sn, [1, 2], [0.1, 0.2, 0.3]) and raises(TypeError, varmass.jacobi_sn, 1)
if varmass.numpy is not None:
    grid = varmass.jacobi_sn(varmass.numpy.linspace(0, 1, 6).reshape(2, 3), 0.3)
    assert grid.shape == (2, 3) and grid[1, 2] == varmass.jacobi_sn(1, 0.3)

# jumps: what separates and is attached again
whole = varmass.Body(5, inertia=(2, 2, 1), v=(10, 0, 0), omega=(0, 0, 3))
part = varmass.Body(1, inertia=(0.1, 0.1, 0.1), r=(0.4, 0, 0), v=(10, 2, 0), omega=(0, 0, 3))
rest = varmass.separate(whole, part)
again = varmass.attach(rest, part)
assert rest.mass == 4 and all(close(a, b) for a, b in zip(list(again.v) + list(again.omega), [10, 0, 0, 0, 0, 3]))
assert raises(ValueError, varmass.separate, part, whole)

# an oscillator of constant mass, exact; a leaking one by its cheapest route and by rk87 in Python
steady = varmass.Oscillator(alpha=3, mass=1, stiffness=1, x=1)
x, v = varmass.vm_osc_exact(2.5, 1, 1, 3)
motion = steady.at(2.5, 1e-12)
assert close(motion.x, x, 1e-10) and close(motion.v, v, 1e-10)
tray = varmass.Oscillator(alpha=3, mass=(10, -0.1), stiffness=10000, x=0.1)
rows = varmass.solve(lambda t, y: (y[1], -10000 * y[0] ** 3 / (10 - 0.1 * t)), (0.1, 0), [0, 5, 10], rtol=1e-12)
motion = tray.at([5, 10], 1e-10)
assert all(close(a, row[0], 1e-10) for a, row in zip(motion.x, rows[1:])) and max(motion.error) < 1e-10
assert raises(ValueError, varmass.Oscillator(alpha=3, mass=-1, stiffness=1, x=1).at, 1)
assert raises(ZeroDivisionError, varmass.solve, lambda t, y: [1 / 0], [1], [0, 1])
assert raises(ValueError, varmass.solve, lambda t, y: [1, 2], [1], [0, 1])

# free rotation keeps its energy
body = varmass.Body(1, inertia=(1, 2, 3), omega=(0.01, 5, 0))
for later in varmass.rotation(body, [0, 1, 1e6]):
    assert close(later.kinetic_energy(), body.kinetic_energy())
print("python_module: passed", "with NumPy" if varmass.numpy is not None else "without NumPy")
