/* motion_reference.h - the oscillator m x'' + k x|x|^(alpha-1) = -(r m' + b) x' + F by extrapolation, for reference.

   It shares no code with the headers at the top. REAL is the type of all numbers; include what defines it and
   REAL_POW, REAL_EXP, REAL_SIN, REAL_COS, REAL_TANH, REAL_SQRT, REAL_FABS first. alpha is a fraction, top/bottom.

   Unknowns are x and P = m^r x', whose equation P' = m^(r-1) (-k x|x|^(alpha-1) - b x' + F) has no m'. Far from x = 0
   they are integrated over t. Near x = 0, where the force has no derivatives, x = X sigma^bottom is the variable and t
   and P are the unknowns: both are analytic in sigma on each side of 0. Every step is Gragg's midpoint rule, extrapolated
   until two columns agree within the tolerance. No step crosses x = 0, a point of a table, or a stop that a law asks for. */
#ifndef MOTION_REFERENCE_H
#define MOTION_REFERENCE_H

enum { REF_LINEAR, REF_QUADRATIC, REF_EXPONENTIAL, REF_POWER, REF_TABLE, REF_SINE, REF_FILL, REF_BUMP, REF_KINDS };
enum { REF_NO_FORCE, REF_SPRING, REF_CUBE, REF_VAN_DER_POL, REF_DRAG, REF_COSINE, REF_FORCES };

typedef struct ref_law {
    int kind;
    double a, b, c, d; /* SINE: 1 + a sin(b t + c); FILL: 1 + a (1 + tanh((t-b)/c)); BUMP: 1 + a exp(-((t-b)/c)^2) */
    int n;
    const double *time, *value;
    int piece; /* of the table, where the motion is now */
} ref_law;

typedef struct ref_motion {
    int top, bottom;
    REAL alpha, r, damping;
    ref_law mass, stiffness;
    int force;
    double size, frequency;
    REAL t, x, P;
    REAL tolerance;
    REAL sign, X; /* of the sigma that is now the variable */
    long evals;
    int failed;
} ref_motion;

static REAL ref_slope(const ref_law *l, int i)
{
    const double *t = l->time, *f = l->value;
    const int last = l->n - 1;
    if (last == 1) return ((REAL)f[1] - f[0]) / ((REAL)t[1] - t[0]);
    if (i > 0 && i < last) {
        const REAL h0 = (REAL)t[i] - t[i - 1], h1 = (REAL)t[i + 1] - t[i];
        const REAL d0 = ((REAL)f[i] - f[i - 1]) / h0, d1 = ((REAL)f[i + 1] - f[i]) / h1;
        if (d0 * d1 <= 0) return 0;
        return 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
    } else {
        const int next = i == 0 ? 1 : last - 1, after = i == 0 ? 2 : last - 2;
        const REAL h0 = (REAL)t[next] - t[i], h1 = (REAL)t[after] - t[next];
        const REAL d0 = ((REAL)f[next] - f[i]) / h0, d1 = ((REAL)f[after] - f[next]) / h1;
        REAL s = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
        if (s * d0 <= 0) return 0;
        if (d0 * d1 < 0 && REAL_FABS(s) > 3 * REAL_FABS(d0)) s = 3 * d0;
        return s;
    }
}

static REAL ref_law_at(const ref_law *l, REAL t)
{
    switch (l->kind) {
    case REF_LINEAR: return l->a + l->b * t;
    case REF_QUADRATIC: return l->a + t * (l->b + l->c * t);
    case REF_EXPONENTIAL: return l->a * REAL_EXP(l->b * t);
    case REF_POWER: return l->a * REAL_POW(1 + l->b * t, (REAL)l->c);
    case REF_SINE: return 1 + l->a * REAL_SIN(l->b * t + l->c);
    case REF_FILL: return 1 + l->a * (1 + REAL_TANH((t - l->b) / l->c));
    case REF_BUMP: return 1 + l->a * REAL_EXP(-((t - l->b) / l->c) * ((t - l->b) / l->c));
    default: {
        const int i = l->piece;
        const REAL h = (REAL)l->time[i + 1] - l->time[i], u = (t - l->time[i]) / h;
        const REAL s0 = ref_slope(l, i) * h, s1 = ref_slope(l, i + 1) * h;
        const REAL f0 = l->value[i], f1 = l->value[i + 1];
        return f0 * (1 + 2 * u) * (1 - u) * (1 - u) + s0 * u * (1 - u) * (1 - u) + f1 * u * u * (3 - 2 * u) -
               s1 * u * u * (1 - u);
    }
    }
}

/* The next place after t where no step may cross, at most stop */
static REAL ref_next(const ref_law *l, REAL t, REAL stop)
{
    int i;
    if (l->kind == REF_TABLE)
        for (i = 0; i < l->n; i++)
            if (l->time[i] > t && l->time[i] < stop) stop = l->time[i];
    if (l->kind == REF_FILL || l->kind == REF_BUMP)
        for (i = -24; i <= 24; i++) {
            const REAL at = l->b + l->c * (REAL)i;
            if (at > t && at < stop) stop = at;
        }
    return stop;
}

static void ref_choose_piece(ref_law *l, REAL middle)
{
    if (l->kind != REF_TABLE) return;
    for (l->piece = 0; l->piece < l->n - 2 && l->time[l->piece + 1] < middle;) l->piece++;
}

/* x^n; x|x|^(alpha-1) is (|x|^(1/bottom))^top */
static REAL ref_whole_power(REAL x, int n)
{
    REAL y = 1;
    for (; n > 0; n--) y *= x;
    return y;
}

/* M = m^r, x' and P' at a state */
static void ref_rates(ref_motion *o, REAL t, REAL x, REAL P, REAL elastic, REAL *v, REAL *P_rate)
{
    const REAL m = ref_law_at(&o->mass, t), k = ref_law_at(&o->stiffness, t);
    REAL M = m, F = 0;
    if (o->r == 0) M = 1;
    else if (o->r != 1) M = REAL_POW(m, o->r);
    o->evals++;
    *v = P / M;
    switch (o->force) {
    case REF_SPRING: F = -o->size * x; break;
    case REF_CUBE: F = -o->size * x * x * x; break;
    case REF_VAN_DER_POL: F = o->size * (1 - x * x) * *v; break;
    case REF_DRAG: F = -o->size * *v * *v * *v; break;
    case REF_COSINE: F = o->size * REAL_COS(o->frequency * t); break;
    default: break;
    }
    *P_rate = M / m * (-k * elastic - o->damping * *v + F);
}

/* y' over t (y = x, P) or over sigma (y = time since the leg began, P) */
static void ref_rhs(ref_motion *o, int over_sigma, REAL s, const REAL *y, REAL *dy)
{
    REAL v, P_rate;
    if (!over_sigma) {
        const REAL size = REAL_FABS(y[0]);
        const REAL elastic = o->bottom == 1 ? ref_whole_power(size, o->top) : REAL_POW(size, o->alpha);
        ref_rates(o, s, y[0], y[1], y[0] < 0 ? -elastic : elastic, &v, &P_rate);
        dy[0] = v;
        dy[1] = P_rate;
    } else {
        const REAL x = o->sign * o->X * ref_whole_power(s, o->bottom);
        const REAL elastic = o->sign * REAL_POW(o->X, o->alpha) * ref_whole_power(s, o->top);
        const REAL x_rate = o->sign * o->X * (REAL)o->bottom * ref_whole_power(s, o->bottom - 1);
        ref_rates(o, o->t + y[0], x, y[1], elastic, &v, &P_rate);
        dy[0] = x_rate / v;
        dy[1] = P_rate * dy[0];
    }
}

enum { REF_ROWS = 12 };
/* One extrapolated step; the row at which it converged, 0 for none */
static int ref_step(ref_motion *o, int over_sigma, REAL s, REAL h, const REAL *y, REAL *out)
{
    REAL table[REF_ROWS][2], f0[2];
    int row, i, k;
    ref_rhs(o, over_sigma, s, y, f0);
    for (row = 0; row < REF_ROWS; row++) {
        const int n = 2 * (row + 1);
        const REAL d = h / (REAL)n;
        REAL a[2], b[2], f[2], difference = 0;
        for (i = 0; i < 2; i++) {
            a[i] = y[i];
            b[i] = y[i] + d * f0[i];
        }
        for (k = 1; k < n; k++) {
            ref_rhs(o, over_sigma, s + (REAL)k * d, b, f);
            for (i = 0; i < 2; i++) {
                const REAL next = a[i] + 2 * d * f[i];
                a[i] = b[i];
                b[i] = next;
            }
        }
        for (i = 0; i < 2; i++) { /* table[k] holds column k of the row before, and then of this one */
            const REAL diagonal_before = row > 0 ? table[row - 1][i] : 0;
            REAL now = b[i];
            for (k = 1; k <= row; k++) {
                const REAL ratio = (REAL)(row + 1) / (REAL)(row + 1 - k);
                const REAL better = now + (now - table[k - 1][i]) / (ratio * ratio - 1);
                table[k - 1][i] = now;
                now = better;
            }
            table[row][i] = now;
            now = REAL_FABS(now - diagonal_before) / (1 + REAL_FABS(now));
            if (!(now <= difference)) difference = now;
        }
        if (row > 2 && difference <= o->tolerance) {
            out[0] = table[row][0];
            out[1] = table[row][1];
            return row + 1;
        }
        if (difference != difference) return 0;
    }
    return 0;
}

/* y over s from s0 to s1 in at least so many steps */
static void ref_over(ref_motion *o, int over_sigma, REAL s0, REAL s1, int least, REAL *y)
{
    REAL s = s0, h = (s1 - s0) / (REAL)least;
    int tries = 0;
    while (s != s1 && !o->failed) {
        REAL out[2];
        const int last = REAL_FABS(s1 - s) <= REAL_FABS(h) * (1 + 1e-12);
        const int row = ref_step(o, over_sigma, s, last ? s1 - s : h, y, out);
        if (!row) {
            h = (last ? s1 - s : h) / 2;
            if (++tries > 200 || REAL_FABS(h) < 1e-14 * REAL_FABS(s1 - s0)) o->failed = 1;
            continue;
        }
        y[0] = out[0];
        y[1] = out[1];
        s = last ? s1 : s + h;
        if (row >= 11) h /= (REAL)1.5;
    }
}

/* Amplitude of the present state, with m and k as they are */
static REAL ref_amplitude(ref_motion *o, REAL *v)
{
    const REAL m = ref_law_at(&o->mass, o->t), k = ref_law_at(&o->stiffness, o->t), n = o->alpha + 1;
    *v = o->P / REAL_POW(m, o->r);
    return REAL_POW(REAL_POW(REAL_FABS(o->x), n) + n / 2 * m / k * *v * *v, 1 / n);
}

/* One leg over sigma, to x = 0 or away from it as far as half the amplitude, but not beyond the time stop */
static void ref_sigma_leg(ref_motion *o, REAL A, REAL v, REAL stop)
{
    const REAL root = 1 / (REAL)o->bottom, start = REAL_FABS(o->x);
    const int away = o->x == 0 || (o->x > 0) == (v > 0);
    REAL y[2], from, to, least_x, most_x;
    int i;
    o->sign = o->x > 0 || (o->x == 0 && v > 0) ? 1 : -1;
    o->X = (REAL)0.55 * A;
    from = REAL_POW(start / o->X, root);
    to = away ? 1 : 0;
    y[0] = 0;
    y[1] = o->P;
    ref_over(o, 1, from, to, 4, y);
    least_x = start;
    most_x = to * o->X;
    if (y[0] > stop - o->t) {
        REAL goal = start + (most_x - least_x) * (stop - o->t) / y[0];
        for (i = 0; i < 40; i++) {
            REAL slip, M;
            to = REAL_POW(goal / o->X, root);
            y[0] = 0;
            y[1] = o->P;
            ref_over(o, 1, from, to, 4, y);
            slip = y[0] - (stop - o->t);
            if (REAL_FABS(slip) <= 64 * o->tolerance * (1 + y[0])) break;
            M = REAL_POW(ref_law_at(&o->mass, o->t + y[0]), o->r);
            goal -= REAL_FABS(y[1] / M) * (away ? slip : -slip);
            if (goal < 0) goal = 0;
        }
        if (i == 40) o->failed = 1;
        o->t = stop;
        o->x = o->sign * (to == 0 ? 0 : goal);
        o->P = y[1];
        return;
    }
    o->t += y[0];
    o->x = away ? o->sign * o->X : 0;
    o->P = y[1];
}

/* A step over t, not so long that x comes near 0 */
static void ref_t_leg(ref_motion *o, REAL A, REAL stop, REAL *step)
{
    const REAL sign = o->x < 0 ? -1 : 1;
    int i;
    for (i = 0; i < 60; i++) {
        REAL y[2], out[2];
        const REAL h = *step < stop - o->t ? *step : stop - o->t;
        int row;
        y[0] = o->x;
        y[1] = o->P;
        row = ref_step(o, 0, o->t, h, y, out);
        if (!row || out[0] * sign < (REAL)0.15 * A) {
            *step = h / 2;
            continue;
        }
        o->x = out[0];
        o->P = out[1];
        o->t = h == stop - o->t ? stop : o->t + h;
        if (row <= 8) *step *= (REAL)1.4;
        return;
    }
    o->failed = 1;
}

/* Follows the motion to t. It gives up where the amplitude has grown ten thousandfold: a limiting term of the wrong sign
   makes it infinite in finite time, and the steps before that time become shorter without end. */
static void ref_follow(ref_motion *o, REAL t)
{
    REAL step = 0.05, v_now, most = 1e4 * ref_amplitude(o, &v_now);
    while (o->t < t && !o->failed) {
        REAL stop = ref_next(&o->stiffness, o->t, ref_next(&o->mass, o->t, t)), v, A;
        ref_choose_piece(&o->mass, (o->t + stop) / 2);
        ref_choose_piece(&o->stiffness, (o->t + stop) / 2);
        while (o->t < stop && !o->failed) {
            A = ref_amplitude(o, &v);
            if (!(A < most)) o->failed = 1;
            else if (REAL_FABS(o->x) < (REAL)0.5 * A) ref_sigma_leg(o, A, v, stop);
            else ref_t_leg(o, A, stop, &step);
        }
    }
}
#endif
