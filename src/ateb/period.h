/* ateb/period.h - Pi_alpha, half the period of the Ateb functions

   sa and ca have the period 2 Pi_alpha, where Pi_alpha = B(1/(alpha + 1), 1/2) by (277) and B is the complete beta
   function. Pi_alpha is 2 for alpha = 0 and pi for alpha = 1. ateb_pi returns Pi_alpha; the internal functions return a
   quarter of the period, Pi_alpha/2, in two or three words, as the reduction of an argument needs them.

       vm_real period = 2 * ateb_pi(3);

   There are two methods. A table of polynomials gives Pi_alpha - (alpha + 1). This method is quick, and it is accurate
   enough for most arguments of sa and ca. For the other arguments one polynomial of degree 33 (float 17) is evaluated
   in two or three words. In the comments of this file n = alpha + 1 and q = 1/n. The tables are computed by
   tests/gen/ateb_coefficients.py. Tests: tests/test_ateb.c. */
#ifndef VARMASS_ATEB_PERIOD_H
#define VARMASS_ATEB_PERIOD_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* Returns coefficient i of a polynomial in t = 2q - 1, which approximates (1 + q)(2 + q)(3 + q) f(q), where
     f(q) = sqrt(pi) Gamma(1 + q)/Gamma(q + 1/2) = q Pi_alpha with q = 1/(alpha + 1), between 1 and 2 for 0 < q <= 1.
   The polynomial is exact at Chebyshev's points. From the fourth coefficient on, each is less than 1/8 of the previous
   one. A coefficient has up to three words; which_word = 0 selects the largest word. Words that are too small to change
   the result are 0. */
VM_API vm_real vmi_ateb_coefficient(int which_word, int i)
{
#if VM_MANT_DIG > 24
    VM_TABLE vm_real high[34] = {
        VM_C(2.0616701789183018434e+1),   VM_C(2.0267110471870335431e+1),   VM_C(6.3635705553078754093),
        VM_C(7.3329082227506181546e-1),   VM_C(1.9708227491367229928e-2),   VM_C(-4.0000651288112700496e-4),
        VM_C(1.9327295440373642315e-5),   VM_C(-1.2789187658911751561e-6),  VM_C(9.9916872651209047445e-8),
        VM_C(-8.6358235237752655812e-9),  VM_C(7.9763568164635901392e-10),  VM_C(-7.7130262679616792355e-11),
        VM_C(7.7070743924391761201e-12),  VM_C(-7.8886573293367475069e-13), VM_C(8.2211271037952946036e-14),
        VM_C(-8.6854809713564620063e-15), VM_C(9.2729461017836547871e-16),  VM_C(-9.9811923844216788706e-17),
        VM_C(1.081230028747049329e-17),   VM_C(-1.1771637894488280204e-18), VM_C(1.2867238266427922807e-19),
        VM_C(-1.4109468128426003026e-20), VM_C(1.5510876021633897508e-21),  VM_C(-1.7086157884284126588e-22),
        VM_C(1.8852205416028078608e-23),  VM_C(-2.0828212289555137945e-24), VM_C(2.3035767011988879034e-25),
        VM_C(-2.5499329020418479467e-26), VM_C(2.8250575586442172435e-27),  VM_C(-3.1311422081625854324e-28),
        VM_C(3.4527226049922925084e-29),  VM_C(-3.8299883133411974758e-30), VM_C(4.7469491485808577813e-31),
        VM_C(-5.2687713493837014328e-32)};
    VM_TABLE vm_real low[22] = {
        VM_C(-3.0654856268470599668e-16), VM_C(1.210856509558633265e-15),   VM_C(3.0240525334513940988e-16),
        VM_C(-2.7717839450259092574e-19), VM_C(5.4666001892695387149e-19),  VM_C(-9.4064217969122898471e-21),
        VM_C(-1.1974064187521360439e-21), VM_C(-6.1449037626015888544e-23), VM_C(8.7901834551117892935e-25),
        VM_C(-5.9540578421884869214e-26), VM_C(-3.1215006189736638565e-26), VM_C(-4.2737260635061168349e-27),
        VM_C(1.0083140101962316162e-28),  VM_C(-2.861198322244910502e-29),  VM_C(-2.8146374107301775257e-30),
        VM_C(1.3516503830597232673e-31),  VM_C(9.335454088442542743e-32),   VM_C(-1.6623091458375181777e-33),
        VM_C(4.8535695583016722406e-34),  VM_C(4.2966913431290166353e-35),  VM_C(6.443494554591900988e-36),
        VM_C(1.4556914938291642103e-36)};
    VM_TABLE vm_real lowest[10] = {VM_C(-2.1193920831105467827e-32), VM_C(-7.808521102450774183e-32),
                                   VM_C(-1.2473656445091337713e-32), VM_C(-9.1883466313042762769e-36),
                                   VM_C(-4.7367768879157581675e-35), VM_C(6.8348014068649053378e-37),
                                   VM_C(-8.2912063937409743857e-38), VM_C(3.4431687262560826523e-39),
                                   VM_C(-3.7393247709997878888e-41), VM_C(1.2854247930563996123e-42)};
#else
    VM_TABLE vm_real high[18] = {VM_C(2.06167011261e+1),  VM_C(2.02671108246e+1),   VM_C(6.36357069016),
                                 VM_C(7.33290851116e-1),  VM_C(1.97082273662e-2),   VM_C(-4.00006509153e-4),
                                 VM_C(1.93272953766e-5),  VM_C(-1.27891871671e-6),  VM_C(9.9916874774e-8),
                                 VM_C(-8.63582361177e-9), VM_C(7.97635624217e-10),  VM_C(-7.71302535729e-11),
                                 VM_C(7.70717083903e-12), VM_C(-7.88876234302e-13), VM_C(8.21161511727e-14),
                                 VM_C(-8.6751217104e-15), VM_C(9.7750746723e-16),   VM_C(-1.05279968328e-16)};
    VM_TABLE vm_real low[11] = {VM_C(6.63084392727e-7),  VM_C(-3.52714636165e-7),  VM_C(-1.34847155664e-7),
                                VM_C(-2.88411179383e-8), VM_C(1.25158203246e-10),  VM_C(-3.72795457698e-12),
                                VM_C(6.37998226298e-14), VM_C(-4.91834898546e-14), VM_C(-2.10293378035e-15),
                                VM_C(8.58360954133e-17), VM_C(3.02997111408e-19)};
    VM_TABLE vm_real lowest[5] = {VM_C(-7.41197620451e-15), VM_C(1.18689975044e-14), VM_C(2.07874802509e-15),
                                  VM_C(-6.6640947106e-16), VM_C(-2.54688931285e-18)};
#endif
    if (which_word == 0) return VM_READ(high[i]);
    if (which_word == 1) return i < (int)(sizeof low / sizeof *low) ? VM_READ(low[i]) : 0;
    return i < (int)(sizeof lowest / sizeof *lowest) ? VM_READ(lowest[i]) : 0;
}

/* The degree of the polynomial of vmi_ateb_coefficient */
enum { VMI_ATEB_DEGREE = VM_MANT_DIG > 24 ? 33 : 17 };

/* Returns the polynomial of vmi_ateb_coefficient in two words. From index TWO_WORDS on the coefficients are so small
   that one word is enough. The relative error of the polynomial is below 2^-105 (float 2^-47.7), without rounding. No
   coefficient has a smaller binary exponent than the sum of the terms after it, so that Dekker's faster sum
   (vmi_fast_two_sum) is exact for the high words. */
VM_API vm_two vmi_ateb_polynomial(vm_two t)
{
    enum { TWO_WORDS = VM_MANT_DIG > 24 ? 17 : 8 };
    vm_two sum;
    vm_real tail = vmi_ateb_coefficient(0, VMI_ATEB_DEGREE);
    int i;
    for (i = VMI_ATEB_DEGREE - 1; i >= TWO_WORDS; i--) tail = vmi_ateb_coefficient(0, i) + tail * t.hi;
    sum = vmi_two(tail, 0);
    for (i = TWO_WORDS - 1; i >= 0; i--) {
        const vm_real high = vmi_ateb_coefficient(0, i), low = vmi_ateb_coefficient(1, i);
        const vm_two p = vmi_two_product(sum.hi, t.hi);
        const vm_real hi = high + p.hi;
        sum.lo = (p.hi - (hi - high)) + (p.lo + (sum.hi * t.lo + sum.lo * t.hi) + low);
        sum.hi = hi;
    }
    return sum;
}

/* Returns f(q) = q Pi_alpha, where q = 1/(alpha + 1), with a relative error below 2^-98.8 (float 2^-40.8) */
VM_API vm_two vmi_ateb_gamma_ratio(vm_two q)
{
    const vm_two one = {1, 0}, minus_one = {-1, 0}, twice_q = vmi_two(2 * q.hi, 2 * q.lo);
    const vm_two q_plus_1 = vmi_two_plus(one, q), q_plus_2 = vmi_two_plus(one, q_plus_1);
    const vm_two q_plus_3 = vmi_two_plus(one, q_plus_2);
    const vm_two divisor = vmi_two_times(vmi_two_times(q_plus_1, q_plus_2), q_plus_3);
    return vmi_two_over(vmi_ateb_polynomial(vmi_two_plus(minus_one, twice_q)), divisor);
}

/* Returns Pi_alpha/2 in three words, with a relative error of 2^-125 (float 2^-58), for n = alpha + 1 < 1e9 (float
   3e4). The result is n f(q)/2. The polynomial of vmi_ateb_coefficient, divided by 1 + q, 2 + q and 3 + q, is f(q). The
   quotient 1/(i + q) is computed as n/(i n + 1). */
VM_API vmi_three vmi_ateb_finest_quarter(vm_two n_two)
{
    const vmi_three one = vmi_three_words(1, 0, 0), n = vmi_three_words(n_two.hi, n_two.lo, 0);
    const vmi_three t = vmi_three_over(vmi_three_plus(vmi_three_words(2, 0, 0), vmi_three_words(-n.hi, -n.mid, 0)),
                                       n);
    vmi_three sum = vmi_three_words(vmi_ateb_coefficient(0, VMI_ATEB_DEGREE), 0, 0), above = one;
    int i;
    for (i = VMI_ATEB_DEGREE - 1; i >= 0; i--)
        sum = vmi_three_plus(
            vmi_three_times(sum, t),
            vmi_three_words(vmi_ateb_coefficient(0, i), vmi_ateb_coefficient(1, i), vmi_ateb_coefficient(2, i)));
    for (i = 1; i <= 3; i++) {
        above = vmi_three_plus(above, n);
        sum = vmi_three_times(sum, vmi_three_over(n, above));
    }
    return vmi_three_times(sum, vmi_three_words(n.hi / 2, n.mid / 2, 0));
}

/* The columns of the table of g(q) = Pi_alpha - (alpha + 1), where q = 1/(alpha + 1). The row with the index `row` is
   for q = row/32. The columns are, in this order: the low word of g, the low word of the slope of g, g, the slope, and
   the further coefficients of the Taylor series of g about this q. The slope has only half of the digits of a vm_real;
   its product with another number of half of the digits is exact. */
enum {
    VMI_ATEB_G_LOW,
    VMI_ATEB_G_SLOPE_LOW,
    VMI_ATEB_G_VALUE,
    VMI_ATEB_G_SLOPE,
    VMI_ATEB_G_SERIES,
    VMI_ATEB_G_COLUMNS = VM_MANT_DIG > 24 ? 12 : 8
};

/* Returns a number from the table of g(q), where q = 1/(alpha + 1). Row 0 is for q = 0 (g = 2 ln 2), row 32 for q = 1
   (g = 1). */
VM_INLINE vm_real vmi_ateb_g_constant(int row, int column)
{
#if VM_MANT_DIG > 24
    VM_TABLE vm_real table[33][VMI_ATEB_G_COLUMNS] = {
        {VM_C(4.6381784140415292946e-17), VM_C(5.331171102802348789e-9), VM_C(1.3862943611198905725),
         VM_C(-0.68402804434299468994), VM_C(0.5677838543520554726), VM_C(-0.52915485716514631953),
         VM_C(0.51340603033793608123), VM_C(-0.50637868382441575399), VM_C(0.50309358102303392002),
         VM_C(-0.50151740078556006353), VM_C(0.50105490721077416971), VM_C(-0.50067714700750998169)},
        {VM_C(-3.746949124584277166e-17), VM_C(-3.375761016203596395e-10), VM_C(1.3654572877816153476),
         VM_C(-0.65003146231174468994), VM_C(0.52103618593312694962), VM_C(-0.4696330854200412297),
         VM_C(0.44114986130835415201), VM_C(-0.42153445212145007615), VM_C(0.40589002564213277902),
         VM_C(-0.39223584488976526163), VM_C(0.37991845750708058693), VM_C(-0.36809154922123549225)},
        {VM_C(-7.8406819950210754769e-17), VM_C(3.3966535452023658325e-9), VM_C(1.3456387054272960224),
         VM_C(-0.61879067122936248779), VM_C(0.47946987489163483964), VM_C(-0.41837065067676054708),
         VM_C(0.38083583828521405668), VM_C(-0.35286673006145163889), VM_C(0.32959475277592498177),
         VM_C(-0.30903951242953936474), VM_C(0.29046700106892275883), VM_C(-0.27311845414073881999)},
        {VM_C(-9.1553345977383271773e-17), VM_C(5.0567374634387609403e-9), VM_C(1.3267573146735365253),
         VM_C(-0.59000463783740997314), VM_C(0.44237592877439152472), VM_C(-0.37402081765250377865),
         VM_C(0.3302167737610899878), VM_C(-0.2969402684662968972), VM_C(0.26927906310655541633),
         VM_C(-0.24518921345206348694), VM_C(0.22381875903490874857), VM_C(-0.20441471614701206549)},
        {VM_C(6.654971387994451498e-17), VM_C(3.3436286599409676238e-9), VM_C(1.3087405697461549359),
         VM_C(-0.5634129643440246582), VM_C(0.40915942629353885263), VM_C(-0.33548699941222598353),
         VM_C(0.28751668597927382276), VM_C(-0.25111964491493382612), VM_C(0.22127227394038748165),
         VM_C(-0.19581235997028939577), VM_C(0.17373966474009477912), VM_C(-0.15425084140040531966)},
        {VM_C(2.2024860108414943077e-17), VM_C(5.4446360580413684035e-9), VM_C(1.2915235131302789107),
         VM_C(-0.5387894362211227417), VM_C(0.37931859969562842227), VM_C(-0.30187095778239825261),
         VM_C(0.25132242412520844344), VM_C(-0.21336754591646725498), VM_C(0.18281734294869281254),
         VM_C(-0.15735295297007001469), VM_C(0.13580929352374890295), VM_C(-0.11730133905365178193)},
        {VM_C(9.9540672703090293547e-18), VM_C(4.8101252302153244851e-9), VM_C(1.2750477928546863904),
         VM_C(-0.51593671739101409912), VM_C(0.35242819529002022971), VM_C(-0.27243277384856789958),
         VM_C(0.22050230344455343245), VM_C(-0.18209763033984616154), VM_C(0.15182681678020867877),
         VM_C(-0.12719288577525503237), VM_C(0.10686296199078124114), VM_C(-0.089858625474818029644)},
        {VM_C(5.4062922199915057231e-17), VM_C(2.9913058690087808791e-9), VM_C(1.2592608297557805752),
         VM_C(-0.49468202143907546997), VM_C(0.32812615163036995547), VM_C(-0.24655968937155745002),
         VM_C(0.19414452552092564819), VM_C(-0.15606625168439275386), VM_C(0.12670819938059293963),
         VM_C(-0.10338845876742652763), VM_C(0.084614317519929316269), VM_C(-0.069315954758375611378)},
        {VM_C(-6.0802945081877102697e-17), VM_C(-1.6253271077599876218e-9), VM_C(1.2441151085842396817),
         VM_C(-0.47487349808216094971), VM_C(0.30610286869586122993), VM_C(-0.2237416866522687342),
         VM_C(0.17151021694609555612), VM_C(-0.13429210727999726926), VM_C(0.10623784786903479882),
         VM_C(-0.084485231450717512836), VM_C(0.067397287639013842009), VM_C(-0.053823392856868976231)},
        {VM_C(2.2922259916551777034e-17), VM_C(3.7121489121588666953e-9), VM_C(1.2295675719059040443),
         VM_C(-0.45637725293636322021), VM_C(0.28609251412274883108), VM_C(-0.20355222507963094403),
         VM_C(0.15199735733327637832), VM_C(-0.11599613738196930257), VM_C(0.089469120401370685891),
         VM_C(-0.069386696616545145977), VM_C(0.053987849279679638037), VM_C(-0.042056431764961578479)},
        {VM_C(-8.0795939207491025052e-18), VM_C(-2.7226562956162019136e-9), VM_C(1.2155790997479136717),
         VM_C(-0.43907479196786880493), VM_C(0.26786594113039835507), VM_C(-0.18563295171266502859),
         VM_C(0.13511288180544195336), VM_C(-0.10055623188728740613), VM_C(0.075664922022792471812),
         VM_C(-0.057260299500816687346), VM_C(0.043479743608099391539), VM_C(-0.033058757380318597174)},
        {VM_C(4.7816802184330405841e-19), VM_C(1.9756706117912506114e-9), VM_C(1.2021140611045799673),
         VM_C(-0.42286099493503570557), VM_C(0.25122488928148434262), VM_C(-0.16968149496366849438),
         VM_C(0.12045096510876490692), VM_C(-0.087472852038395138008), VM_C(0.064247780831554288095),
         VM_C(-0.047469612515712286682), VM_C(0.035197017012146607218), VM_C(-0.026134360033998466077)},
        {VM_C(-9.5450403254978507853e-17), VM_C(-8.1999868771171600589e-10), VM_C(1.1891399259348427453),
         VM_C(-0.40764225274324417114), VM_C(0.23599721216040245308), VM_C(-0.15544166538668593991),
         VM_C(0.10767601302138693486), VM_C(-0.07634275918323399357), VM_C(0.054762624157525252588),
         VM_C(-0.039524992157935145976), VM_C(0.02863194225078574337), VM_C(-0.020772813788626273007)},
        {VM_C(-9.4063424025832752954e-17), VM_C(3.1812021489420587423e-9), VM_C(1.1766269282978578659),
         VM_C(-0.39333503693342208862), VM_C(0.22203293158224132742), VM_C(-0.142695547155390845),
         VM_C(0.096509262200188850045), VM_C(-0.066838808725968895663), VM_C(0.046848827808788760796),
         VM_C(-0.033047406672723836363), VM_C(0.023400590533385924596), VM_C(-0.016597068906664874666)},
        {VM_C(-1.0211730748417630065e-16), VM_C(5.9013741946619049536e-11), VM_C(1.16454777289448419),
         VM_C(-0.37986455857753753662), VM_C(0.20920096049727193721), VM_C(-0.13125708315803222281),
         VM_C(0.08671816364546579281), VM_C(-0.058694313043688293996), VM_C(0.040219086904567845353),
         VM_C(-0.027741725268581755859), VM_C(0.019210785527825898628), VM_C(-0.013326666437091310227)},
        {VM_C(-2.7048390872224065209e-18), VM_C(-2.6736593886606200744e-9), VM_C(1.1528773785938013496),
         VM_C(-0.36716372519731521606), VM_C(0.19738636957224631185), VM_C(-0.12096684650876125822),
         VM_C(0.07810792647354045104), VM_C(-0.051690868937492417956), VM_C(0.034643340757513838013),
         VM_C(-0.023376856621966111971), VM_C(0.015838814906640776015), VM_C(-0.010751610539873293626)},
        {VM_C(-9.9579915187844247504e-17), VM_C(-9.6786481397990003401e-10), VM_C(1.141592653589793338),
         VM_C(-0.35517217963933944702), VM_C(0.18648809789096257306), VM_C(-0.11168775940024938675),
         VM_C(0.070514747928371840358), VM_C(-0.045648828685767445235), VM_C(0.02993646779208306713),
         VM_C(-0.019770882078257778769), VM_C(0.01311238479152660244), VM_C(-8.7136680256610331285e-3)},
        {VM_C(-3.0462765550502953801e-17), VM_C(-1.4459812228645864948e-9), VM_C(1.130672297703971374),
         VM_C(-0.343835487961769104), VM_C(0.17641702808535342228), VM_C(-0.10330157218996104118),
         VM_C(0.063800366849676534708), VM_C(-0.040419800419741531983), VM_C(0.02594881102450546928),
         VM_C(-0.016779856704295884745), VM_C(0.010898058030344666414), VM_C(-7.0928854257970115268e-3)},
        {VM_C(6.8274309249854587011e-17), VM_C(2.3320810199713432271e-9), VM_C(1.1200966280640243244),
         VM_C(-0.33310446888208389282), VM_C(0.16709436179882838913), VM_C(-0.095705955493318242699),
         VM_C(0.057847661342177718324), VM_C(-0.035880715239089804036), VM_C(0.022558841989770438835),
         VM_C(-0.01428932191598817833), VM_C(9.0919360921870237546e-3), VM_C(-5.7977994985198063466e-3)},
        {VM_C(-5.9217966342746265894e-17), VM_C(-2.6690627410852378943e-9), VM_C(1.1098474249771592692),
         VM_C(-0.32293456047773361206), VM_C(0.1584502436816834503), VM_C(-0.088812088838981742556),
         VM_C(0.052557074474749915227), VM_C(-0.031929110593007251073), VM_C(0.019667449875678016252),
         VM_C(-0.012207835613912186926), VM_C(7.6127035867722099918e-3), VM_C(-4.758281525726736072e-3)},
        {VM_C(-5.3337385117691098856e-17), VM_C(3.0639526436566566665e-9), VM_C(1.0999077953037963429),
         VM_C(-0.31328535079956054688), VM_C(0.15042259186848722097), VM_C(-0.082542653331753937374),
         VM_C(0.047843699768046837884), VM_C(-0.028479362836590253055), VM_C(0.017193472869526747054),
         VM_C(-0.010462012666557350682), VM_C(6.3964050715056017596e-3), VM_C(-3.9202730131148678591e-3)},
        {VM_C(-2.5852775620714354257e-18), VM_C(-3.5400502752691179151e-9), VM_C(1.090262051041828828),
         VM_C(-0.3041200488805770874), VM_C(0.14295610065487995843), VM_C(-0.076830154408312603675),
         VM_C(0.043634894854055736313), VM_C(-0.025459664276221493501), VM_C(0.015070184188516319232),
         VM_C(-8.9927027536845730721e-3), VM_C(5.3925000300142390819e-3), VM_C(-3.2418888508938324515e-3)},
        {VM_C(9.9246083430337476394e-17), VM_C(2.5509443956017458929e-9), VM_C(1.0808956011689900834),
         VM_C(-0.29540517926216125488), VM_C(0.1360013873081173108), VM_C(-0.0716155153879257933),
         VM_C(0.039868319831367071693), VM_C(-0.022809586996830531064), VM_C(0.013242515682736362079),
         VM_C(-7.7520295532411713155e-3), VM_C(4.5608666894276376005e-3), VM_C(-2.690515550255248578e-3)},
        {VM_C(-5.9897851285567459795e-17), VM_C(1.6172271141304440397e-9), VM_C(1.0717948550731974944),
         VM_C(-0.28711014240980148315), VM_C(0.12951425994374426987), VM_C(-0.066846894038539286798),
         VM_C(0.036490318575518543298), VM_C(-0.020478111332291881741), VM_C(0.011664854158522162952),
         VM_C(-6.7010857957690893663e-3), VM_C(3.8695143163100156197e-3), VM_C(-2.2406380947033741405e-3)},
        {VM_C(3.016465714228832098e-18), VM_C(2.4695120036208870772e-9), VM_C(1.0629471361378510785),
         VM_C(-0.27920698374509811401), VM_C(0.12345508743621315395), VM_C(-0.062478683497586805229),
         VM_C(0.033454578137507531843), VM_C(-0.018422023916637494251), VM_C(0.010299284580012418866),
         VM_C(-5.8081303452508096022e-3), VM_C(3.292827492278427564e-3), VM_C(-1.8722034976943724947e-3)},
        {VM_C(-6.7885816850207377254e-17), VM_C(-2.8352089103464824646e-9), VM_C(1.0543406042488874252),
         VM_C(-0.27167008072137832642), VM_C(0.11778825560291796004), VM_C(-0.058470666138846466575),
         VM_C(0.030721014526891188279), VM_C(-0.01660461097402374589), VM_C(9.1141835909442688729e-3),
         VM_C(-5.0471714890422533437e-3), VM_C(2.8102120006443902234e-3), VM_C(-1.5693819858547722844e-3)},
        {VM_C(-4.8884482001293992351e-18), VM_C(3.2918614272578414737e-9), VM_C(1.045964186159314746),
         VM_C(-0.26447594910860061646), VM_C(0.11248169656410501871), VM_C(-0.054787294768893747554),
         VM_C(0.028254843492921118825), VM_C(-0.01499458844181024951), VM_C(8.0830889010808874146e-3),
         VM_C(-4.3968487820084424522e-3), VM_C(2.4050454828868908161e-3), VM_C(-1.3196244049906852291e-3)},
        {VM_C(-3.5398554210224009345e-18), VM_C(-3.1171937288947575956e-9), VM_C(1.0378075127902413044),
         VM_C(-0.25760296732187271118), VM_C(0.10750648035697503435), VM_C(-0.051397080182324583753),
         VM_C(0.026025803039909273934), VM_C(-0.013565222837864510455), VM_C(7.1837868506000896601e-3),
         VM_C(-3.8395467648870318551e-3), VM_C(2.0638605358970648317e-3), VM_C(-1.112941487533637263e-3)},
        {VM_C(-4.0391380447778101554e-17), VM_C(3.1769042596508692042e-10), VM_C(1.0298608626692795642),
         VM_C(-0.25103127956390380859), VM_C(0.10283645966668036875), VM_C(-0.048272067845909656658),
         VM_C(0.024007500836052152182), VM_C(-0.012293606347121809053), VM_C(6.3975732522676739128e-3),
         VM_C(-3.3606895825154759969e-3), VM_C(1.7757059442108575394e-3), VM_C(-9.4135014507881330671e-4)},
        {VM_C(1.1004437886233412308e-16), VM_C(4.701498157302724517e-10), VM_C(1.022115110811197658),
         VM_C(-0.24474254995584487915), VM_C(0.098447960005484252966), VM_C(-0.04538738950603821154),
         VM_C(0.022176864775268808477), VM_C(-0.011160057062385228197), VM_C(5.7086524083553797163e-3),
         VM_C(-2.9481773484921723616e-3), VM_C(1.5316450665393398917e-3), VM_C(-7.9844612972935396014e-4)},
        {VM_C(2.1474828901899838984e-17), VM_C(1.4754166857551727581e-9), VM_C(1.0145616824346503915),
         VM_C(-0.23871986940503120422), VM_C(0.09431950888413269396), VM_C(-0.042720877967710867151),
         VM_C(0.020513679018043618624), VM_C(-0.010147621158607981681), VM_C(5.1036467410569058209e-3),
         VM_C(-2.5919340443829423648e-3), VM_C(1.3243602998215997426e-3), VM_C(-6.7907276417713006902e-4)},
        {VM_C(-3.2951293899217698702e-17), VM_C(-1.6841489971875676284e-9), VM_C(1.0071925109851387337),
         VM_C(-0.2329475991427898407), VM_C(0.09043159852436784274), VM_C(-0.040252735291690058816),
         VM_C(0.019000191092083566075), VM_C(-9.2416583776976160558e-3), VM_C(4.5711953070301878516e-3),
         VM_C(-2.2835435377179360075e-3), VM_C(1.1478399428764794743e-3), VM_C(-5.7906304505224133819e-4)},
        {VM_C(4.1737691769177295977e-25), VM_C(-1.6803660290724359071e-10), VM_C(1.0),
         VM_C(-0.22741127759218215942), VM_C(0.086766477496790353485), VM_C(-0.037965246289469310736),
         VM_C(0.017620778248648341635), VM_C(-8.4294958327997809161e-3), VM_C(4.1016239960195060091e-3),
         VM_C(-2.015955492573712985e-3), VM_C(9.9712933651232107425e-4), VM_C(-4.9503803745002848344e-4)}};
#else
    VM_TABLE vm_real table[33][VMI_ATEB_G_COLUMNS] = {
        {VM_C(-3.80907971831e-9), VM_C(5.39922366443e-5), VM_C(1.38629436493), VM_C(-0.68408203125),
         VM_C(0.56778383255), VM_C(-0.529154837132), VM_C(0.513590335846), VM_C(-0.506562411785)},
        {VM_C(-8.58965965023e-9), VM_C(1.15021728561e-4), VM_C(1.36545729637), VM_C(-0.650146484375),
         VM_C(0.521036148071), VM_C(-0.469633072615), VM_C(0.441298544407), VM_C(-0.421678125858)},
        {VM_C(-4.65561953433e-8), VM_C(1.0581654351e-4), VM_C(1.34563875198), VM_C(-0.618896484375),
         VM_C(0.479469865561), VM_C(-0.418370634317), VM_C(0.380956560373), VM_C(-0.352979928255)},
        {VM_C(2.85267498512e-9), VM_C(8.32578443806e-5), VM_C(1.32675731182), VM_C(-0.590087890625),
         VM_C(0.442375928164), VM_C(-0.374020814896), VM_C(0.330315411091), VM_C(-0.297030091286)},
        {VM_C(-4.60984708184e-8), VM_C(6.36015029158e-5), VM_C(1.30874061584), VM_C(-0.5634765625),
         VM_C(0.409159421921), VM_C(-0.335486978292), VM_C(0.287597745657), VM_C(-0.25119137764)},
        {VM_C(5.6556874739e-8), VM_C(2.89285981125e-5), VM_C(1.29152345657), VM_C(-0.538818359375),
         VM_C(0.379318594933), VM_C(-0.301870942116), VM_C(0.25138938427), VM_C(-0.213425189257)},
        {VM_C(1.37715039372e-8), VM_C(-6.75719566061e-5), VM_C(1.27504777908), VM_C(-0.515869140625),
         VM_C(0.352428197861), VM_C(-0.272432774305), VM_C(0.220557913184), VM_C(-0.182144224644)},
        {VM_C(5.60970860874e-8), VM_C(-5.31121986569e-5), VM_C(1.25926077366), VM_C(-0.49462890625),
         VM_C(0.328126132488), VM_C(-0.246559679508), VM_C(0.1941909343), VM_C(-0.156104117632)},
        {VM_C(-5.62774804536e-9), VM_C(-1.99840833375e-5), VM_C(1.24411511421), VM_C(-0.474853515625),
         VM_C(0.306102871895), VM_C(-0.223741680384), VM_C(0.171549126506), VM_C(-0.134323045611)},
        {VM_C(4.4134949917e-8), VM_C(4.36492118752e-5), VM_C(1.22956752777), VM_C(-0.456420898438),
         VM_C(0.28609251976), VM_C(-0.203552216291), VM_C(0.15203012526), VM_C(-0.116021551192)},
        {VM_C(-5.23592902368e-8), VM_C(1.21193716041e-5), VM_C(1.21557915211), VM_C(-0.439086914063),
         VM_C(0.267865926027), VM_C(-0.185632944107), VM_C(0.13514059782), VM_C(-0.10057720542)},
        {VM_C(-4.41200000978e-8), VM_C(-9.43045961321e-6), VM_C(1.20211410522), VM_C(-0.4228515625),
         VM_C(0.25122487545), VM_C(-0.169681489468), VM_C(0.120474494994), VM_C(-0.0874902382493)},
        {VM_C(-3.62614827054e-8), VM_C(-4.94801242894e-5), VM_C(1.1891399622), VM_C(-0.407592773438),
         VM_C(0.235997214913), VM_C(-0.155441656709), VM_C(0.107696071267), VM_C(-0.0763572379947)},
        {VM_C(7.59780593995e-9), VM_C(-2.44868770096e-5), VM_C(1.1766269207), VM_C(-0.393310546875),
         VM_C(0.222032934427), VM_C(-0.14269554615), VM_C(0.0965264216065), VM_C(-0.0668509155512)},
        {VM_C(-2.81232583887e-8), VM_C(1.82539806701e-5), VM_C(1.16454780102), VM_C(-0.3798828125),
         VM_C(0.209200963378), VM_C(-0.131257086992), VM_C(0.0867328941822), VM_C(-0.0587044730783)},
        {VM_C(4.78137884841e-8), VM_C(2.37721287704e-5), VM_C(1.15287733078), VM_C(-0.3671875),
         VM_C(0.197386369109), VM_C(-0.120966844261), VM_C(0.078120611608), VM_C(-0.0516994297504)},
        {VM_C(3.17865236354e-8), VM_C(5.24287679582e-5), VM_C(1.1415926218), VM_C(-0.355224609375),
         VM_C(0.186488091946), VM_C(-0.111687757075), VM_C(0.0705257132649), VM_C(-0.0456560701132)},
        {VM_C(-3.79207101275e-8), VM_C(3.65809064533e-5), VM_C(1.13067233562), VM_C(-0.343872070313),
         VM_C(0.176417022943), VM_C(-0.103301569819), VM_C(0.0638098716736), VM_C(-0.0404259450734)},
        {VM_C(-5.54381642814e-8), VM_C(2.54162623605e-5), VM_C(1.1200966835), VM_C(-0.333129882813),
         VM_C(0.167094364762), VM_C(-0.0957059562206), VM_C(0.0578559227288), VM_C(-0.0358859486878)},
        {VM_C(-1.43732159508e-9), VM_C(-5.85865855101e-5), VM_C(1.10984742641), VM_C(-0.322875976563),
         VM_C(0.158450245857), VM_C(-0.0888120904565), VM_C(0.052564278245), VM_C(-0.0319335833192)},
        {VM_C(3.94520576208e-8), VM_C(-5.29258613824e-5), VM_C(1.09990775585), VM_C(-0.313232421875),
         VM_C(0.150422587991), VM_C(-0.0825426504016), VM_C(0.0478499978781), VM_C(-0.0284831952304)},
        {VM_C(-4.35519798003e-9), VM_C(-4.29039828305e-5), VM_C(1.0902620554), VM_C(-0.304077148438),
         VM_C(0.142956092954), VM_C(-0.0768301561475), VM_C(0.0436404161155), VM_C(-0.0254629570991)},
        {VM_C(5.80705474817e-8), VM_C(4.97953897138e-6), VM_C(1.0808955431), VM_C(-0.29541015625),
         VM_C(0.136001393199), VM_C(-0.0716155171394), VM_C(0.0398731715977), VM_C(-0.0228124260902)},
        {VM_C(-1.24423609194e-8), VM_C(-7.65792549373e-7), VM_C(1.07179486752), VM_C(-0.287109375),
         VM_C(0.12951426208), VM_C(-0.0668468922377), VM_C(0.036494590342), VM_C(-0.0204805657268)},
        {VM_C(-1.7907249017e-8), VM_C(-3.21765874105e-5), VM_C(1.06294715405), VM_C(-0.279174804688),
         VM_C(0.12345508486), VM_C(-0.0624786838889), VM_C(0.0334583483636), VM_C(-0.0184241514653)},
        {VM_C(3.28148419548e-9), VM_C(5.84320696362e-5), VM_C(1.05434060097), VM_C(-0.271728515625),
         VM_C(0.117788255215), VM_C(-0.0584706664085), VM_C(0.0307243522257), VM_C(-0.0166064593941)},
        {VM_C(-5.48685150648e-8), VM_C(5.04213712702e-5), VM_C(1.04596424103), VM_C(-0.264526367188),
         VM_C(0.112481698394), VM_C(-0.0547872930765), VM_C(0.0282578039914), VM_C(-0.0149961989373)},
        {VM_C(4.81906354821e-8), VM_C(-3.46110646205e-5), VM_C(1.0378074646), VM_C(-0.257568359375),
         VM_C(0.107506483793), VM_C(-0.0513970814645), VM_C(0.0260284338146), VM_C(-0.0135666290298)},
        {VM_C(8.52041726063e-9), VM_C(-5.47167473997e-5), VM_C(1.02986085415), VM_C(-0.2509765625),
         VM_C(0.102836459875), VM_C(-0.0482720695436), VM_C(0.0240098442882), VM_C(-0.0122948372737)},
        {VM_C(-5.39812805567e-10), VM_C(8.42707686388e-6), VM_C(1.02211511135), VM_C(-0.244750976563),
         VM_C(0.0984479561448), VM_C(-0.045387391001), VM_C(0.0221789553761), VM_C(-0.0111611364409)},
        {VM_C(2.92974462468e-8), VM_C(-1.13718360808e-5), VM_C(1.01456165314), VM_C(-0.238708496094),
         VM_C(0.0943195074797), VM_C(-0.0427208766341), VM_C(0.0205155480653), VM_C(-0.0101485708728)},
        {VM_C(1.85000939013e-8), VM_C(2.3590579076e-5), VM_C(1.00719249249), VM_C(-0.232971191406),
         VM_C(0.0904316008091), VM_C(-0.0402527339756), VM_C(0.0190018657595), VM_C(-9.24249459058e-3)},
        {VM_C(1.86536877897e-15), VM_C(5.71442706132e-6), VM_C(1.0), VM_C(-0.227416992188), VM_C(0.086766473949),
         VM_C(-0.0379652455449), VM_C(0.0176222808659), VM_C(-8.43023415655e-3)}};
#endif
    return VM_READ(table[row][column]);
}

/* Returns g(q) = Pi_alpha - (alpha + 1), where q = 1/(alpha + 1). g lies between 2 ln 2 (for q = 0) and 1 (for q = 1)
   and has an absolute error below 2^-62.5 (float 2^-33.5). g is computed as a polynomial in the distance h of q from
   the nearest multiple of 1/32. The low word of the result may be as large as 2^-13. */
VM_INLINE vm_two vmi_ateb_g(vm_two q)
{
#if VM_MANT_DIG > 24
    const vm_real to_row = VM_C(211106232532992.0); /* 1.5 2^47; adding it rounds a number to a multiple of 1/32 */
#else
    const vm_real to_row = VM_C(393216.0); /* 1.5 2^18; adding it rounds a number to a multiple of 1/32 */
#endif
    enum { S = VMI_ATEB_G_SERIES };
    const vm_real shifted = vmi_rounded(q.hi + to_row), h = q.hi - vmi_rounded(shifted - to_row);
    const vm_real h_head = vmi_head(h), hh = (h + q.lo) * (h + q.lo);
    const int row = (int)(vmi_to_bits(shifted) & 63);
    const vm_real slope = vmi_ateb_g_constant(row, VMI_ATEB_G_SLOPE);
    vm_two g = vmi_fast_two_sum(vmi_ateb_g_constant(row, VMI_ATEB_G_VALUE), slope * h_head); /* the product is exact */
    vm_real series = (vmi_ateb_g_constant(row, S) + h * vmi_ateb_g_constant(row, S + 1)) +
                     hh * (vmi_ateb_g_constant(row, S + 2) + h * vmi_ateb_g_constant(row, S + 3));
#if VM_MANT_DIG > 24
    series += (hh * hh) * ((vmi_ateb_g_constant(row, S + 4) + h * vmi_ateb_g_constant(row, S + 5)) +
                           hh * (vmi_ateb_g_constant(row, S + 6) + h * vmi_ateb_g_constant(row, S + 7)));
#endif
    g.lo += (slope * ((h - h_head) + q.lo) + vmi_ateb_g_constant(row, VMI_ATEB_G_SLOPE_LOW) * h +
             vmi_ateb_g_constant(row, VMI_ATEB_G_LOW)) +
            hh * series;
    return g;
}

/* The numbers from which sa, ca and Pi_alpha are computed for one alpha. Each low word is below an ulp of its high
   word, unless the comment of the function that sets it says otherwise. */
typedef struct VM_TAG(vmi_ateb) {
    vm_two n;       /* alpha + 1 */
    vm_two q;       /* 1/(alpha + 1) */
    vm_two g;       /* Pi_alpha - (alpha + 1) */
    vm_two quarter; /* Pi_alpha/2, a quarter of the period */
} vmi_ateb;

/* Sets the fields n = alpha + 1 and q = 1/n, and sets g and quarter to 0. The remainder 1 - n q is computed from the
   halves of n and q: the product of the first halves is exact. */
VM_INLINE void vmi_ateb_index_constants(vmi_ateb *c, vm_real alpha)
{
    vm_real n_head, n_tail, q_head;
    c->n = vmi_two_sum(alpha, 1);
    c->q.hi = 1 / c->n.hi;
    c->g = vmi_two(0, 0);
    c->quarter = vmi_two(0, 0);
    n_head = vmi_head(c->n.hi);
    q_head = vmi_head(c->q.hi);
    n_tail = (c->n.hi - n_head) + c->n.lo;
    c->q.lo = (((1 - n_head * q_head) - n_tail * q_head) - c->n.hi * (c->q.hi - q_head)) * c->q.hi;
}

/* Sets the fields g and quarter, whose low words may be as large as 2^-13. Where an argument is reduced by multiples of
   Pi_alpha/2, the absolute error of Pi_alpha is important. This error is small for a large alpha too, since Pi_alpha is
   computed as the sum of n = alpha + 1 and g. */
VM_INLINE void vmi_ateb_period_constants(vmi_ateb *c)
{
    c->g = vmi_ateb_g(c->q);
    c->quarter = vmi_fast_two_sum(c->n.hi, c->g.hi); /* exact, as n >= 1 and g < 2 */
    c->quarter.lo += c->n.lo + c->g.lo;
    c->quarter = vmi_half(c->quarter);
}

/* Sets the fields n, q, g and quarter. Each low word is below an ulp of its high word. */
VM_API void vmi_ateb_constants(vmi_ateb *c, vm_real alpha)
{
    vmi_ateb_index_constants(c, alpha);
    vmi_ateb_period_constants(c);
    c->g = vmi_fast_two_sum(c->g.hi, c->g.lo);
    c->quarter = vmi_fast_two_sum(c->quarter.hi, c->quarter.lo);
}

/* Pi_alpha, half the period of sa and ca, for alpha >= 0. Pi_alpha = B(1/(alpha + 1), 1/2) is a pure number: 2 for
   alpha = 0, pi for alpha = 1, and close to alpha + 1 + 2 ln 2 for a large alpha. The error is at most 1 ulp. Returns
   NaN for alpha < 0, NaN and infinite alpha. docs/cost.md has the time of a call. Equation (277). */
VM_API vm_real ateb_pi(vm_real alpha)
{
    vmi_ateb c;
    if (!(alpha >= 0) || !VM_IS_FINITE(alpha)) return VM_NAN;
    vmi_ateb_index_constants(&c, alpha);
    vmi_ateb_period_constants(&c);
    return 2 * vmi_fast_two_sum(c.quarter.hi, c.quarter.lo).hi;
}

/* Returns 1 if alpha is so large that three terms of the Taylor series of g(q) at q = 0 give the quarter period in two
   words, else 0. */
VM_API int vmi_ateb_is_large(const vmi_ateb *c) { return 8 * c->q.hi < VM_SQRT(VM_EPSILON); }

/* Returns g(q) = Pi_alpha - (alpha + 1) in two words for a large alpha: 2 ln 2 + q g'(0) + q^2 g''(0)/2. The product
   with g'(0) is in two words, too: in float one word is not enough next to a zero of ca. */
VM_API vm_two vmi_ateb_g_of_large(vm_two q)
{
#if VM_MANT_DIG > 24
    const vm_two two_ln2 = {VM_C(1.386294361119890618835), VM_C(4.638093627692599231e-17)};
    const vm_two slope = {VM_C(-0.6840280390118236297781), VM_C(4.2639853945799391236e-17)};
#else
    const vm_two two_ln2 = {VM_C(1.386294361119890618835), VM_C(-3.80930859992e-9)};
    const vm_two slope = {VM_C(-0.68402802944183349609), VM_C(-9.56999009104446e-9)};
#endif
    vm_two product = vmi_two_times(q, slope);
    product.lo += q.hi * q.hi * VM_C(0.5677838543520556957);
    return vmi_two_plus(two_ln2, product);
}

/* Returns Pi_alpha/2 with a relative error below 2^-98.6 (float 2^-40.6). Let n = alpha + 1 and q = 1/n. For a large
   alpha Pi_alpha is n + g(q); for any other alpha it is n f(q), where f is vmi_ateb_gamma_ratio. */
VM_API vm_two vmi_ateb_fine_quarter(const vmi_ateb *c)
{
    const vm_two one = {1, 0};
    if (vmi_ateb_is_large(c)) return vmi_half(vmi_two_plus(c->n, vmi_ateb_g_of_large(c->q)));
    return vmi_half(vmi_two_times(c->n, vmi_ateb_gamma_ratio(vmi_two_over(one, c->n))));
}

/* Returns Pi_alpha/2 in three words, with a relative error of 2^-122 (float 2^-52), from the fields n and q of *c. For
   alpha = 0 it is exact: then n = 1, Pi_alpha/2 = 1, and the zeros of sa and ca are the integers. */
VM_API vmi_three vmi_ateb_quarter_in_words(const vmi_ateb *c)
{
    vm_two g;
    if (c->n.hi == 1 && c->n.lo == 0) return vmi_three_words(1, 0, 0);
    if (!vmi_ateb_is_large(c)) return vmi_ateb_finest_quarter(c->n);
    g = vmi_ateb_g_of_large(c->q);
    return vmi_three_plus(vmi_three_words(c->n.hi / 2, c->n.lo / 2, 0), vmi_three_words(g.hi / 2, g.lo / 2, 0));
}

/* A function that sets all constants of one alpha: vmi_ateb_constants, or vmi_ateb_fine_constants */
typedef void (*vmi_ateb_constants_of)(vmi_ateb *c, vm_real alpha);

/* Sets the fields n, q, g and quarter, as vmi_ateb_constants does, but without the table of g: the code is shorter and
   the results are more accurate, but the function takes longer. */
VM_API void vmi_ateb_fine_constants(vmi_ateb *c, vm_real alpha)
{
    vmi_ateb_index_constants(c, alpha);
    c->quarter = vmi_ateb_fine_quarter(c);
    c->g = vmi_two_minus(vmi_two_scaled(c->quarter, 2), c->n);
    if (vmi_ateb_is_large(c)) c->g = vmi_ateb_g_of_large(c->q);
}

#endif
