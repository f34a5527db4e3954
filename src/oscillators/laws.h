/* oscillators/laws.h - laws of mass, stiffness and damping: numbers that depend on time */
#ifndef VARMASS_OSCILLATORS_LAWS_H
#define VARMASS_OSCILLATORS_LAWS_H

#include "../ateb/phase.h"
#include "../base/elementary.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"

/* How a mass or a stiffness depends on time: positive between 0 and the times that are asked for. The value at t = 0
   is f0, but for tables and functions. A table is interpolated monotonically, by cubics with Fritsch and Butland's
   slopes; times rise, and t must lie between the first and the last.
   A function is evaluated at 20 points in each panel of time. A panel is at most |t|/32 long, and is halved where
   the function changes fast. So a bump exp(-(time/w)^2) is found if w > |t|/3000 (float |t|/2000). If the law
   changes in a shorter time, set change_time to that time, s: then no panel and no step of an integrator is longer.
   0 means unknown. */
typedef int (*vm_law_function)(vm_real t, vm_real *f, vm_real *rate, void *ctx); /* f(t), df/dt; 0 or failure */

enum {
    VM_LAW_LINEAR = 0,      /* f0 + f1 t (346); constant where f1 = 0 */
    VM_LAW_QUADRATIC = 1,   /* f0 + f1 t + f2 t^2 */
    VM_LAW_EXPONENTIAL = 2, /* f0 exp(f1 t) */
    VM_LAW_POWER = 3,       /* f0 (1 + f1 t)^f2 */
    VM_LAW_TABLE = 4,       /* the points (time[i], value[i]), 0 <= i < n, n >= 2 */
    VM_LAW_FUNCTION = 5     /* function(t, ., ., ctx), smooth */
};

typedef struct VM_TAG(vm_law) {
    int kind;
    vm_real f0, f1, f2;
    int n;
    const vm_real *time, *value;
    vm_law_function function;
    void *ctx;
    vm_real change_time; /* of a function: the shortest time, s, in which it changes; 0: unknown */
} vm_law;

/* -- Laws of mass and stiffness -- */
VM_API vm_law vmi_law_of(int kind, vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law;
    law.kind = kind;
    law.f0 = f0;
    law.f1 = f1;
    law.f2 = f2;
    law.n = 0;
    law.time = law.value = NULL;
    law.function = NULL;
    law.ctx = NULL;
    law.change_time = 0;
    return law;
}

VM_API vm_law vm_law_linear(vm_real f0, vm_real f1) { return vmi_law_of(VM_LAW_LINEAR, f0, f1, 0); }

VM_API vm_law vm_law_quadratic(vm_real f0, vm_real f1, vm_real f2)
{
    return vmi_law_of(VM_LAW_QUADRATIC, f0, f1, f2);
}

VM_API vm_law vm_law_exponential(vm_real f0, vm_real f1) { return vmi_law_of(VM_LAW_EXPONENTIAL, f0, f1, 0); }
VM_API vm_law vm_law_power(vm_real f0, vm_real f1, vm_real f2) { return vmi_law_of(VM_LAW_POWER, f0, f1, f2); }

VM_API vm_law vm_law_table(int n, const vm_real *time, const vm_real *value)
{
    vm_law law = vmi_law_of(VM_LAW_TABLE, 0, 0, 0);
    law.n = n;
    law.time = time;
    law.value = value;
    return law;
}

VM_API vm_law vm_law_user(vm_law_function function, void *ctx)
{
    vm_law law = vmi_law_of(VM_LAW_FUNCTION, 0, 0, 0);
    law.function = function;
    law.ctx = ctx;
    return law;
}

/* Slope at point i of a table: the harmonic mean of the chords beside it, weighted (Fritsch and Butland); at the ends
   that of the parabola through three points, held back so that the cubic stays monotone */
VM_API vm_real vmi_law_slope(const vm_law *law, int i)
{
    const vm_real *t = law->time, *f = law->value;
    const int last = law->n - 1, end = i == 0 || i == last, j = i == 0 ? 1 : i == last ? last - 1 : i;
    vm_real h0, h1, d0, d1, slope;
    if (last == 1) return (f[1] - f[0]) / (t[1] - t[0]);
    h0 = t[j] - t[j - 1];
    h1 = t[j + 1] - t[j];
    d0 = (f[j] - f[j - 1]) / h0;
    d1 = (f[j + 1] - f[j]) / h1;
    if (!end) return d0 * d1 <= 0 ? 0 : 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
    if (i == last) {
        slope = h0;
        h0 = h1;
        h1 = slope;
        slope = d0;
        d0 = d1;
        d1 = slope;
    }
    slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0) return 0;
    return d0 * d1 < 0 && VM_FABS(slope) > 3 * VM_FABS(d0) ? 3 * d0 : slope;
}

/* i of the interval time[i] .. time[i+1] with t in it; where t is a point, the interval on that side of it */
VM_API int vmi_law_interval(const vm_law *law, vm_real t, int side)
{
    int low = 0, high = law->n - 1;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (t > law->time[middle] || (t == law->time[middle] && side > 0)) low = middle;
        else high = middle;
    }
    return low;
}

VM_API int vmi_law_from_table(const vm_law *law, vm_real t, int side, vm_real *f)
{
    vm_real h, u, d, s0, s1, b, c;
    int i;
    if (law->n < 2 || !law->time || !law->value || !(t >= law->time[0] && t <= law->time[law->n - 1]))
        return VM_BAD_ARGUMENT;
    i = vmi_law_interval(law, t, side);
    h = law->time[i + 1] - law->time[i];
    u = t - law->time[i];
    d = (law->value[i + 1] - law->value[i]) / h;
    s0 = vmi_law_slope(law, i);
    s1 = vmi_law_slope(law, i + 1);
    b = (3 * d - 2 * s0 - s1) / h;
    c = (s0 + s1 - 2 * d) / (h * h);
    f[0] = law->value[i] + u * (s0 + u * (b + u * c));
    f[1] = s0 + u * (2 * b + 3 * u * c);
    f[2] = 2 * b + 6 * u * c;
    f[3] = 6 * c;
    return VM_OK;
}

/* The second derivative of a user's function, of second order from values at t, t + step, t + 2 step */
VM_API int vmi_law_from_function(const vm_law *law, vm_real t, vm_real step, vm_real *f)
{
    vm_real unused, rate[2];
    int i;
    f[2] = 0;
    if (!law->function || law->function(t, f, f + 1, law->ctx)) return VM_BAD_ARGUMENT;
    if (step == 0) return VM_OK;
    for (i = 0; i < 2; i++)
        if (law->function(t + (vm_real)(i + 1) * step, &unused, rate + i, law->ctx)) return VM_BAD_ARGUMENT;
    f[2] = (4 * (rate[0] - f[1]) - (rate[1] - f[1])) / (2 * step);
    return VM_OK;
}

/* f, f', f'' at t, the last on that side of t where it jumps; step as above, 0 where f'' of functions is not wanted.
   f''' where it is more than changes of f'' in the time of changes of f: in tables, else 0 */
VM_API int vmi_law_derivatives(const vm_law *law, vm_real t, int side, vm_real step, vm_real *f)
{
    int status = VM_OK;
    f[3] = 0;
    switch (law->kind) {
    case VM_LAW_LINEAR:
        f[0] = law->f0 + law->f1 * t;
        f[1] = law->f1;
        f[2] = 0;
        break;
    case VM_LAW_QUADRATIC:
        f[0] = law->f0 + t * (law->f1 + t * law->f2);
        f[1] = law->f1 + 2 * law->f2 * t;
        f[2] = 2 * law->f2;
        break;
    case VM_LAW_EXPONENTIAL:
        f[0] = law->f0 * vmi_exp(law->f1 * t, 0);
        f[1] = law->f1 * f[0];
        f[2] = law->f1 * f[1];
        break;
    case VM_LAW_POWER: {
        const vm_real base = 1 + law->f1 * t, c = law->f1 / base;
        f[0] = law->f0 * vmi_pow_checked(base, law->f2);
        f[1] = law->f2 * c * f[0];
        f[2] = (law->f2 - 1) * c * f[1];
        if (!(base > 0)) return VM_BAD_MASS;
        break;
    }
    case VM_LAW_TABLE: status = vmi_law_from_table(law, t, side, f); break;
    case VM_LAW_FUNCTION: status = vmi_law_from_function(law, t, step, f); break;
    default: return VM_BAD_ARGUMENT;
    }
    if (status) return status;
    if (!VM_IS_FINITE(f[0]) || !VM_IS_FINITE(f[1]) || !VM_IS_FINITE(f[2])) return VM_NOT_FINITE;
    return f[0] > 0 ? VM_OK : VM_BAD_MASS;
}

/* f(t), its rate, and the integral from 0 to t of ds/f: closed forms within some 8 ulp, also where they tend to 0/0;
   of tables and functions by integration, to 1e-13 (float 1e-5) if no change is faster than said above. VM_BAD_MASS
   where f <= 0 at t (the integral: anywhere between), VM_BAD_ARGUMENT outside a table, where the function fails, or where
   change_time is negative or less than |t|/2^20. */
VM_API int vm_law_at(const vm_law *law, vm_real t, vm_real *f, vm_real *rate)
{
    vm_real values[4];
    int status;
    if (!law || !f || !rate) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_derivatives(law, t, 1, 0, values);
    if (status) return status;
    *f = values[0];
    *rate = values[1];
    return VM_OK;
}

#define VMI_LAW_MOST_CHANGES VM_C(1048576.) /* change_times of a run: every call ends */

/* Is the law positive between 0 and t, as far as can be told without going there? Tables: all of it, and in order */
VM_API int vmi_law_check(const vm_law *law, vm_real t)
{
    vm_real f[4];
    int i, status = vmi_law_derivatives(law, 0, 1, 0, f);
    if (!status) status = vmi_law_derivatives(law, t, 1, 0, f);
    if (status) return status;
    if (law->kind == VM_LAW_FUNCTION) {
        if (!VM_IS_FINITE(law->change_time)) return VM_NOT_FINITE;
        if (law->change_time < 0 || VM_FABS(t) > law->change_time * VMI_LAW_MOST_CHANGES)
            return law->change_time == 0 ? VM_OK : VM_BAD_ARGUMENT;
    }
    if (law->kind == VM_LAW_QUADRATIC && law->f2 > 0) {
        const vm_real lowest = -law->f1 / (2 * law->f2);
        if (lowest * t > 0 && VM_FABS(lowest) < VM_FABS(t)) return vmi_law_derivatives(law, lowest, 1, 0, f);
    }
    if (law->kind == VM_LAW_TABLE)
        for (i = 0; i < law->n; i++) {
            if (!VM_IS_FINITE(law->value[i]) || !VM_IS_FINITE(law->time[i])) return VM_NOT_FINITE;
            if (!(law->value[i] > 0)) return VM_BAD_MASS;
            if (i > 0 && !(law->time[i] > law->time[i - 1])) return VM_BAD_ARGUMENT;
        }
    return VM_OK;
}

/* Laws that are f0 exp(rate u), u = ln(1 + base t)/base (t where base = 0): 1 and base, rate; constants have rate 0.
   A quadratic one is, where it is a square within rounding. */
VM_API int vmi_law_base(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = *rate = 0;
    switch (law->kind) {
    case VM_LAW_LINEAR: *base = *rate = law->f1 / law->f0; return 1;
    case VM_LAW_EXPONENTIAL: *rate = law->f1; return 1;
    case VM_LAW_POWER:
        *base = law->f1;
        *rate = law->f1 * law->f2;
        return 1;
    case VM_LAW_QUADRATIC: {
        const vm_real square = law->f1 * law->f1, rest = square - 4 * law->f0 * law->f2;
        *rate = law->f1 / law->f0;
        *base = *rate / 2;
        return VM_FABS(rest) <= 4 * VM_EPSILON * square;
    }
    default: return 0;
    }
}

/* int_0^t dt/(f0 + f1 t + f2 t^2) = (2/y) atanh(y t/x) or (2/y) atan(y t/x), x = 2 f0 + f1 t, y^2 = +-(f1^2 - 4 f0
   f2) */
VM_API vm_real vmi_law_quadratic_integral(const vm_law *law, vm_real t)
{
    const vm_real D = law->f1 * law->f1 - 4 * law->f0 * law->f2, x = 2 * law->f0 + law->f1 * t;
    const vm_real y = VM_SQRT(VM_FABS(D)) * VM_FABS(t), s = y / x;
    if (D < 0 && y > 0) return 2 * t / y * ateb_phase(y, x, 1);
    return 2 * t / x * vmi_log_ratio(2 * s / (1 - s)) / (1 - s);
}

/* The next point of a table after t on the way to t_end, or t_end */
VM_API vm_real vmi_law_next_knot(const vm_law *law, vm_real t, vm_real t_end)
{
    const int side = t_end > t ? 1 : -1;
    vm_real knot;
    int i;
    if (law->kind != VM_LAW_TABLE) return t_end;
    i = vmi_law_interval(law, t, side);
    knot = law->time[side > 0 ? i + 1 : i];
    return (t_end - knot) * (vm_real)side > 0 ? knot : t_end;
}

/* The longest panel in which a law cannot hide a change */
VM_API vm_real vmi_law_longest_panel(const vm_law *law, vm_real whole)
{
    vm_real longest = whole / 32;
    if (law->kind != VM_LAW_FUNCTION) return whole;
    return law->change_time > 0 && law->change_time < longest ? law->change_time : longest;
}

#endif
