/* Lambert's W of varmass.h, (202) and (204): both branches, and the same from the logarithm of the argument.
   Oracles: a table in arbitrary precision (tests/data/lambert_table.h), the identity w e^w = x at random arguments,
   and the rise and fall of the branches where the regions of the algorithm meet. */
#include "bodies.h"

/* The forms of the table. From the fourth on, the argument is l, and W is of -e^l or e^l. */
enum { W0, WM1, W0_EXP, W0_MEXP, WM1_MEXP, EXPM1, LOG1P, FORMS };

static const char *names[FORMS] = {"W0 (202)", "W-1 (202)", "W0(e^l)", "W0(-e^l)", "W-1(-e^l)", "expm1", "log1p"};

static vm_real lambert(int form, vm_real x)
{
    switch (form) {
    case W0: return vm_lambert_w0(x);
    case WM1: return vm_lambert_wm1(x);
    case W0_EXP: return vm_wright_omega(x);
    case W0_MEXP: return vm_lambert_w0_neg_exp(x);
    default: return vm_lambert_wm1_neg_exp(x);
    }
}

static const char *region_of_logarithm(int form, double l)
{
    if (form == W0_EXP) {
        if (l > 700) return "e^l above 1e304";
        return l < -36 ? "small" : "";
    }
    if (l > -1.1) return "branch point";
    return l < -700 ? "e^l below 1e-304" : "";
}

static const char *region_of(int form, double x)
{
    if (form >= W0_EXP) return region_of_logarithm(form, x);
    if (x < -0.36) return "branch point";
    if (x < -0.25) return "x < -1/4";
    if (fabs(x) < 1e-30) return "tiny";
    return fabs(x) > 1e30 ? "huge" : "";
}

/* exp(x) - 1 and log(1 + x) as sums of two numbers, on which W is built */
static void check_kernel(int form, double x, double high, double low)
{
    const vm_two got = form == EXPM1 ? vmi_expm1(vmi_two(R(x), 0)) : vmi_log1p(vmi_two(R(x), 0));
    const double error = fabs((((double)got.hi - high) + (double)got.lo) - low);
    if (is_float && high > (double)FLT_MAX) return;
    if (form == LOG1P)
        check_error(names[form], "hi + lo", "eps", error / fabs(high) / eps, is_float ? 5e-4 : 3e-6, x, 0);
    else if (fabs(x) < 0.3)
        check_error(names[form], "small, hi + lo", "eps", error / fabs(high) / eps, 0.1, x, 0);
    else
        check_error(names[form], "hi + lo", "eps", error / (2 + high) / eps, 0.03, x, 0);
}

static void test_table(void)
{
    static const struct {
        int form;
        double x, high, low;
    } rows[] = {
#include "data/lambert_table.h"
    };
    size_t i;
    for (i = 0; i < sizeof rows / sizeof *rows; i++) {
        const int form = rows[i].form;
        const double x = rows[i].x, high = rows[i].high, low = rows[i].low;
        if (!representable(x)) continue;
        if (form >= EXPM1) {
            check_kernel(form, x, high, low);
        } else {
            const vm_real w = lambert(form, R(x));
            check_error(names[form], region_of(form, x), "ulp", ERROR_ULP(w, high, low), 0.8, x, 0);
        }
    }
}

/* W_-1 and W_0 meet at x = -1/e, where both are -1. */
static void test_branch_point(void)
{
    const vm_real branch = R(-0.36787944117144233); /* the number next to -1/e */
    const vm_real above = branch * (1 - 2 * VM_EPSILON), below = branch * (1 + 2 * VM_EPSILON);
    CHECK(vm_lambert_w0(branch) == -1 && vm_lambert_wm1(branch) == -1);
    CHECK(vm_lambert_w0(above) > -1 && vm_lambert_wm1(above) < -1);
    CHECK(isnan(vm_lambert_w0(below)) && isnan(vm_lambert_wm1(below)));
    CHECK(vm_lambert_w0_neg_exp(-1) == -1 && vm_lambert_wm1_neg_exp(-1) == -1);
    CHECK(isnan(vm_lambert_w0_neg_exp(R(-0.999))));
    CHECK(isnan(vm_lambert_wm1_neg_exp(R(-0.999))));
}

/* Values at the ends of the domains, and NaN beyond them */
static void test_ends_of_domains(void)
{
    vm_real x;
    CHECK(vm_lambert_w0(0) == 0 && vm_lambert_wm1(0) == -VM_INFINITY);
    CHECK(isnan(vm_lambert_wm1(VM_MIN)) && isnan(vm_lambert_wm1(R(0.5))));
    for (x = -1; x > -VM_MAX / 16; x *= 16) CHECK(isnan(vm_lambert_w0(x)) && !(vm_lambert_wm1(x) < 1));
    CHECK(isnan(vm_lambert_w0(-VM_MAX)));
    CHECK(vm_lambert_w0(VM_INFINITY) == VM_INFINITY);
    CHECK(isnan(vm_lambert_w0(-VM_INFINITY)));
    CHECK(isnan(vm_lambert_wm1(-VM_INFINITY)));
    CHECK(isnan(vm_lambert_w0(VM_NAN)));
    CHECK(isnan(vm_lambert_wm1(VM_NAN)));
    CHECK(vm_wright_omega(VM_INFINITY) == VM_INFINITY && vm_wright_omega(-VM_INFINITY) == 0);
    CHECK(isnan(vm_wright_omega(VM_NAN)));
    CHECK(vm_lambert_w0_neg_exp(-VM_INFINITY) == 0);
    CHECK(vm_lambert_wm1_neg_exp(-VM_INFINITY) == -VM_INFINITY);
    CHECK(vm_wright_omega(-VM_MAX) == 0 && vm_lambert_w0_neg_exp(-VM_MAX) == 0);
    CHECK(vm_wright_omega(VM_MAX) == VM_MAX && vm_lambert_wm1_neg_exp(-VM_MAX) == -VM_MAX);
    CHECK(fabs((double)vm_wright_omega(0) - 0.56714329040978387) < eps); /* the omega constant */
    { /* an exponential that overflows has no low word */
        const vm_real largest = R(0.6931471805599453094) * (VMI_BIAS + 1);
        const vm_two power = vmi_expm1(vmi_two(largest, largest * VM_EPSILON / 2));
        CHECK(power.hi == VM_INFINITY && power.lo == 0);
    }
}

/* w e^w = x at random arguments. An error of one eps in w makes one of (1 + w) eps in w e^w. */
static void test_identity(void)
{
    int i;
    for (i = 0; i < 4000; i++) {
        const vm_real x = R(i % 2 ? pow(10, uniform(-30, 30)) : -0.36787 * uniform(0, 1)), w = vm_lambert_w0(x);
        const vm_real negative = -VM_FABS(x), x1 = negative < R(-0.36787) ? R(-0.1) : negative;
        const vm_real w1 = vm_lambert_wm1(x1);
        check_error("W0 e^W0 = x", "(202)", "eps", fabs((double)(w * vmi_exp(w, 0) / x) - 1) / eps, 40, (double)x,
                    0);
        check_error("W-1 e^W-1 = x", "(202)", "eps", fabs((double)(w1 * vmi_exp(w1, 0) / x1) - 1) / eps, 60,
                    (double)x1, 0);
    }
}

/* W_0 rises and W_-1 falls also where two regions of the algorithm meet. */
static void test_joints(void)
{
    const double joints[] = {-0.3678,   -0.36, -0.25,          -0.1,          1,
                             2.718281828, 2.8772, 55, 2.648912213e10, 1.304180878e52};
    const int count = VM_MANT_DIG > 24 ? 10 : 9; /* the last one is no float */
    int i, k;
    for (i = 0; i < count; i++) {
        for (k = 0; k < 200; k++) {
            const vm_real x = R(joints[i] * (1 + (k - 100) * 4 * eps)), next = x + VM_FABS(x) * 4 * VM_EPSILON;
            CHECK(vm_lambert_w0(next) >= vm_lambert_w0(x));
            if (next < 0) CHECK(vm_lambert_wm1(next) <= vm_lambert_wm1(x));
        }
    }
}

int main(void)
{
    test_table();
    test_branch_point();
    test_ends_of_domains();
    test_identity();
    test_joints();
    return check_finish("lambert");
}
