/* Prints results whose bits may depend on the compiler's options, as hexadecimal numbers in a line, and after them what
   vm_self_check returns. tests/test_options.sh compares the lines. -DUPWARD and -DFLUSH first set the processor's rounding
   and its treatment of subnormal numbers. -DPRAGMA_CLANG and -DPRAGMA_GCC change values without an option.
   -DALONE="file" includes that header, of which only vm_self_check is called; -DPART="file" includes that one for the results,
   in place of varmass.h. */
#include <fenv.h>
#include <stdio.h>
#ifdef FLUSH
#include <xmmintrin.h>
#endif
#ifdef PRAGMA_CLANG
#pragma float_control(precise, off)
#endif
#ifdef PRAGMA_GCC
#pragma GCC optimize("unsafe-math-optimizations")
#endif
#ifdef ALONE
#include ALONE
#elif defined(PART)
#include PART
#else
#include "../varmass.h"
#endif

static void show(vm_real x)
{
    const unsigned char *byte = (const unsigned char *)&x;
    size_t i;
    for (i = 0; i < sizeof x; i++) printf("%02x", (unsigned)byte[i]);
}

#ifdef ALONE
static void show_results(void) { show(0); }
#else
static void show_results(void)
{
    volatile vm_real nan = VM_NAN, minus_zero = 0;
    vm_real alpha = 0, sn, cn, dn, sa, ca;
    int i;
    minus_zero = -minus_zero;
    show(vm_osc_period(2, (vm_real)7.5, (vm_real)2.3)); /* 0.597961 */
    show(jacobi_K(nan) == jacobi_K(nan));
    show(vmi_two_sum(minus_zero, minus_zero).hi);
    for (i = 1; i < 20; i++) {
        alpha += (vm_real)0.37;
        jacobi_sncndn(alpha, 1 / (1 + alpha), &sn, &cn, &dn);
        ateb_saca(7 * alpha, alpha, &sa, &ca);
        show(sn);
        show(cn);
        show(dn);
        show(sa);
        show(ca);
        show(jacobi_E(-alpha));
        show(ateb_beta(alpha, (vm_real)1.3));
    }
}
#endif

int main(void)
{
#ifdef UPWARD
    fesetround(FE_UPWARD);
#endif
#ifdef FLUSH
    _mm_setcsr(_mm_getcsr() | 0x8040); /* both results and arguments that are subnormal become 0 */
#endif
    show_results();
    printf(" %d\n", vm_self_check());
    return 0;
}
