#!/usr/bin/env python3
"""What accuracy costs: the time that one x(t) of an oscillator with a leaking mass takes by each route, and its error.
Prints a table and draws build/python/cost.svg.

usage: python3 examples/python/cost.py; needs a C compiler ($CC or cc) and nothing else"""
import math
import os

import varmass

TRAY = varmass.Oscillator(alpha=3, mass=(10, -0.1), stiffness=10000, x=0.1)
TIME = 30.0  # s, some thirteen vibrations
AVERAGED, INTEGRATED = range(7), range(7, 10)  # VM_ROUTE_TRIG to VM_ROUTE_ORDER5, VM_ROUTE_COLLOCATION to VM_ROUTE_RK87
MARKS = ["M0,-5L5,4H-5Z", "M-4,-4H4V4H-4Z", "M0,-5L5,0L0,5L-5,0Z"]  # for the routes that integrate
DOT = "M-4,0A4,4,0,1,0,4,0A4,4,0,1,0,-4,0Z"


def reference():
    """x at TIME by the equation of motion m x'' + k x^3 = 0, integrated as accurately as rk87 can. The load leaks
    out with the tray's own velocity, so that no reactive force stands in the equation."""
    def motion(t, y):
        return y[1], -10000 * y[0] ** 3 / (10 - 0.1 * t)
    return varmass.solve(motion, (0.1, 0), [0, TIME], rtol=1e-13, atol=1e-18)[-1][0]


def measured(route, tolerance, exact):
    """Error of x divided by the amplitude, and time in microseconds, of a route"""
    motion = TRAY.at(TIME, tolerance, route)
    return abs(motion.x - exact) / motion.amplitude, 1e6 * TRAY.seconds(TIME, tolerance, route)


def curves():
    """The name of each route and its points (error, time): one point, or one for each tolerance of an integration"""
    exact = reference()
    for route in AVERAGED:
        yield varmass.route_name(route), [measured(route, 0, exact)]
    for route in INTEGRATED:
        yield varmass.route_name(route), [measured(route, 10.0**-k, exact) for k in range(3, 12)]


def place(error, time):
    """A point of the drawing, on logarithmic scales: errors from 1 to 1e-14 to the right, times from 0.1 µs up"""
    return 70 - 40 * math.log10(max(error, 1e-14)), 350 - 53 * (math.log10(time) + 1)


def svg(routes):
    out = ['<svg xmlns="http://www.w3.org/2000/svg" width="800" height="410" font-family="sans-serif" font-size="13">',
           '<rect width="800" height="410" fill="white"/>']
    for k in range(0, 15, 2):
        x, y = place(10.0**-k, 0.1)
        out.append(f'<path d="M{x:.0f},{y:.0f}V30" stroke="#ddd"/>')
        out.append(f'<text x="{x:.0f}" y="{y + 18:.0f}" text-anchor="middle">{10.0**-k:g}</text>')
    for k in range(-1, 6):
        x, y = place(1, 10.0**k)
        out.append(f'<path d="M{x:.0f},{y:.0f}H630" stroke="#ddd"/>')
        out.append(f'<text x="{x - 8:.0f}" y="{y + 4:.0f}" text-anchor="end">{10**k:g}</text>')
    out.append('<text x="350" y="395" text-anchor="middle">error of x(30 s), divided by the amplitude</text>'
               '<text x="18" y="190" text-anchor="middle" transform="rotate(-90 18 190)">time of a call, µs</text>')
    for number, (name, points) in enumerate(routes):
        mark = DOT if len(points) == 1 else MARKS[number - len(AVERAGED)]
        at = [place(*p) for p in points]
        out.append('<path d="M%s" fill="none" stroke="black"/>' % "L".join(f"{x:.1f},{y:.1f}" for x, y in at))
        out += [f'<path d="{mark}" transform="translate({x:.1f} {y:.1f})"/>' for x, y in at]
        slope = -40 if len(points) == 1 else 0  # the laws lie next to each other
        out.append('<text x="9" y="4" transform="translate(%.1f %.1f) rotate(%d)">%s</text>' % (*at[-1], slope, name))
    return "\n".join(out + ["</svg>\n"])


def main():
    routes = list(curves())
    print(f"{'route':24}{'error':>10}{'time, µs':>12}")
    for name, points in routes:
        for error, time in points:
            print(f"{name:24}{error:10.1e}{time:12.2f}")
    path = os.path.join(varmass.BUILD, "cost.svg")
    with open(path, "w", encoding="utf-8") as file:
        file.write(svg(routes))
    print("drawn:", os.path.normpath(path))


main()
