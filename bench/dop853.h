/* dop853.h - the pair of order 8 by Dormand and Prince with the error estimates and the step size control that SciPy's
   solve_ivp(method="DOP853") has: what rk87 is compared with. Coefficients: E. Hairer, S. P. Norsett, G. Wanner, Solving
   Ordinary Differential Equations I, 2nd ed., Springer 1993, II.10. */
#ifndef VARMASS_DOP853_H
#define VARMASS_DOP853_H

#include <math.h>

enum { DOP853_STAGES = 12, DOP853_LARGEST = 51 };

typedef int (*dop853_rhs)(double t, const double *y, double *dydt, void *ctx);

static const double dop853_c[DOP853_STAGES] = {0,
                                               0.526001519587677318785587544488e-01,
                                               0.789002279381515978178381316732e-01,
                                               0.118350341907227396726757197510e+00,
                                               0.281649658092772603273242802490e+00,
                                               0.333333333333333333333333333333e+00,
                                               0.25,
                                               0.307692307692307692307692307692e+00,
                                               0.651282051282051282051282051282e+00,
                                               0.6,
                                               0.857142857142857142857142857142e+00,
                                               1};

/* row i: the weights of stages 1 to i in the argument of stage i + 1; the last row: in the new state */
static const double dop853_a[DOP853_STAGES][DOP853_STAGES] = {
    {5.26001519587677318785587544488e-2},
    {1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2},
    {2.95875854768068491816892993775e-2, 0, 8.87627564304205475450678981324e-2},
    {2.41365134159266685502369798665e-1, 0, -8.84549479328286085344864962717e-1, 9.24834003261792003115737966543e-1},
    {3.7037037037037037037037037037e-2, 0, 0, 1.70828608729473871279604482173e-1, 1.25467687566822425016691814123e-1},
    {3.7109375e-2, 0, 0, 1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2, -1.7578125e-2},
    {3.70920001185047927108779319836e-2, 0, 0, 1.70383925712239993810214054705e-1,
     1.07262030446373284651809199168e-1, -1.53194377486244017527936158236e-2, 8.27378916381402288758473766002e-3},
    {6.24110958716075717114429577812e-1, 0, 0, -3.36089262944694129406857109825, -8.68219346841726006818189891453e-1,
     2.75920996994467083049415600797e1, 2.01540675504778934086186788979e1, -4.34898841810699588477366255144e1},
    {4.77662536438264365890433908527e-1, 0, 0, -2.48811461997166764192642586468, -5.90290826836842996371446475743e-1,
     2.12300514481811942347288949897e1, 1.52792336328824235832596922938e1, -3.32882109689848629194453265587e1,
     -2.03312017085086261358222928593e-2},
    {-9.3714243008598732571704021658e-1, 0, 0, 5.18637242884406370830023853209, 1.09143734899672957818500254654,
     -8.14978701074692612513997267357, -1.85200656599969598641566180701e1, 2.27394870993505042818970056734e1,
     2.49360555267965238987089396762, -3.0467644718982195003823669022},
    {2.27331014751653820792359768449, 0, 0, -1.05344954667372501984066689879e1, -2.00087205822486249909675718444,
     -1.79589318631187989172765950534e1, 2.79488845294199600508499808837e1, -2.85899827713502369474065508674,
     -8.87285693353062954433549289258, 1.23605671757943030647266201528e1, 6.43392746015763530355970484046e-1},
    {5.42937341165687622380535766363e-2, 0, 0, 0, 0, 4.45031289275240888144113950566,
     1.89151789931450038304281599044, -5.8012039600105847814672114227, 3.1116436695781989440891606237e-1,
     -1.52160949662516078556178806805e-1, 2.01365400804030348374776537501e-1, 4.47106157277725905176885569043e-2}};

/* the estimate of order 5 */
static const double dop853_e5[DOP853_STAGES] = {0.1312004499419488073250102996e-01,
                                                0,
                                                0,
                                                0,
                                                0,
                                                -0.1225156446376204440720569753e+01,
                                                -0.4957589496572501915214079952e+00,
                                                0.1664377182454986536961530415e+01,
                                                -0.3503288487499736816886487290e+00,
                                                0.3341791187130174790297318841e+00,
                                                0.8192320648511571246570742613e-01,
                                                -0.2235530786388629525884427845e-01};

/* the weights of stages 1, 9 and 12 which the estimate of order 3 takes from those of the new state */
static const double dop853_b3[3] = {0.244094488188976377952755905512e+00, 0.733846688281611857341361741547e+00,
                                    0.220588235294117647058823529412e-01};

typedef struct dop853_run {
    dop853_rhs f;
    void *ctx;
    int n;
    double tolerance; /* absolute and relative */
    long evals;
    double y[DOP853_LARGEST], z[DOP853_LARGEST], k[DOP853_STAGES + 1][DOP853_LARGEST];
} dop853_run;

static inline void dop853_eval(dop853_run *s, double t, const double *y, double *k)
{
    s->evals++;
    s->f(t, y, k, s->ctx);
}

/* The root of the mean square of v over the tolerance of s->y */
static inline double dop853_norm(const dop853_run *s, const double *v)
{
    double sum = 0;
    int i;
    for (i = 0; i < s->n; i++) {
        const double ratio = v[i] / (s->tolerance * (1 + fabs(s->y[i])));
        sum += ratio * ratio;
    }
    return sqrt(sum / s->n);
}

static inline double dop853_first_step(dop853_run *s, double t, double longest)
{
    const double d0 = dop853_norm(s, s->y), d1 = dop853_norm(s, s->k[0]);
    const double h0 = fmin(d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1, longest);
    double difference[DOP853_LARGEST], d2, h1;
    int i;
    for (i = 0; i < s->n; i++) s->z[i] = s->y[i] + h0 * s->k[0][i];
    dop853_eval(s, t + h0, s->z, s->k[1]);
    for (i = 0; i < s->n; i++) difference[i] = s->k[1][i] - s->k[0][i];
    d2 = dop853_norm(s, difference) / h0;
    h1 = d1 <= 1e-15 && d2 <= 1e-15 ? fmax(1e-6, h0 * 1e-3) : pow(0.01 / fmax(d1, d2), 1. / 8);
    return fmin(fmin(100 * h0, h1), longest);
}

/* The stages of a step of h from t: s->z is the new state; returns the error over the tolerance */
static inline double dop853_attempt(dop853_run *s, double t, double h)
{
    double sum5 = 0, sum3 = 0;
    int i, j, l;
    for (j = 1; j <= DOP853_STAGES; j++) {
        for (i = 0; i < s->n; i++) {
            double sum = 0;
            for (l = 0; l < j; l++) sum += dop853_a[j - 1][l] * s->k[l][i];
            s->z[i] = s->y[i] + h * sum;
        }
        dop853_eval(s, j < DOP853_STAGES ? t + dop853_c[j] * h : t + h, s->z, s->k[j]);
    }
    for (i = 0; i < s->n; i++) {
        const double tolerance = s->tolerance * (1 + fmax(fabs(s->y[i]), fabs(s->z[i])));
        double e5 = 0, e3 = 0;
        for (l = 0; l < DOP853_STAGES; l++) {
            e5 += dop853_e5[l] * s->k[l][i];
            e3 += dop853_a[DOP853_STAGES - 1][l] * s->k[l][i];
        }
        e3 -= dop853_b3[0] * s->k[0][i] + dop853_b3[1] * s->k[8][i] + dop853_b3[2] * s->k[11][i];
        sum5 += e5 * e5 / (tolerance * tolerance);
        sum3 += e3 * e3 / (tolerance * tolerance);
    }
    if (sum5 == 0 && sum3 == 0) return 0;
    return fabs(h) * sum5 / sqrt((sum5 + 0.01 * sum3) * s->n);
}

/* From t to t_end > t; y becomes y(t_end). Returns the evaluations of f, or -1 where the step became too short. */
static inline long dop853_solve(dop853_rhs f, void *ctx, int n, double t, double t_end, double *y, double tolerance)
{
    static dop853_run s;
    double h;
    int i, rejected = 0;
    s.f = f;
    s.ctx = ctx;
    s.n = n;
    s.tolerance = tolerance;
    s.evals = 0;
    for (i = 0; i < n; i++) s.y[i] = y[i];
    dop853_eval(&s, t, s.y, s.k[0]);
    h = dop853_first_step(&s, t, t_end - t);
    while (t < t_end) {
        const double least = 10 * (nextafter(t, HUGE_VAL) - t);
        double t_new, error, factor;
        if (rejected && h < least) return -1;
        if (h < least) h = least;
        t_new = fmin(t + h, t_end);
        h = t_new - t;
        error = dop853_attempt(&s, t, h);
        factor = error == 0 ? 10 : fmin(10, fmax(0.2, 0.9 * pow(error, -1. / 8)));
        if (error < 1) {
            if (rejected) factor = fmin(1, factor);
            for (i = 0; i < n; i++) {
                s.y[i] = s.z[i];
                s.k[0][i] = s.k[DOP853_STAGES][i];
            }
            t = t_new;
        }
        rejected = !(error < 1);
        h *= factor;
    }
    for (i = 0; i < n; i++) y[i] = s.y[i];
    return s.evals;
}

#endif
