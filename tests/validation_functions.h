/* validation_functions.h - special functions: the values of GSL's and Boost's own tests, of Carlson's paper, of the
   handbook by Abramowitz and Stegun, and of the DLMF */
#ifndef VALIDATION_FUNCTIONS_H
#define VALIDATION_FUNCTIONS_H

#include "validation.h"

#define PI 3.14159265358979323846

/* A row whose call is what it says, for example ROW("1.8540746773013719", jacobi_K(0.5)). The arguments are doubles;
   the macros below round them to vm_real, which keeps the call readable in the printed row. */
#define ROW(published, call) validation_row("`" #call "`", published, (double)(call))

#define jacobi_K(m) jacobi_K((vm_real)(m))
#define jacobi_K_m1(m1) jacobi_K_m1((vm_real)(m1))
#define jacobi_E(m) jacobi_E((vm_real)(m))
#define jacobi_Pi(n, m) jacobi_Pi((vm_real)(n), (vm_real)(m))
#define jacobi_F(phi, m) jacobi_F((vm_real)(phi), (vm_real)(m))
#define jacobi_E_incomplete(phi, m) jacobi_E_incomplete((vm_real)(phi), (vm_real)(m))
#define jacobi_Pi_incomplete(phi, n, m) jacobi_Pi_incomplete((vm_real)(phi), (vm_real)(n), (vm_real)(m))
#define jacobi_sn(u, m) jacobi_sn((vm_real)(u), (vm_real)(m))
#define jacobi_cn(u, m) jacobi_cn((vm_real)(u), (vm_real)(m))
#define jacobi_dn(u, m) jacobi_dn((vm_real)(u), (vm_real)(m))
#define jacobi_RF(x, y, z) jacobi_RF((vm_real)(x), (vm_real)(y), (vm_real)(z))
#define jacobi_RC(x, y) jacobi_RC((vm_real)(x), (vm_real)(y))
#define jacobi_RD(x, y, z) jacobi_RD((vm_real)(x), (vm_real)(y), (vm_real)(z))
#define jacobi_RJ(x, y, z, p) jacobi_RJ((vm_real)(x), (vm_real)(y), (vm_real)(z), (vm_real)(p))
#define jacobi_RG(x, y, z) jacobi_RG((vm_real)(x), (vm_real)(y), (vm_real)(z))
#define ateb_beta_inc(x, a, b) ateb_beta_inc((vm_real)(x), (vm_real)(a), (vm_real)(b))

static void validate_gsl_integrals(void)
{
    static const validation_group group = {
        "GSL's elliptic integrals",
        "the GNU Scientific Library (GSL) 2.8, function test_ellint in the file specfunc/test_sf.c",
        "The functions of GSL have the modulus k as parameter; our functions have m = k^2. The characteristic n of the "
        "integral Pi has the opposite sign in GSL. The function jacobi_K_m1 computes the integral K from 1 - m instead "
        "of m. In the row of jacobi_K_m1, k is 1 - 2^-30. For this k, GSL's own test allows an error of 1e-6, because "
        "GSL's function gets k and must compute 1 - k^2. In this difference most digits cancel, so that its relative "
        "error is large. This error does not occur in our function jacobi_K_m1, because jacobi_K_m1 gets the number 1 "
        "- k^2 itself, here the exact floating-point number 2^-29 - 2^-60.",
        "The error of each of our functions in this table, for complete and for incomplete integrals, is at most 8 "
        "ulp, where an ulp is the distance between neighbouring floating-point numbers. The rounding of k^2 and of the "
        "angle adds an error of at most 4 eps, where eps is 2.2e-16 in double. Together these errors are below the "
        "tolerance.",
        3e-15, 3e-6};
    validation_begin(&group);
    ROW("3.3566005233611923760", jacobi_K(0.99 * 0.99));
    ROW("1.6857503548125960429", jacobi_K(0.50 * 0.50));
    ROW("11.4369284843320018031", jacobi_K_m1(0x1p-29 - 0x1p-60));
    ROW("1.0284758090288040010", jacobi_E(0.99 * 0.99));
    ROW("1.4674622093394271555", jacobi_E(0.50 * 0.50));
    ROW("3.13792612351836506315593", jacobi_Pi(-0.1, 0.99 * 0.99));
    ROW("1.60455249360848890075108", jacobi_Pi(-0.1, 0.50 * 0.50));
    ROW("1.3065333392738766762", jacobi_F(PI / 3, 0.99 * 0.99));
    ROW("1.0895506700518854093", jacobi_F(PI / 3, 0.50 * 0.50));
    ROW("14.7329354327186461803160", jacobi_F(7 * PI / 3, 0.99 * 0.99));
    ROW("-8.01973438599626142824910", jacobi_F(-4 * PI / 3, 0.99 * 0.99));
    ROW("0.8704819220377943536", jacobi_E_incomplete(PI / 3, 0.99 * 0.99));
    ROW("4.98438515815301035756360", jacobi_E_incomplete(7 * PI / 3, 0.99 * 0.99));
    ROW("-3.94247997382332634020184", jacobi_E_incomplete(-4 * PI / 3, 0.50 * 0.50));
    ROW("1.1288726598764099882", jacobi_Pi_incomplete(PI / 3, -0.5, 0.99 * 0.99));
    ROW("0.9570574331323584890", jacobi_Pi_incomplete(PI / 3, -0.5, 0.50 * 0.50));
    ROW("12.36441982979439", jacobi_RF(5.0e-11, 1.0e-10, 1.0));
    ROW("34.0932594919337362", jacobi_RD(5.0e-11, 1.0e-10, 1.0));
    ROW("0.1429757966715675", jacobi_RJ(2.0, 3.0, 4.0, 5.0));
}

static void validate_gsl_functions(void)
{
    static const validation_group group = {
        "GSL's Jacobi functions and incomplete beta function",
        "the GNU Scientific Library (GSL) 2.8, function test_jac in the file specfunc/test_sf.c, and the file "
        "specfunc/test_gamma.c",
        "GSL's function for sn, cn and dn, elljac, has the same parameter m as our functions. GSL's beta_inc(a, b, x) "
        "is the same function as our ateb_beta_inc(x, a, b).",
        "The errors of our Jacobi functions are at most 9 ulp. (An ulp is the distance between neighbouring "
        "floating-point numbers.) The parameters m = 0.3, 0.6 and 0.999999 must be rounded to floating-point numbers, "
        "which causes a further error. The bound of ateb_beta_inc, 30 ulp, is larger than the tolerance, but its "
        "errors at the arguments of the table are much smaller than this bound.",
        3e-15, 6e-6};
    validation_begin(&group);
    ROW("0.4707504736556572833", jacobi_sn(0.5, 0.5));
    ROW("0.8822663948904402865", jacobi_cn(0.5, 0.5));
    ROW("0.9429724257773856873", jacobi_dn(0.5, 0.5));
    ROW("0.8187707145344889190", jacobi_sn(1.0, 0.3));
    ROW("0.7432676860864044186", jacobi_sn(3.0, 0.6));
    ROW("-0.6689941306317733154", jacobi_cn(3.0, 0.6));
    ROW("0.96402778575700186570", jacobi_sn(2.0, 0.999999));
    ROW("0.26580148285600686381", jacobi_cn(2.0, 0.999999));
    ROW("0.26580323105264131136", jacobi_dn(2.0, 0.999999));
    ROW("0.9330329915368074160", ateb_beta_inc(0.5, 0.1, 1.0));
    ROW("8.881784197001252323e-16", ateb_beta_inc(0.5, 50.0, 1.0));
    ROW("0.06696700846319258402", ateb_beta_inc(0.5, 1.0, 0.1));
    ROW("0.8309072939016694143", ateb_beta_inc(0.5, 50.0, 60.0));
}

static void validate_gsl_large_beta(void)
{
    static const validation_group group = {
        "GSL's incomplete beta function of large parameters",
        "the GNU Scientific Library (GSL) 2.8, file specfunc/test_gamma.c",
        "As in the previous table, GSL's beta_inc(a, b, x) is our ateb_beta_inc(x, a, b). `make test` checks the table "
        "in float, too; in float it leaves out the rows whose published number is below 1e-37, because a float cannot "
        "hold such a small number with all its digits.",
        "The arguments x = 0.4 and 0.6 are rounded to double. Let f be the result as a function of x. A rounding error "
        "of x changes ln f by this error times the derivative of ln f, and this derivative is up to some thousands. "
        "The change of ln f is the relative change of f.",
        6e-13, 1e-6};
    validation_begin(&group);
    ROW("0.9999999999157549630", ateb_beta_inc(0.6, 500.0, 500.0));
    ROW("4.518543727260666383e-91", ateb_beta_inc(0.4, 5000.0, 5000.0));
    ROW("8.445388773903332659e-89", ateb_beta_inc(0.6, 5000.0, 2000.0));
}

static double any_sn(double u, double m)
{
    vm_real sn, cn, dn;
    jacobi_sncndn_any((vm_real)u, (vm_real)m, &sn, &cn, &dn);
    return (double)sn;
}

static void validate_boost(void)
{
    static const validation_group group = {
        "Boost.Math's test data",
        "the repository boostorg/math, commit 99733ebbd (2026), test/test_jacobi.hpp, test_ellint_3.hpp, "
        "ellint_*_data.ipp, ellint_rg.ipp, ibeta_small_data.ipp",
        "The functions of Boost have the modulus k as parameter; our functions have m = k^2. The arguments are binary "
        "fractions, which are stored without rounding in double and in float. Our function jacobi_sn serves for m up "
        "to 1. For k = 1.5, m is 2.25; therefore we use the function jacobi_sncndn_any, which computes sn, cn and dn "
        "for every m. In the table, any_sn stands for the first of its three results, sn.",
        "The bounds of the errors of our functions are 9 ulp for sn, cn and dn, and at most 8 ulp for the other "
        "functions except ateb_beta_inc. (An ulp is the distance between neighbouring floating-point numbers.) The "
        "bound of ateb_beta_inc, 30 ulp, is larger than the tolerance, but the errors at the arguments of the table "
        "are far below this bound. Near k = 1, the rounding of k^2 adds an error of some eps (2.2e-16 in double), "
        "because E and F depend on 1 - k^2.",
        4e-15, 4e-6};
    validation_begin(&group);
    ROW("0.246781405136141600483623741101255", jacobi_sn(0.25, 0.5 * 0.5));
    ROW("0.371179242693370810357222594552132", jacobi_cn(1.25, 0.5 * 0.5));
    ROW("-0.969223071486651608400225080456020", jacobi_sn(25.0, 0.5 * 0.5));
    ROW("0.874729477852721764836147376110255", jacobi_dn(25.0, 0.5 * 0.5));
    ROW("0.848768940045053312079390719205939", jacobi_sn(1.25, 511.0 / 512 * 511 / 512));
    ROW("-0.999681606947341709011836635135182", jacobi_cn(25.0, 511.0 / 512 * 511 / 512));
    ROW("0.665875890711922169121186264316618", any_sn(1.25, 1.5 * 1.5));
    ROW("0.618665338981368217712277210270170", any_sn(25.0, 1.5 * 1.5));
    ROW("2.4193766718674199444433297470157", jacobi_K(0.927107870578765869140625 * 0.927107870578765869140625));
    ROW("1.5735793449827667907952217556653", jacobi_K(0.084016263484954833984375 * 0.084016263484954833984375));
    ROW("0.15312566397501259415031965429741",
        jacobi_F(0.15262925624847412109375, 0.9133758544921875 * 0.9133758544921875));
    ROW("4.1970788160335566139770626163874",
        jacobi_F(3.7676393985748291015625, 0.6323592662811279296875 * 0.6323592662811279296875));
    ROW("0.15223985015727243233689620438692",
        jacobi_E_incomplete(0.15262925624847412109375, 0.81158387660980224609375 * 0.81158387660980224609375));
    ROW("0.17122026715243530525631538196923",
        jacobi_Pi(-87.1743316650390625, 0.6323592662811279296875 * 0.6323592662811279296875));
    ROW("1.94035430698283383519802363708143",
        jacobi_Pi(0.308167040348052978515625, 0.308167040348052978515625 * 0.308167040348052978515625));
    ROW("0.501246705365439492445236118603525", jacobi_Pi_incomplete(0.5, 0.0, 0.25 * 0.25));
    ROW("13.2821612239764190363647953338545", jacobi_Pi_incomplete(1.5, 0.9990234375, 0.0));
    ROW("1.77299767784815770192352979665283", jacobi_Pi_incomplete(1.0, 1.125, 0.25 * 0.25));
    ROW("0.9827297959310547093553196782752749843992",
        ateb_beta_inc(0.3462987840175628662109375, 0.1540344059467315673828125, 4.049813747406005859375));
    ROW("0.9343505884118188500531298388527642525024",
        ateb_beta_inc(0.602882802486419677734375, 0.96730029582977294921875, 2.896893978118896484375));
    ROW("0.6448167195684468911342719578217201877707",
        ateb_beta_inc(0.343905150890350341796875, 2.3477990627288818359375, 5.52881145477294921875));
}

static void validate_carlson(void)
{
    static const validation_group group = {
        "Carlson's symmetric integrals",
        "section 3 of Carlson's paper \"Numerical computation of real or complex elliptic integrals\", Numerical "
        "Algorithms 10 (1995)",
        "Carlson's paper has integrals with real and with complex arguments; the table has those with real arguments. "
        "If the last argument of one of the integrals R_C and R_J is negative, the integrand has a pole in the range "
        "of integration; the number in the table is then the principal value of the integral.",
        "Carlson's paper prints its numbers with 14 digits.",
        1e-13, 3e-6};
    validation_begin(&group);
    ROW("1.3110287771461", jacobi_RF(1, 2, 0));
    ROW("1.8540746773014", jacobi_RF(0.5, 1, 0));
    ROW("0.58408284167715", jacobi_RF(2, 3, 4));
    ROW("3.1415926535898", jacobi_RC(0, 0.25));
    ROW("0.69314718055995", jacobi_RC(2.25, 2));
    ROW("0.23104906018665", jacobi_RC(0.25, -2));
    ROW("0.77688623778582", jacobi_RJ(0, 1, 2, 3));
    ROW("0.14297579667157", jacobi_RJ(2, 3, 4, 5));
    ROW("0.24723819703052", jacobi_RJ(2, 3, 4, -0.5));
    ROW("-0.12711230042964", jacobi_RJ(2, 3, 4, -5));
    ROW("1.7972103521034", jacobi_RD(0, 2, 1));
    ROW("0.16510527294261", jacobi_RD(2, 3, 4));
    ROW("3.1415926535898", jacobi_RG(0, 16, 16));
    ROW("1.7255030280692", jacobi_RG(2, 3, 4));
    ROW("1.0284758090288", jacobi_RG(0, 0.0796, 4));
}

static void validate_handbooks(void)
{
    static const validation_group group = {
        "Abramowitz and Stegun, K(m)",
        "table 17.1 of the Handbook of Mathematical Functions (1964)",
        "The table below has the nine rows of the handbook's table of K(m) for m = 0.1 to 0.9.",
        "The handbook's table has 15 decimals. Half a unit of the last decimal is 5e-16, and the rounding of m to a "
        "floating-point number causes a further error of this size.",
        2e-15, 1e-6};
    static const validation_group short_rows = {
        "Abramowitz and Stegun, E(m); the DLMF, sn, cn and dn",
        "table 17.1 of the Handbook of Mathematical Functions, and section 22.20(ii) of NIST's Digital Library of "
        "Mathematical Functions (DLMF)",
        "The published numbers E(m) are from the Handbook's table; those of sn, cn and dn are from a worked example of "
        "the DLMF with the argument x = 0.8 and the modulus k = 0.65.",
        "The Handbook's table has 9 decimals, and half a unit of the last decimal is 5e-10. The DLMF's example has one "
        "decimal more, so that its rounding is smaller.",
        5e-10, 1e-6};
    validation_begin(&group);
    ROW("1.612441348720219", jacobi_K(0.1));
    ROW("1.659623598610528", jacobi_K(0.2));
    ROW("1.713889448178791", jacobi_K(0.3));
    ROW("1.777519371491253", jacobi_K(0.4));
    ROW("1.854074677301372", jacobi_K(0.5));
    ROW("1.949567749806026", jacobi_K(0.6));
    ROW("2.075363135292469", jacobi_K(0.7));
    ROW("2.257205326820854", jacobi_K(0.8));
    ROW("2.578092113348173", jacobi_K(0.9));
    validation_begin(&short_rows);
    ROW("1.530757637", jacobi_E(0.1));
    ROW("1.350643881", jacobi_E(0.5));
    ROW("1.104774733", jacobi_E(0.9));
    ROW("0.6950642165", jacobi_sn(0.8, 0.65 * 0.65));
    ROW("0.7189476580", jacobi_cn(0.8, 0.65 * 0.65));
    ROW("0.8921234349", jacobi_dn(0.8, 0.65 * 0.65));
}

static void validate_functions(void)
{
    validate_gsl_integrals();
    validate_gsl_functions();
    validate_gsl_large_beta();
    validate_boost();
    validate_carlson();
    validate_handbooks();
}

#endif
