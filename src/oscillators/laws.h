/* oscillators/laws.h - laws of time for mass, stiffness and other numbers

   A vm_law describes a number f(t) that depends on time: the mass of a body (kg), the stiffness of its spring
   (N/m^alpha), or the frequency (1/s) and the size (N) of a force on it (oscillators/forced.h). There is a constructor
   for each kind of law: linear f0 + f1 t (equation (346) of the dissertation), quadratic, exponential, power, the
   points of a table, or a function of the user. The shortest useful call:
       vm_law mass = vm_law_linear(10, VM_C(-0.1)); // 10 kg, of which 0.1 kg leaks out per second
       vm_real m, rate;
       int status = vm_law_at(&mass, 20, &m, &rate); // 8 kg, -0.1 kg/s
   Each kind of law has a section below, with its own functions and with the constructor that makes a vm_law point to
   these functions. Nearly all other code is the same for all kinds of laws. vm_law_inverse_integral
   (oscillators/panels.h) integrates 1/f from 0 to t.
   Tests: tests/test_laws.c. */
#ifndef VARMASS_OSCILLATORS_LAWS_H
#define VARMASS_OSCILLATORS_LAWS_H

#include "../ateb/phase.h"
#include "../base/arrays.h"
#include "../base/elementary.h"
#include "../base/power_of_two.h"
#include "../base/real.h"
#include "../base/scalars.h"
#include "../base/status.h"
#include "legendre.h"

/* A user's function for a law: writes f(t) and its rate df/dt, and returns 0, or another number where it fails. f must
   be smooth. */
typedef int (*vm_law_function)(vm_real t, vm_real *f, vm_real *rate, void *ctx);

/* The law of a mass, a stiffness or another number f(t). The constructors vm_law_linear, vm_law_table ... fill it;
   only change_time may be set by hand. The law points to the arrays of its table, to the user's function and to the
   data at ctx; these must exist as long as the law is used. The law also points to functions of this header, so on a
   GPU the constructor must be called on the GPU. */
typedef struct VM_TAG(vm_law) vm_law;
struct VM_TAG(vm_law) {
    vm_real f0, f1, f2;       /* arguments of the constructor, in their order; 0 for tables and functions */
    int n;                    /* number of points of a table; 0 for the other laws */
    const vm_real *time;      /* n times of a table, s, rising; else null */
    const vm_real *value;     /* n values of a table, in the unit of f; else null */
    vm_law_function function; /* the user's function for vm_law_user; else null */
    void *ctx;                /* the user's pointer, last argument of this function */
    vm_real change_time;      /* for vm_law_user only: the shortest time scale, s, on which f changes noticeably; 0 if
                                 it is unknown */
    /* Functions that depend on the kind of law; its constructor sets them. `derivatives` is null where no constructor
       made the law. `validate` checks the law between 0 and t; if it is null, only f(0) and f(t) are checked. */
    int (*derivatives)(const vm_law *law, vm_real t, int side, vm_real length, vm_real unit, vm_real *f);
    int (*validate)(const vm_law *law, int if_not_positive, vm_real t);
    int (*exponential_form)(const vm_law *law, vm_real *base, vm_real *rate); /* null if there is no exponential form */
    vm_real (*inverse_integral)(const vm_law *law, vm_real t);                /* null if there is no closed form */
};

/* -- What every kind of law shares -- */

/* The direction of an interval of time: 1 forward if its length is positive or 0, -1 backward if it is negative */
VM_API int vmi_time_side(vm_real length) { return length < 0 ? -1 : 1; }

/* The number of values that the function `derivatives` of a law writes: f and its first six derivatives, to f[0] ...
   f[6]. The derivative of order i is multiplied by the ith power of the time `unit`. */
enum { VMI_LAW_ORDERS = 7 };

/* Returns the final status of a law: its function `derivatives` returned `status` and wrote numbers to f, of which the
   first n are checked here. The argument if_not_positive is explained at vmi_law_derivatives. */
VM_API int vmi_law_status(int status, int if_not_positive, int n, const vm_real *f)
{
    vm_real sum = 0; /* sum of f[i] - f[i], which is 0, or NaN if a number is infinite or NaN */
    int i;
    if (status == VM_BAD_MASS) return if_not_positive ? if_not_positive : (int)VM_DOMAIN;
    if (status) return status;
    for (i = 0; i < n; i++) sum += f[i] - f[i];
    if (!(sum == 0)) return VM_NOT_FINITE;
    if (if_not_positive && !(f[0] > 0)) return if_not_positive;
    return VM_OK;
}

/* Writes the value of a law and its derivatives at t, multiplied by powers of `unit`, s: f to f[0], f' unit to f[1],
   f'' unit^2 to f[2] ... A constructor must have made the law. Where a derivative jumps at t, its value after t is
   written for side = 1, its value before t for side = -1. With length = 0 only f[0] and f[1] are written; with a
   positive length, s, all seven numbers. For a user's function the higher derivatives are found from the rates that the
   function returns between t and t + side length. if_not_positive is the status that is returned for f <= 0, for
   example VM_BAD_MASS for a mass; it is VM_OK where f may have any sign. */
VM_API int vmi_law_scaled_derivatives(const vm_law *law, int if_not_positive, vm_real t, int side, vm_real length,
                                      vm_real unit, vm_real *f)
{
    const int orders = length > 0 ? VMI_LAW_ORDERS : 2;
    int i;
    for (i = 2; i < orders; i++) f[i] = 0;
    return vmi_law_status(law->derivatives(law, t, side, length, unit, f), if_not_positive, orders, f);
}

/* Does what vmi_law_scaled_derivatives does, with a unit of 1 s. */
VM_API int vmi_law_derivatives(const vm_law *law, int if_not_positive, vm_real t, int side, vm_real length, vm_real *f)
{
    return vmi_law_scaled_derivatives(law, if_not_positive, t, side, length, 1, f);
}

/* Returns the unit, s, for the derivatives of the laws of an oscillator whose phase grows by about 1 in `time`. It is a
   power of two, so that it causes no rounding errors. The sixth derivative of a law that changes within 1e-8 s
   overflows in float, but its product with unit^6 does not. Derivatives of slower laws do not overflow, so that the
   unit need not be longer than 1 s. */
VM_API vm_real vmi_law_unit(vm_real time) { return vmi_smaller(vmi_power_below(time), 1); }

/* Does what vmi_law_derivatives does, but only f, f' and f'' are valid and checked. This function must not be called
   for a law made by vm_law_user. */
VM_API int vmi_law_two_derivatives(const vm_law *law, int if_not_positive, vm_real t, int side, vm_real *f)
{
    const vm_real length = 1; /* 1 s; with any positive length f'' is written */
    f[2] = 0;
    return vmi_law_status(law->derivatives(law, t, side, length, 1, f), if_not_positive, 3, f);
}

/* Checks that a constructor made the law, and that the law is finite and positive between 0 and t. Of a user's function
   only the values at 0 and t are checked; a table is checked as a whole. With if_not_positive = VM_OK the law may have
   any sign. */
VM_API int vmi_law_check(const vm_law *law, int if_not_positive, vm_real t)
{
    vm_real f[VMI_LAW_ORDERS];
    int status;
    if (!law->derivatives) return VM_BAD_ARGUMENT;
    status = vmi_law_derivatives(law, if_not_positive, 0, 1, 0, f);
    status = vmi_first_error(status, vmi_law_derivatives(law, if_not_positive, t, 1, 0, f));
    if (law->validate) {
        const int invalid = law->validate(law, if_not_positive, t);
        if (invalid == VM_DOMAIN && law->time) return invalid; /* where times do not rise, the value at t may be NaN */
        status = vmi_first_error(status, invalid);
    }
    return status;
}

/* Returns 1 and writes base and rate if the law is f0 exp(rate u) with u = ln(1 + base t)/base (u = t for base = 0);
   returns 0 otherwise. This form is useful because integrals over t of products of such laws have closed forms if all
   these laws have the same base. A constant has rate 0. */
VM_API int vmi_law_exponential_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = *rate = 0;
    return law->exponential_form && law->exponential_form(law, base, rate);
}

/* The integral of dt/f from 0 to t for a law f with an exponential form */
VM_API vm_real vmi_law_exponential_inverse_integral(const vm_law *law, vm_real t)
{
    vm_real base, rate, u;
    vmi_law_exponential_form(law, &base, &rate);
    u = t * vmi_log_ratio(base * t);
    return u / law->f0 * vmi_exp_ratio((base - rate) * u);
}

/* Writes f and df/dt of any law at t, after a check of all arguments. Both are NaN if the status is not VM_OK. */
VM_API int vmi_law_at(const vm_law *law, int if_not_positive, vm_real t, vm_real *f, vm_real *rate)
{
    vm_real values[VMI_LAW_ORDERS];
    int status;
    *f = *rate = VM_NAN;
    if (!law || !law->derivatives) return VM_BAD_ARGUMENT;
    if (!VM_IS_FINITE(t)) return VM_NOT_FINITE;
    status = vmi_law_derivatives(law, if_not_positive, t, 1, 0, values);
    if (status) return status;
    *f = values[0];
    *rate = values[1];
    return VM_OK;
}

/* Value f and rate df/dt of a law at time t (s), which may be negative. At the points of a table f is within 4 eps of
   the value in the table, where eps is the machine epsilon; at the last point it is within 8 eps of the larger of the
   last two |values|. f may have any sign, since the law need not be that of a mass. Returns VM_BAD_ARGUMENT for null
   pointers and for a law that no constructor made; VM_NOT_FINITE where t or a result is infinite or NaN; VM_DOMAIN for
   t outside a table, for a power law where 1 + f1 t <= 0, and where the user's function fails; VM_OK otherwise. An
   error leaves *f and *rate untouched. */
VM_API int vm_law_at(const vm_law *law, vm_real t, vm_real *f, vm_real *rate)
{
    vm_real value, slope;
    int status;
    if (!f || !rate) return VM_BAD_ARGUMENT;
    status = vmi_law_at(law, VM_OK, t, &value, &slope);
    if (status) return status;
    *f = value;
    *rate = slope;
    return VM_OK;
}

/* A law with the numbers f0, f1, f2, but without the functions of its kind, which the constructors below add */
VM_API vm_law vmi_law_of(vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law;
    law.f0 = f0;
    law.f1 = f1;
    law.f2 = f2;
    law.n = 0;
    law.time = NULL;
    law.value = NULL;
    law.function = NULL;
    law.ctx = NULL;
    law.change_time = 0;
    law.derivatives = NULL;
    law.validate = NULL;
    law.exponential_form = NULL;
    law.inverse_integral = NULL;
    return law;
}

/* -- Linear laws -- */

/* Writes f and f' of a linear law; its higher derivatives are 0. */
VM_API int vmi_law_linear_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real unit,
                                      vm_real *f)
{
    (void)side;
    (void)length;
    f[0] = law->f0 + law->f1 * t;
    f[1] = law->f1 * unit;
    return VM_OK;
}

/* The exponential form of a linear law: f0 (1 + base t) = f0 exp(base u) with u = ln(1 + base t)/base */
VM_API int vmi_law_linear_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = law->f1 / law->f0;
    *rate = *base;
    return 1;
}

/* The integral of dt/f from 0 to t for a linear law f = f0 + f1 t */
VM_API vm_real vmi_law_linear_inverse_integral(const vm_law *law, vm_real t)
{
    const vm_real x = law->f1 / law->f0 * t; /* f(t)/f0 - 1; it may round to -1 where f(t) is small, but positive */
    if (x < VM_C(-0.5)) return vmi_log((law->f0 + law->f1 * t) / law->f0).hi / law->f1;
    return t * vmi_log_ratio(x) / law->f0;
}

/* Linear law f = f0 + f1 t (346); a constant where f1 = 0. f0 is the value at t = 0, f1 the rate per second, for
   example in kg and kg/s. */
VM_API vm_law vm_law_linear(vm_real f0, vm_real f1)
{
    vm_law law = vmi_law_of(f0, f1, 0);
    law.derivatives = vmi_law_linear_derivatives;
    law.exponential_form = vmi_law_linear_form;
    law.inverse_integral = vmi_law_linear_inverse_integral;
    return law;
}

/* -- Quadratic laws -- */

/* Writes f, f' and f'' of a quadratic law; its higher derivatives are 0. */
VM_API int vmi_law_quadratic_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real unit,
                                         vm_real *f)
{
    (void)side;
    f[0] = law->f0 + t * (law->f1 + t * law->f2);
    f[1] = (law->f1 + 2 * law->f2 * t) * unit;
    if (length > 0) f[2] = 2 * law->f2 * unit * unit;
    return VM_OK;
}

/* Checks that f is positive at its minimum, if the minimum is between 0 and t. */
VM_API int vmi_law_quadratic_validate(const vm_law *law, int if_not_positive, vm_real t)
{
    vm_real f[VMI_LAW_ORDERS], lowest;
    if (!(law->f2 > 0)) return VM_OK;
    lowest = -law->f1 / (2 * law->f2);
    if (!((lowest > 0) == (t > 0) && VM_FABS(lowest) < VM_FABS(t))) return VM_OK;
    return vmi_law_derivatives(law, if_not_positive, lowest, 1, 0, f);
}

/* The exponential form of a quadratic law. This form exists only if the law is a square within rounding errors: f0 (1 +
   base t)^2 = f0 exp(2 base u) with u = ln(1 + base t)/base. Returns 1 if the form exists, else 0. The law is a square
   if f1^2 = 4 f0 f2. Powers of two scale the products in this equation, so that they neither overflow nor underflow. */
VM_API int vmi_law_quadratic_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    const vm_real size = vmi_power_below(law->f0), slope = vmi_power_below(VM_FABS(law->f1));
    const vm_real f1 = law->f1 / slope, square = f1 * f1;
    const vm_real rest = square - 4 * (law->f0 / size) * (law->f2 / slope * size / slope);
    *rate = law->f1 / law->f0;
    *base = *rate / 2;
    return VM_FABS(rest) <= 4 * VM_EPSILON * square;
}

/* The integral of dt/(f0 + f1 t + f2 t^2) from 0 to t. With x = 2 f0 + f1 t, D = f1^2 - 4 f0 f2 and d = sqrt|D| the
   integral is (2/d) atan(d t/x) for D < 0, and (2/d) atanh(d t/x) otherwise. It is computed for f and t in units that
   are powers of two, so that no product overflows or underflows. */
VM_API vm_real vmi_law_quadratic_inverse_integral(const vm_law *law, vm_real t)
{
    const vm_real size = vmi_power_below(law->f0), unit = vmi_power_below(VM_FABS(t)), way = t / unit;
    const vm_real f0 = law->f0 / size, f1 = law->f1 * unit / size, f2 = law->f2 * unit * unit / size;
    const vm_real D = f1 * f1 - 4 * f0 * f2, x = 2 * f0 + f1 * way;
    const vm_real y = VM_SQRT(VM_FABS(D)) * VM_FABS(way), s = y / x;
    if (D < 0 && y > 0) return 2 * way / y * ateb_phase(y, x, 1) * unit / size;
    return 2 * way / x * vmi_log_ratio(2 * s / (1 - s)) / (1 - s) * unit / size;
}

/* Quadratic law f = f0 + f1 t + f2 t^2. f0 has the unit of f, f1 this unit per second, f2 this unit per second
   squared. */
VM_API vm_law vm_law_quadratic(vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law = vmi_law_of(f0, f1, f2);
    law.derivatives = vmi_law_quadratic_derivatives;
    law.validate = vmi_law_quadratic_validate;
    law.exponential_form = vmi_law_quadratic_form;
    law.inverse_integral = vmi_law_quadratic_inverse_integral;
    return law;
}

/* -- Exponential laws -- */

/* Writes f and the derivatives of an exponential law. Each derivative is f1 unit times the one of one order lower. */
VM_API int vmi_law_exponential_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real unit,
                                           vm_real *f)
{
    const int orders = length > 0 ? VMI_LAW_ORDERS : 2;
    int i;
    (void)side;
    f[0] = law->f0 * vmi_exp(law->f1 * t, 0);
    for (i = 1; i < orders; i++) f[i] = law->f1 * unit * f[i - 1];
    return VM_OK;
}

/* The exponential form of an exponential law, with base = 0, so that u = t */
VM_API int vmi_law_exponential_own_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = 0;
    *rate = law->f1;
    return 1;
}

/* Exponential law f = f0 exp(f1 t). f0 is the value at t = 0, f1 the relative rate, 1/s. */
VM_API vm_law vm_law_exponential(vm_real f0, vm_real f1)
{
    vm_law law = vmi_law_of(f0, f1, 0);
    law.derivatives = vmi_law_exponential_derivatives;
    law.exponential_form = vmi_law_exponential_own_form;
    law.inverse_integral = vmi_law_exponential_inverse_integral;
    return law;
}

/* -- Power laws -- */

/* Writes f and the derivatives of a power law. Returns VM_BAD_MASS where 1 + f1 t is not positive, even if the law is
   not that of a mass. vmi_law_derivatives then replaces this status, for example by VM_BAD_STIFFNESS for a
   stiffness. */
VM_API int vmi_law_power_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real unit,
                                     vm_real *f)
{
    const vm_real base = 1 + law->f1 * t, relative_rate = law->f1 * unit / base;
    const int orders = length > 0 ? VMI_LAW_ORDERS : 2;
    int i;
    (void)side;
    if (base <= 0) return VM_BAD_MASS;
    f[0] = law->f0 * vmi_pow_checked(base, law->f2);
    for (i = 1; i < orders; i++) f[i] = (law->f2 - (vm_real)(i - 1)) * relative_rate * f[i - 1];
    return VM_OK;
}

/* The exponential form of a power law: f0 (1 + f1 t)^f2 = f0 exp(f2 f1 u) with base = f1 and u = ln(1 + f1 t)/f1 */
VM_API int vmi_law_power_form(const vm_law *law, vm_real *base, vm_real *rate)
{
    *base = law->f1;
    *rate = law->f1 * law->f2;
    return 1;
}

/* Power law f = f0 (1 + f1 t)^f2, for 1 + f1 t > 0. f0 is the value at t = 0, f1 a rate, 1/s, and f2 a pure number of
   either sign. */
VM_API vm_law vm_law_power(vm_real f0, vm_real f1, vm_real f2)
{
    vm_law law = vmi_law_of(f0, f1, f2);
    law.derivatives = vmi_law_power_derivatives;
    law.exponential_form = vmi_law_power_form;
    law.inverse_integral = vmi_law_exponential_inverse_integral;
    return law;
}

/* -- Tables -- */

/* Slope of the law at the first or last point of a table. It is the slope of the parabola through the three points at
   this end of the table. The slope is limited so that the cubic between the end and its neighbouring point stays
   monotone. A chord joins two neighbouring points of the table. h_end and d_end are the length in time and the slope of
   the chord at the end, h_next and d_next those of the chord next to it. */
VM_API vm_real vmi_law_end_slope(vm_real h_end, vm_real h_next, vm_real d_end, vm_real d_next)
{
    const vm_real slope = ((2 * h_end + h_next) * d_end - h_end * d_next) / (h_end + h_next);
    if (slope * d_end <= 0) return 0;
    if (d_end * d_next < 0 && VM_FABS(slope) > 3 * VM_FABS(d_end)) return 3 * d_end;
    return slope;
}

/* Slope of the law at point i of a table. A chord joins two neighbouring points of the table. At an inner point the
   slope is the weighted harmonic mean of the slopes of the two chords that meet there; at an extremum the slope is 0
   (Fritsch and Butland). */
VM_API vm_real vmi_law_slope(const vm_law *law, int i)
{
    const vm_real *t = law->time, *f = law->value;
    const int last = law->n - 1;
    int middle = i;
    vm_real h0, h1, d0, d1;
    if (last == 1) return (f[1] - f[0]) / (t[1] - t[0]);
    if (i == 0) middle = 1;
    if (i == last) middle = last - 1;
    h0 = t[middle] - t[middle - 1];
    h1 = t[middle + 1] - t[middle];
    d0 = (f[middle] - f[middle - 1]) / h0;
    d1 = (f[middle + 1] - f[middle]) / h1;
    if (i == 0) return vmi_law_end_slope(h0, h1, d0, d1);
    if (i == last) return vmi_law_end_slope(h1, h0, d1, d0);
    if (d0 * d1 <= 0) return 0;
    return 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
}

/* The index i with time[i] <= t <= time[i+1]. If t is a point of the table, the interval lies after t for side = 1 and
   before t for side = -1. */
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

/* Writes f and its derivatives at t. f is the cubic on the interval of the table that contains t. The cubic has the
   values and slopes of the two points at the ends of this interval. */
VM_API int vmi_law_table_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real unit,
                                     vm_real *f)
{
    vm_real chord_time, u, chord, slope0, slope1, b, c;
    int i;
    if (!(t >= law->time[0] && t <= law->time[law->n - 1]))
        return vmi_all_finite(law->n, law->time) ? VM_DOMAIN : VM_NOT_FINITE;
    i = vmi_law_interval(law, t, side);
    chord_time = law->time[i + 1] - law->time[i];
    u = t - law->time[i];
    chord = (law->value[i + 1] - law->value[i]) / chord_time;
    slope0 = vmi_law_slope(law, i);
    slope1 = vmi_law_slope(law, i + 1);
    b = (3 * chord - 2 * slope0 - slope1) / chord_time;
    c = (slope0 + slope1 - 2 * chord) / (chord_time * chord_time);
    f[0] = law->value[i] + u * (slope0 + u * (b + u * c));
    f[1] = (slope0 + u * (2 * b + 3 * u * c)) * unit;
    if (length > 0) {
        f[2] = (2 * b + 6 * u * c) * unit * unit;
        f[3] = 6 * c * unit * unit * unit;
    }
    return VM_OK;
}

/* Checks the whole table, for any t. Its times must be finite and must rise, and its values must be finite. If
   if_not_positive is not VM_OK, the values must also be positive. */
VM_API int vmi_law_table_validate(const vm_law *law, int if_not_positive, vm_real t)
{
    int i;
    (void)t;
    if (!vmi_all_finite(law->n, law->value) || !vmi_all_finite(law->n, law->time)) return VM_NOT_FINITE;
    for (i = 0; i < law->n; i++)
        if (if_not_positive && !(law->value[i] > 0)) return if_not_positive;
    for (i = 1; i < law->n; i++)
        if (!(law->time[i] > law->time[i - 1])) return VM_DOMAIN;
    return VM_OK;
}

/* Table of n >= 2 points (time[i], value[i]), joined by monotone cubics. For fewer points, or with a null pointer, the
   result is no law, and all functions refuse it with VM_BAD_ARGUMENT. Times (s) must rise, and every t of a call must
   lie between the first and the last. Between two points the law is a cubic with the slopes of Fritsch and Butland,
   which neither overshoots nor oscillates. The second derivative of the law jumps at the points of the table. */
VM_API vm_law vm_law_table(int n, const vm_real *time, const vm_real *value)
{
    vm_law law = vmi_law_of(0, 0, 0);
    law.n = n;
    law.time = time;
    law.value = value;
    if (n >= 2 && time && value) law.derivatives = vmi_law_table_derivatives; /* else there is no law */
    law.validate = vmi_law_table_validate;
    return law;
}

/* The next point of the law's table after t on the way to t_end, or t_end if there is no such point */
VM_API vm_real vmi_law_next_knot(const vm_law *law, vm_real t, vm_real t_end)
{
    const int side = t_end > t ? 1 : -1;
    vm_real knot;
    int i;
    if (!law->time) return t_end;
    i = vmi_law_interval(law, t, side);
    knot = law->time[side > 0 ? i + 1 : i];
    return (t_end - knot) * (vm_real)side > 0 ? knot : t_end;
}

/* Returns 1 if t is a point of the law's table, but not its first or last one, so that the second derivative may jump
   at t; else returns 0. */
VM_API int vmi_law_has_knot(const vm_law *law, vm_real t)
{
    return law->time && vmi_law_interval(law, t, 1) != vmi_law_interval(law, t, -1);
}

/* -- Functions of the user -- */

/* Writes the Legendre series of the rate f' between t and t + length. */
VM_API int vmi_law_user_fit(const vm_law *law, vm_real t, vm_real length, vm_real *series)
{
    vm_real rates[VMI_GAUSS], same[VMI_GAUSS], unused;
    int i;
    for (i = 0; i < VMI_GAUSS; i++) {
        const vm_real at = t + length * ((1 + vmi_gauss_node(i)) / 2);
        if (law->function(at, &unused, &rates[i], law->ctx)) return VM_DOMAIN;
    }
    vmi_legendre_fit(rates, rates, series, same);
    return VM_OK;
}

/* Writes the Legendre series of the rate f' between t and t + *length. The length is halved until the last terms of the
   series are only rounding errors. These terms count as rounding errors when they hardly become smaller if the length
   is halved again. All terms that are not larger than these rounding errors are set to 0. The length is also halved
   where the user's function fails, because the function may be defined only close to t. */
VM_API int vmi_law_user_series(const vm_law *law, vm_real t, vm_real *length, vm_real *series)
{
    const int most_halvings = 24;
    vm_real tail, least = 0;
    int i, halvings = 0, status = vmi_law_user_fit(law, t, *length, series);
    while (status && halvings < most_halvings) {
        *length /= 2;
        status = vmi_law_user_fit(law, t, *length, series);
        halvings++;
    }
    if (status) return status;
    for (; halvings < most_halvings; halvings++) {
        vm_real shorter[VMI_GAUSS];
        tail = vmi_legendre_tail(series);
        least = 64 * VM_EPSILON * VM_SQRT(vmi_legendre_square(series));
        if (!(tail > least)) break;
        least = 4 * tail;
        status = vmi_law_user_fit(law, t, *length / 2, shorter);
        if (status) return status;
        if (!(vmi_legendre_tail(shorter) < tail / 8)) break;
        *length /= 2;
        for (i = 0; i < VMI_GAUSS; i++) series[i] = shorter[i];
    }
    for (i = 0; i < VMI_GAUSS; i++)
        if (VM_FABS(series[i]) <= least) series[i] = 0;
    return VM_OK;
}

/* Writes f and f' from the user's function. For length > 0 it also writes the higher derivatives, from a Legendre
   series of f'. Within a very short length the rate changes only by rounding errors; the derivatives are then 0, even
   if the factor `scale` overflows. */
VM_API int vmi_law_user_derivatives(const vm_law *law, vm_real t, int side, vm_real length, vm_real unit,
                                    vm_real *f)
{
    vm_real series[VMI_GAUSS], whole = (vm_real)side * length, scale = unit;
    int i, k, status;
    if (law->function(t, &f[0], &f[1], law->ctx)) return VM_DOMAIN;
    f[1] *= unit;
    if (!(length > 0)) return VM_OK;
    status = vmi_law_user_series(law, t, &whole, series);
    if (status) return status;
    for (i = 2; i < VMI_LAW_ORDERS; i++) {
        vmi_legendre_derive(series);
        scale *= 2 * unit / whole;
        for (k = 0; k < VMI_GAUSS; k += 2) {
            const vm_real term = series[k] - series[k + 1]; /* P_k(-1) = (-1)^k */
            if (term != 0) f[i] += scale * term;
        }
    }
    return VM_OK;
}

/* Checks that change_time is 0, or finite and at least |t|/2^20, so that every call ends. */
VM_API int vmi_law_user_validate(const vm_law *law, int if_not_positive, vm_real t)
{
    const vm_real most_changes = VM_C(1048576.);
    (void)if_not_positive;
    if (!VM_IS_FINITE(law->change_time)) return VM_NOT_FINITE;
    if (law->change_time < 0) return VM_DOMAIN;
    if (law->change_time > 0 && VM_FABS(t) > law->change_time * most_changes) return VM_DOMAIN;
    return VM_OK;
}

/* Law by a user's function, which must be smooth. If `function` is null, the result is no law, and all functions refuse
   it with VM_BAD_ARGUMENT. The user's function receives ctx as its last argument. To integrate the law, the time from 0
   to t is divided into parts, called panels, and the function is evaluated at 20 points of each panel. A panel is at
   most |t|/32 long, and is halved where the function changes fast. So a bump exp(-(time/w)^2) is found if w > |t|/3000
   (float |t|/2000). If the law changes in a shorter time, set law.change_time to that time, s: then no panel, and no
   step of the routes rk45 and rk87, is longer than change_time, and no step of collocation is longer than twice this
   time. Scenes, and integrators that the user calls, do not read change_time. A change_time that is negative, or
   positive but less than |t|/2^20, is refused with VM_DOMAIN by the functions that compute an integral or a motion from
   0 to t. */
VM_API vm_law vm_law_user(vm_law_function function, void *ctx)
{
    vm_law law = vmi_law_of(0, 0, 0);
    law.function = function;
    law.ctx = ctx;
    if (function) law.derivatives = vmi_law_user_derivatives; /* else there is no law */
    law.validate = vmi_law_user_validate;
    return law;
}

/* The longest panel, s, for integrals of the law over the time from 0 to t. A panel is an interval of time; it is so
   short that the integration finds all changes that the comment at vm_law_user promises to find. `whole` is |t|. The
   result is not 0, even if `whole` is so small that whole/32 underflows. */
VM_API vm_real vmi_law_longest_panel(const vm_law *law, vm_real whole)
{
    const vm_real longest = vmi_larger(whole / 32, VM_MIN);
    if (!law->function) return whole;
    if (law->change_time > 0 && law->change_time < longest) return law->change_time;
    return longest;
}

#endif
