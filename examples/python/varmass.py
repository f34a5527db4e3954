"""varmass from Python, usable from a clone of the project. The first import compiles the headers into a shared library
under build/ (by $CC or cc), and ctypes calls it. Nothing else is needed. Where NumPy is installed, functions of numbers
take and return its arrays, too.

    import varmass
    varmass.jacobi_K(0.5)                        # a number
    varmass.ateb_sa([0, 0.1, 0.2], 3)            # a list, number by number
    tray = varmass.Oscillator(alpha=1.5, mass=(10, -0.1), stiffness=100, x=0.1)
    tray.at([10, 20, 30], tolerance=1e-10).x     # positions, m, at these times, s
    rest = varmass.separate(whole, part)         # Body objects, a jump
    varmass.rotation(body, [1, 1e6])             # a free body at these times
    varmass.solve(lambda t, y: (y[1], -y[0] ** 3), (1, 0), [0, 1, 2])  # y at these times, by rk87

A call that the headers refuse raises ValueError with their explanation."""
import collections
import ctypes
import os
import subprocess
import tempfile

try:
    import numpy
except ImportError:
    numpy = None

_TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
_HEADERS = [os.path.join(_TOP, name) for name in ("varmass.h", "ateb.h", "jacobi.h", "integrators.h")]
_GLUE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "glue.c")
BUILD = os.path.join(_TOP, "build", "python")
_LIBRARY = os.path.join(BUILD, "libvarmass.so")

# Functions of numbers: name, number of arguments, number of results. The arguments are those of the C function.
_FUNCTIONS = [
    ("jacobi_K", 1, 1), ("jacobi_E", 1, 1), ("jacobi_F", 2, 1), ("jacobi_E_incomplete", 2, 1), ("jacobi_Pi", 2, 1),
    ("jacobi_Pi_incomplete", 3, 1), ("jacobi_sncndn", 2, 3), ("jacobi_am", 2, 1), ("jacobi_sn", 2, 1),
    ("jacobi_cn", 2, 1), ("jacobi_dn", 2, 1), ("jacobi_inverse_sn", 2, 1), ("jacobi_RF", 3, 1), ("jacobi_RJ", 4, 1),
    ("ateb_pi", 1, 1), ("ateb_saca", 2, 2), ("ateb_sa", 2, 1), ("ateb_ca", 2, 1), ("ateb_phase", 3, 1),
    ("ateb_beta", 2, 1), ("ateb_beta_inc", 3, 1), ("ateb_beta_inc_inv", 3, 1), ("vm_lambert_w0", 1, 1),
    ("vm_lambert_wm1", 1, 1), ("vm_wright_omega", 1, 1), ("vm_osc_period", 3, 1), ("vm_osc_exact", 4, 2),
    ("vm_osc_exact_from", 5, 2), ("vm_osc_amplitude_law", 4, 1), ("vm_duffing_period", 3, 1),
    ("vm_duffing_exact_from", 5, 2), ("vm_tsiolkovsky", 4, 1),
]


def _loop(name, arguments, results):
    """The C function py_NAME, which calls NAME for n sets of arguments"""
    values = ", ".join(f"in[{k}][i]" for k in range(arguments))
    places = "".join(f", &out[{k}][i]" for k in range(results))
    call = f"out[0][i] = {name}({values})" if results == 1 else f"{name}({values}{places})"
    return f"void py_{name}(int n, double **in, double **out) {{ int i; for (i = 0; i < n; i++) {call}; }}\n"


def _build():
    """The library, compiled anew where the headers or these files are newer. VM_API, by default static inline, is made
    empty, so that the library exports every function."""
    newest = max(os.path.getmtime(name) for name in _HEADERS + [_GLUE, __file__])
    if not os.path.exists(_LIBRARY) or os.path.getmtime(_LIBRARY) < newest:
        os.makedirs(BUILD, exist_ok=True)
        with open(os.path.join(BUILD, ".gitignore"), "w") as file:
            file.write("*\n")
        with tempfile.TemporaryDirectory(dir=BUILD) as folder:
            source, library = os.path.join(folder, "kit.c"), os.path.join(folder, "lib.so")
            with open(source, "w") as file:
                file.write(f'#include "{_GLUE}"\n' + "".join(_loop(*f) for f in _FUNCTIONS))
            subprocess.run([os.environ.get("CC", "cc"), "-std=c99", "-O2", "-shared", "-fPIC", "-DVM_API=",
                            "-I", _TOP, source, "-o", library, "-lm"], check=True)
            os.replace(library, _LIBRARY)
    return ctypes.CDLL(_LIBRARY)


_kit = _build()
_real = ctypes.c_double
_kit.vm_strerror.restype = _kit.ode_strerror.restype = ctypes.c_char_p
_kit.vm_osc_route_name.restype = ctypes.c_char_p
_kit.py_seconds.restype = _kit.vm_kinetic_energy.restype = _real


def _check(status, explain):
    if status < 0:
        raise ValueError(explain(status).decode())


def _is_sequence(x):
    return isinstance(x, (list, tuple)) or numpy is not None and isinstance(x, numpy.ndarray)


def _spread(*arguments):
    """The arguments as C arrays of one length, and a function that turns such an array into what the caller gave: a
    number, a list or a NumPy array"""
    if numpy is not None and any(isinstance(a, numpy.ndarray) for a in arguments):
        whole = numpy.broadcast_arrays(*arguments)
        columns = [(_real * a.size)(*a.ravel()) for a in whole]
        return columns, lambda column: numpy.array(column[:]).reshape(whole[0].shape)
    lengths = {len(a) for a in arguments if _is_sequence(a)}
    if len(lengths) > 1:
        raise ValueError("sequences of different lengths")
    if not lengths:
        return [(_real * 1)(a) for a in arguments], lambda column: column[0]
    n = lengths.pop()
    return [(_real * n)(*(a if _is_sequence(a) else [a] * n)) for a in arguments], lambda column: column[:]


def _pointers(columns):
    pointer = ctypes.POINTER(_real)
    return (pointer * len(columns))(*(ctypes.cast(c, pointer) for c in columns))


def _function(name, arguments, results):
    def function(*values):
        if len(values) != arguments:
            raise TypeError(f"{name} takes {arguments} arguments")
        columns, back = _spread(*values)
        n = len(columns[0])
        out = [(_real * n)() for _ in range(results)]
        getattr(_kit, "py_" + name)(n, _pointers(columns), _pointers(out))
        return back(out[0]) if results == 1 else tuple(back(o) for o in out)
    function.__name__ = name
    function.__doc__ = f"{name} for numbers, lists and arrays; arguments: {arguments}, results: {results}"
    return function


globals().update({f[0]: _function(*f) for f in _FUNCTIONS})


class Body(ctypes.Structure):
    """vm_body: mass (kg), inertia (xx, yy, zz, xy, xz, yz, kg m^2), attitude q (w, x, y, z; zeros are no rotation),
    position r (m), velocity v (m/s), angular velocity omega (rad/s, inertial axes). What is not given is 0."""
    _fields_ = [("mass", _real), ("inertia", _real * 6), ("q", _real * 4), ("r", _real * 3), ("v", _real * 3),
                ("omega", _real * 3)]

    def kinetic_energy(self):
        return _kit.vm_kinetic_energy(ctypes.byref(self))


def separate(whole, part):
    """What is left of a body after a part separates in an instant"""
    rest = Body()
    _check(_kit.vm_separate(ctypes.byref(whole), ctypes.byref(part), None, ctypes.byref(rest)), _kit.vm_strerror)
    return rest


def attach(body, added):
    """The body that two bodies are after an instant of plastic impact"""
    whole = Body()
    _check(_kit.vm_attach(ctypes.byref(body), ctypes.byref(added), None, ctypes.byref(whole)), _kit.vm_strerror)
    return whole


def rotation(body, times):
    """A body on which no torque acts, at the given times (s), exact: a list of bodies"""
    later = (Body * len(times))()
    _check(_kit.py_rotation(ctypes.byref(body), len(times), (_real * len(times))(*times), later), _kit.vm_strerror)
    return list(later)


Motion = collections.namedtuple("Motion", "x v amplitude error route")


class Oscillator(ctypes.Structure):
    """An oscillator with the spring's force k x|x|^(alpha-1), as vm_osc_problem describes it. mass (kg) and stiffness
    are numbers, or pairs of the value at t = 0 and the rate per second; x (m) and v (m/s) are the motion at t = 0."""
    _fields_ = [("alpha", _real), ("mass", _real * 2), ("stiffness", _real * 2), ("reactive", _real),
                ("damping", _real), ("x", _real), ("v", _real)]

    def __init__(self, alpha, mass, stiffness, reactive=0, damping=0, x=0, v=0):
        laws = [law if _is_sequence(law) else (law, 0) for law in (mass, stiffness)]
        super().__init__(alpha, *(tuple(law) for law in laws), reactive, damping, x, v)

    def at(self, t, tolerance=0, route=-1):
        """The motion at t, which is a time (s), a list or an array. By default the cheapest route is taken that keeps
        the tolerance (0 means 1e-6); route asks for one by its number VM_ROUTE_..."""
        (times,), back = _spread(t)
        n = len(times)
        out = [(_real * n)() for _ in range(4)] + [(ctypes.c_int * n)()]
        _check(_kit.py_oscillator(ctypes.byref(self), route, _real(tolerance), n, times, *out), _kit.vm_strerror)
        return Motion(*(back(o) for o in out))

    def seconds(self, t, tolerance=0, route=-1):
        """How long C code takes for the motion at one time t, s, from a plan that has been made"""
        return _kit.py_seconds(ctypes.byref(self), route, _real(t), _real(tolerance))


def route_name(route):
    return _kit.vm_osc_route_name(route).decode()


def solve(f, y0, times, rtol=1e-9, atol=0):
    """The solution of y' = f(t, y) by rk87 at the given times: a list of states, or a NumPy array with a row for each
    time. y0 belongs to times[0]. f returns the derivatives; its exception ends the run and is raised again. atol = 0
    means rtol/1000."""
    n, failure = len(y0), []

    @ctypes.CFUNCTYPE(ctypes.c_int, _real, ctypes.POINTER(_real), ctypes.POINTER(_real), ctypes.c_void_p)
    def rhs(t, y, dydt, _):
        try:
            derivatives = list(f(t, y[:n]))
            if len(derivatives) != n:
                raise ValueError(f"{len(derivatives)} derivatives of {n} numbers")
            for i in range(n):
                dydt[i] = derivatives[i]
        except Exception as error:
            failure.append(error)
        return len(failure)

    rows = (_real * (n * len(times)))()
    work = (_real * _kit.py_work(n))()
    status = _kit.py_solve(rhs, n, _real(rtol), _real(atol), (_real * n)(*y0), len(times), (_real * len(times))(*times),
                           rows, work)
    if failure:
        raise failure[0]
    _check(status, _kit.ode_strerror)
    states = [rows[k * n:k * n + n] for k in range(len(times))]
    return states if numpy is None else numpy.array(states)
