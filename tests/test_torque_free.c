/* Torque-free rotation at any time. The oracles are published digits and tables of 60-digit values up to 1e6 turns,
   what the motion keeps, the elementary solutions of special bodies, and integration by Runge-Kutta. At the end, what
   is refused. */
#include "../varmass.h"
#include "check.h"
#include <stdlib.h>

#define R(x) ((vm_real)(x))
static const double eps = (double)VM_EPSILON;
static const int is_float = PRECISION[0] == 'f';

typedef struct row {
    double inertia[6], q[4], omega[3], t, end_q[4], end_omega[3], m1;
} row;

/* Published bodies A to I: omega in body axes and the attitude at the start, and after 1.25 s, 100 turns and 1e6
   turns. The attitude's sign is that of a continuous motion. F is on the separatrix. */
static const struct {
    char name;
    double moments[3], omega[3], q[4], t, end_omega[3], end_q[4];
} published[] = {
    {'A',
     {3, 2, 1},
     {0.25, 0.5, 1.5},
     {1, 0, 0, 0},
     1.25,
     {0.36836773997131741051, -0.17440075815566755732, 1.5714911312364216954},
     {0.53796870105491158702, 0.24633938947397675221, 0.10720472358172815768, 0.79900796561776830578}},
    {'A',
     {3, 2, 1},
     {0.25, 0.5, 1.5},
     {1, 0, 0, 0},
     393,
     {-0.14765629737330156899, -0.60999414221615391553, 1.4587347759143807399},
     {0.45975436532698866161, -0.25769957925724895515, 0.12285081368660624519, 0.84090696749994494837}},
    {'A',
     {3, 2, 1},
     {0.25, 0.5, 1.5},
     {1, 0, 0, 0},
     3925075,
     {-0.29241172423973852785, -0.42542467086598225914, 1.5228308669772131545},
     {-0.37942006683890861395, 0.26811831929241831951, -0.24621756761263742005, -0.85060560140330798489}},
    {'B',
     {2, 1, 3},
     {-0.5, 0.375, -1.25},
     {0.5, 0.5, -0.5, 0.5},
     1.25,
     {0.38501447912876557404, 0.49233002230333804637, -1.2634956603092872433},
     {0.81930267872563018686, 0.55214778613055491128, 0.14211533168204592296, 0.060656206648914937666}},
    {'B',
     {2, 1, 3},
     {-0.5, 0.375, -1.25},
     {0.5, 0.5, -0.5, 0.5},
     450,
     {-0.45809319799930598170, 0.42517716536376767905, -1.2553420014676968029},
     {-0.62825474781360916470, -0.28128396086685239034, -0.43631082328131689357, 0.57948957772879130855}},
    {'B',
     {2, 1, 3},
     {-0.5, 0.375, -1.25},
     {0.5, 0.5, -0.5, 0.5},
     4495881,
     {0.057692204062856001337, 0.62233159134851075106, -1.2824678825855470888},
     {0.48512551873573576723, 0.28142847594728494210, 0.58104967613668329113, -0.58977327665707879700}},
    {'C',
     {1, 1.75, 2},
     {1, -0.75, 0.25},
     {0.6, 0, 0.8, 0},
     1.25,
     {1.0768222817394410479, -0.44477287571321509067, 0.54938086941192649241},
     {0.71042876143078412029, 0.53872470205669852519, 0.34121402595352480200, -0.29772413207268020819}},
    {'C',
     {1, 1.75, 2},
     {1, -0.75, 0.25},
     {0.6, 0, 0.8, 0},
     493,
     {1.0064492098812307665, -0.73001563651268465132, 0.28619926293725940750},
     {-0.18303855420939887554, 0.31179440207161411428, -0.92309683026199103914, -0.13104724518280607408}},
    {'C',
     {1, 1.75, 2},
     {1, -0.75, 0.25},
     {0.6, 0, 0.8, 0},
     4928936,
     {1.1159453192320935261, 0.041673410062556562663, 0.65612569929399099379},
     {-0.39268134718888950808, 0.093908739598489011590, -0.80828033935745692315, 0.42856201558833497807}},
    {'D',
     {6, 4, 3},
     {1, -0.5, 2.000000000000001},
     {1, 0, 0, 0},
     1.25,
     {0.59537149487544385649, -1.7762031201143654628, 1.1907429897508892048},
     {0.19380797946141700446, 0.52233982479449679786, -0.54598856449011984989, 0.62569646153446927617}},
    {'D',
     {6, 4, 3},
     {1, -0.5, 2.000000000000001},
     {1, 0, 0, 0},
     274,
     {-0.000014379554774519955448, 2.1794494715568718181, 0.000028759171315727395062},
     {-0.082476542645472081003, 0.47580730147554154388, 0.61521375051745228109, 0.62315092309171999660}},
    {'D',
     {6, 4, 3},
     {1, -0.5, 2.000000000000001},
     {1, 0, 0, 0},
     2742207,
     {-0.023074228654643012842, 2.1788997475501183854, 0.046148457309324517909},
     {-0.46192519557694711252, -0.052833027081018992045, 0.40139425356109617581, 0.78912384208613663173}},
    {'E',
     {3, 6, 4},
     {1.9999999999999991, -1, 0.5},
     {1, 0, 0, 0},
     1.25,
     {1.1907429897508874839, -0.59537149487544448785, 1.7762031201143645105},
     {0.19380797946141791339, 0.62569646153446897723, -0.52233982479449691145, 0.54598856449011976116}},
    {'E',
     {3, 6, 4},
     {1.9999999999999991, -1, 0.5},
     {1, 0, 0, 0},
     274,
     {-0.000028759109549042247203, -0.000014379585657864865681, -2.1794494715568709012},
     {0.082487418696011708069, -0.62314401819980653174, 0.47581257376881459835, 0.61521520867267610981}},
    {'E',
     {3, 6, 4},
     {1.9999999999999991, -1, 0.5},
     {1, 0, 0, 0},
     2742207,
     {-0.046148457346980667772, -0.023074228673509579999, -2.1788997475492193116},
     {-0.47350155068176939776, 0.77521462039535791177, 0.053780977820134674562, -0.41466393652203597644}},
    {'F',
     {6, 4, 3},
     {1, 0.5, 2},
     {1, 0, 0, 0},
     1.25,
     {0.83106095909942783066, -1.2814131145627182712, 1.6621219181988556613},
     {0.18827393825635094718, 0.61712843934702248467, -0.19294550920519531527, 0.73924112710272013889}},
    {'F',
     {6, 4, 3},
     {1, 0.5, 2},
     {1, 0, 0, 0},
     5,
     {0.068578371824423839774, -2.1745888188645226769, 0.13715674364884767955},
     {0.43416287455226414075, -0.78366765297201015414, 0.44029717159288978955, -0.059211559117771757496}},
    {'F',
     {6, 4, 3},
     {1, 0.5, 2},
     {1, 0, 0, 0},
     30,
     {8.8916235329770410829e-10, -2.1794494717703367753, 1.7783247065954082166e-9},
     {0.18045635101864467100, 0.36927496410672099434, -0.59390877926813678046, 0.69162408009644025469}},
    {'F',
     {6, 4, 3},
     {1, 0.5, 2},
     {1, 0, 0, 0},
     274,
     {9.2282686038565429828e-87, -2.1794494717703367761, 1.8456537207713085966e-86},
     {-0.61521447961596812557, 0.47580993763012138026, 0.082481980671978632816, -0.62314747065819089712}},
    {'F',
     {6, 4, 3},
     {1, 0.5, 2},
     {1, 0, 0, 0},
     2742207,
     {0, -2.1794494717703367761, 0},
     {0.46774286883757439406, -0.78221855769671680332, 0.40805482685089609643, 0.053310364190736949157}},
    {'G',
     {2, 1.5, 2},
     {0.5, 1.25, -0.75},
     {0.5, -0.5, 0.5, 0.5},
     1.25,
     {0.74791043747781069329, 1.2500000000000000000, -0.50312024160408197785},
     {0.31881818837310663370, -0.61061331752476089158, 0.60913050948084916802, -0.39302208798424669374}},
    {'G',
     {2, 1.5, 2},
     {0.5, 1.25, -0.75},
     {0.5, -0.5, 0.5, 0.5},
     408,
     {0.59252685646046671989, 1.2500000000000000000, 0.67927308527062771304},
     {-0.14978279668215402258, 0.27856223047695502770, 0.36062054359643603305, -0.87745143518372985558}},
    {'G',
     {2, 1.5, 2},
     {0.5, 1.25, -0.75},
     {0.5, -0.5, 0.5, 0.5},
     4077069,
     {-0.65690895319856060018, 1.2500000000000000000, -0.61722818082745648322},
     {-0.65500880709157049743, 0.71941799785041834842, -0.13276165130258108499, -0.18914425961362167952}},
    {'H',
     {2, 2.0000000009313226, 1},
     {0.5, 0.25, 1},
     {1, 0, 0, 0},
     1.25,
     {0.55175587807922614399, -0.089807856455136045714, 0.99999999994930387573},
     {0.75633120027701710341, 0.33289148480659200234, 0.050702450669492838023, 0.56087042739557664680}},
    {'H',
     {2, 2.0000000009313226, 1},
     {0.5, 0.25, 1},
     {1, 0, 0, 0},
     548,
     {-0.54581133824773193818, 0.12078900242633629389, 0.99999999995538031970},
     {-0.69537168973837511116, 0.087977283819909709267, -0.71207283136030141160, 0.040871670880840948660}},
    {'H',
     {2, 2.0000000009313226, 1},
     {0.5, 0.25, 1},
     {1, 0, 0, 0},
     5484414,
     {-0.086134084188498637804, 0.55234130680415981316, 1.0000000002259210863},
     {0.15210350434136442450, -0.27742301157039645846, -0.53782622154559315217, -0.78143710689746411519}},
    {'I',
     {3, 2, 1},
     {9.094947017729282e-13, 1, 4.547473508864641e-13},
     {1, 0, 0, 0},
     1.25,
     {1.3631617505540132305e-12, 1.0000000000000000000, 1.8165580612795230069e-12},
     {0.81096311950521790219, 7.2119925397128619167e-13, 0.58509727294046215481, 6.0816408449048377651e-13}},
    {'I',
     {3, 2, 1},
     {9.094947017729282e-13, 1, 4.547473508864641e-13},
     {1, 0, 0, 0},
     628,
     {0.00014110246409771418119, 0.99999997013514149238, 0.00024439663689040435762},
     {-0.98734405128129439162, 0.000077109279790562483016, 0.15859290484448410078, -0.000094797616490380563968}},
    {'I',
     {3, 2, 1},
     {9.094947017729282e-13, 1, 4.547473508864641e-13},
     {1, 0, 0, 0},
     6283185,
     {0.0081874506421792227829, -0.99989944342216014512, -0.014181080496716845822},
     {0.0044430757668548621612, 0.98820341261602649460, 0.0055260624898929002021, 0.15298279970351919821}},
};

/* Published constants of these motions: kappa, wp, K and u0 */
static const struct {
    char name;
    double kappa, wp, K, u0;
} inner[] = {
    {'A', 0.849820456418522255, 0.912870929175276856, 1.64723410965519037, -0.873715404265269026},
    {'B', 0.666830865599880377, 1.28290035986172104, 1.60332774146893322, -0.936362375553496532},
    {'C', 0.706230175722829695, 0.516739866166443835, 1.675563028529923, -1.23366701506392971},
    {'D', 1.10494665215754152, 0.726483157256779231, 18.7420074857536653, 0.233572654051631007},
    {'E', 1.07450281961279527, 0.726483157256778925, 18.7420074857536651, 0.233572654051631109},
    {'H', 0.625000000012126596, 0.500000000232830643, 1.57079632702347757, 1.10714871761759741},
    {'I', 0.494716215716175608, 0.577350269189625765, 28.606381127678463, -28.3092607760100124},
};

static vm_vec3 vector(const double *x) { return vmi_vec3(R(x[0]), R(x[1]), R(x[2])); }
static vm_vec3 random_vector(double size)
{
    double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return vmi_vec3(R(x), R(y), R(z));
}
static double size_of(vm_vec3 a) { return sqrt((double)vm_dot(a, a)); }

static vm_quat quaternion(const double *x)
{
    vm_quat q;
    q.w = R(x[0]);
    q.x = R(x[1]);
    q.y = R(x[2]);
    q.z = R(x[3]);
    return q;
}
static double length_of(vm_quat q)
{
    return sqrt((double)q.w * (double)q.w + (double)q.x * (double)q.x + (double)q.y * (double)q.y +
                (double)q.z * (double)q.z);
}

/* In radians: twice the distance of the quaternions, the first scaled to unit length; sign included */
static double attitude_error(vm_quat q, const double *r)
{
    const double n = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    const double w = (double)q.w - r[0], x = (double)q.x - r[1], y = (double)q.y - r[2], z = (double)q.z - r[3];
    return 2 * sqrt(w * w + x * x + y * y + z * z) / n;
}
static double difference(vm_quat p, vm_quat q)
{
    const double r[4] = {(double)q.w, (double)q.x, (double)q.y, (double)q.z};
    return attitude_error(p, r);
}
static double omega_error(vm_vec3 omega, const double *r)
{
    const double x = (double)omega.x - r[0], y = (double)omega.y - r[1], z = (double)omega.z - r[2];
    return sqrt(x * x + y * y + z * z) / sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
}

/* A body of a few random particles: triaxial, its inertia possible by construction; flat makes it thin */
static vm_body random_body(double flat)
{
    vm_vec3 at[6], centre = vmi_vec3(0, 0, 0);
    vm_body b;
    int i;
    memset(&b, 0, sizeof b);
    for (i = 0; i < 6; i++) {
        at[i] = random_vector(1);
        at[i].z *= R(flat);
        centre = vm_add(centre, vm_scale(R(1. / 6), at[i]));
    }
    for (i = 0; i < 6; i++)
        b.inertia = vmi_inertia_plus(b.inertia, R(1. / 6), vmi_inertia_of_point(vm_sub(at[i], centre)));
    b.mass = R(uniform(0.1, 10));
    b.q.w = R(uniform(-1, 1));
    b.q.x = R(uniform(-1, 1));
    b.q.y = R(uniform(-1, 1));
    b.q.z = R(uniform(-1, 1));
    b.r = random_vector(3);
    b.v = random_vector(5);
    b.omega = random_vector(4);
    return b;
}

static int all_representable(int n, const double *x)
{
    int i;
    for (i = 0; i < n; i++)
        if (!representable(x[i])) return 0;
    return 1;
}

/* The motion's constants, where they are published */
static void check_constants(const vm_torque_free *m, char name, int index)
{
    const double two_pi = 8 * atan(1), K = (double)m->K.hi;
    size_t j;
    for (j = 0; j < sizeof inner / sizeof *inner; j++) {
        if (inner[j].name != name) continue;
        check_error("kappa", "", "eps", fabs(two_pi * fabs((double)m->turn_rate.hi) / inner[j].kappa - 1) / eps, 3,
                    index, 0);
        check_error("wp", "", "eps", fabs(4 * K * (double)m->phase_rate.hi / inner[j].wp - 1) / eps, 3, index, 0);
        check_error("K", "", "eps", fabs(K / inner[j].K - 1) / eps, 3, index, 0);
        check_error("u0", "", "eps", fabs(4 * K * (double)m->phase.hi / inner[j].u0 - 1) / eps, 3, index, 0);
    }
}

static void test_published(void)
{
    int i;
    for (i = 0; i < (int)(sizeof published / sizeof *published); i++) {
        vm_torque_free m;
        vm_quat q;
        vm_vec3 omega;
        if (!all_representable(3, published[i].moments) || !all_representable(3, published[i].omega)) continue;
        CHECK(vm_torque_free_init_principal(&m, vector(published[i].moments), quaternion(published[i].q),
                                     vector(published[i].omega), 0) == VM_OK);
        CHECK(vm_torque_free_attitude(&m, R(published[i].t), &q, &omega) == VM_OK);
        check_error("published", "attitude", "eps", attitude_error(q, published[i].end_q) / eps, 8, published[i].t,
                    published[i].name);
        check_error("published", "omega", "eps", omega_error(omega, published[i].end_omega) / eps, 5, published[i].t,
                    published[i].name);
        check_constants(&m, published[i].name, i);
    }
}

/* Rows with products of inertia are bodies, with omega along the inertial axes; the others have omega along body
 * axes. */
static void test_table(const row *r, int rows, const char *region)
{
    int i;
    for (i = 0; i < rows; i++, r++) {
        vm_torque_free m;
        vm_body b;
        if (!representable(r->t) || !all_representable(6, r->inertia)) continue;
        if (!all_representable(4, r->q) || !all_representable(3, r->omega)) continue;
        memset(&b, 0, sizeof b);
        b.mass = 1;
        b.inertia.xx = R(r->inertia[0]);
        b.inertia.yy = R(r->inertia[1]);
        b.inertia.zz = R(r->inertia[2]);
        b.inertia.xy = R(r->inertia[3]);
        b.inertia.xz = R(r->inertia[4]);
        b.inertia.yz = R(r->inertia[5]);
        b.q = quaternion(r->q);
        b.omega = vector(r->omega);
        if (r->inertia[3] == 0) {
            CHECK(vm_torque_free_init_principal(&m, vector(r->inertia), b.q, b.omega, 0) == VM_OK);
            CHECK(vm_torque_free_attitude(&m, R(r->t), &b.q, &b.omega) == VM_OK);
        } else CHECK(vm_torque_free_rotation(&b, R(r->t), &b) == VM_OK);
        check_error("attitude", region, "eps", attitude_error(b.q, r->end_q) / eps, 8, r->t, r->m1);
        check_error("omega", region, "eps", omega_error(b.omega, r->end_omega) / eps, 5, r->t, r->m1);
    }
}

static void test_tables(void)
{
#define TABLE(name) test_table(name, (int)(sizeof name / sizeof *name), #name)
#include "data/rotation_table.h"
    TABLE(tensor);
    TABLE(plain);
    TABLE(needle);
    TABLE(alike);
    TABLE(separatrix);
    TABLE(middle);
#undef TABLE
}

static vm_quat conjugate(vm_quat q)
{
    q.x = -q.x;
    q.y = -q.y;
    q.z = -q.z;
    return q;
}

/* 2 q' conj(q)/|q|^2 - omega halfway from a to b, a time h apart, over the size of what is left out */
static double kinematic_defect(const vm_body *a, const vm_body *b, vm_real h)
{
    const vm_quat turn = vm_quat_times(b->q, conjugate(a->q));
    const vm_real n = R(length_of(a->q));
    const vm_vec3 rate = vm_scale(2 / (h * n * n), vmi_vec3(turn.x, turn.y, turn.z));
    const vm_vec3 mean = vm_scale(R(0.5), vm_add(a->omega, b->omega));
    return size_of(vm_sub(rate, mean)) / pow(size_of(a->omega), 3) / (double)(h * h);
}

/* The motion keeps angular momentum, energy and the length of q. The mass centre moves along a straight line, and
   omega is the rate of the attitude. */
static void test_conserved(void)
{
    int i;
    for (i = 0; i < 2000; i++) {
        const vm_body b = random_body(i % 3 ? 1 : 0.01);
        vm_body at, after;
        const vm_real t0 = R(uniform(-5, 5)), t = R(uniform(-10, 10)), h = R(is_float ? 1. / 32 : 1. / 1024);
        const vm_vec3 L = vmi_spin_momentum(&b);
        const double energy = (double)vm_dot(b.omega, L);
        vm_torque_free m;
        CHECK(vm_torque_free_init(&m, &b, t0) == VM_OK);
        CHECK(vm_torque_free_at(&m, t, &at) == VM_OK);
        check_error("J omega", "kept", "eps", size_of(vm_sub(vmi_spin_momentum(&at), L)) / size_of(L) / eps, 20, i,
                    0);
        check_error("energy", "kept", "eps",
                    fabs((double)vm_dot(at.omega, vmi_spin_momentum(&at)) / energy - 1) / eps, 40, i, 0);
        check_error("|q|", "kept", "eps", fabs(length_of(at.q) / length_of(b.q) - 1) / eps, 5, i, 0);
        CHECK(size_of(vm_sub(at.r, vm_add(b.r, vm_scale(t - t0, b.v)))) <=
              2 * eps * (size_of(b.r) + fabs((double)(t - t0)) * size_of(b.v)));
        CHECK(at.mass == b.mass && size_of(vm_sub(at.v, b.v)) == 0);
        CHECK(memcmp(&at.inertia, &b.inertia, sizeof b.inertia) == 0);
        CHECK(vm_torque_free_at(&m, t + h, &after) == VM_OK);
        check_error("2 q'/q", "is omega", "h^2", kinematic_defect(&at, &after, (t + h) - t), is_float ? 8 : 1, i, 0);
        CHECK(vm_torque_free_at(&m, t0, &after) == VM_OK);
        check_error("attitude", "at t0", "eps", difference(after.q, b.q) / eps, 12, i, 0);
        check_error("omega", "at t0", "eps", size_of(vm_sub(after.omega, b.omega)) / size_of(b.omega) / eps, 12, i,
                    0);
    }
}

/* Stopped midway and prepared anew, the motion goes on as it would have; and run back, it comes back. */
static void check_stop_and_return(const vm_body *b, vm_real first, vm_real second, double scale, int i)
{
    vm_body midway, end, all;
    CHECK(vm_torque_free_rotation(b, first, &midway) == VM_OK);
    CHECK(vm_torque_free_rotation(&midway, second, &end) == VM_OK);
    CHECK(vm_torque_free_rotation(b, first + second, &all) == VM_OK);
    check_error("t1 + t2", "attitude", "eps*", difference(end.q, all.q) / scale, 15, i, 0);
    check_error("t1 + t2", "omega", "eps*", size_of(vm_sub(end.omega, all.omega)) / size_of(b->omega) / scale, 12, i,
                0);
    CHECK(vm_torque_free_rotation(&midway, -first, &midway) == VM_OK); /* outputs may be the inputs */
    /* on the way back a change of midway.omega by eps of its length moves the attitude by up to 13 units (i = 40) */
    check_error("back", "attitude", "eps*", difference(midway.q, b->q) / scale, 30, i, 0);
}

/* With omega and time reversed the attitude goes the same way. */
static void check_reversed(const vm_body *b, const vm_body *later, vm_real t, int i)
{
    vm_body other = *b;
    other.omega = vm_scale(-1, b->omega);
    CHECK(vm_torque_free_rotation(&other, -t, &other) == VM_OK);
    check_error("reversed", "attitude", "eps", difference(later->q, other.q) / eps, 12, i, 0);
    check_error("reversed", "omega", "eps", size_of(vm_add(later->omega, other.omega)) / size_of(b->omega) / eps, 12,
                i, 0);
}

/* In other body axes, x, y, z for y, z, x, the motion is the same; (1 + i + j + k)/2 turns to the old axes. */
static void check_renamed(const vm_body *b, const vm_body *later, vm_real t, double scale, int i)
{
    vm_body other = *b;
    other.inertia.xx = b->inertia.yy;
    other.inertia.yy = b->inertia.zz;
    other.inertia.zz = b->inertia.xx;
    other.inertia.xy = b->inertia.yz;
    other.inertia.yz = b->inertia.xz;
    other.inertia.xz = b->inertia.xy;
    other.q.w = other.q.x = other.q.y = other.q.z = R(0.5);
    other.q = vm_quat_times(b->q, other.q);
    CHECK(vm_torque_free_rotation(&other, t, &other) == VM_OK);
    check_error("renamed", "omega", "eps*", size_of(vm_sub(later->omega, other.omega)) / size_of(b->omega) / scale,
                60, i, 0);
}

/* In units that are powers of two, the motion has the same bits. */
static void check_units(const vm_body *b, const vm_body *later, vm_real t, vm_real unit)
{
    vm_body other = *b;
    memset(&other.inertia, 0, sizeof other.inertia);
    other.inertia = vmi_inertia_plus(other.inertia, unit * unit, b->inertia);
    other.omega = vm_scale(unit, b->omega);
    CHECK(vm_torque_free_rotation(&other, t / unit, &other) == VM_OK);
    CHECK(difference(later->q, other.q) == 0);
    CHECK(size_of(vm_sub(vm_scale(unit, later->omega), other.omega)) == 0);
}

/* One motion in several ways. The time is short, since a rounding of the state between makes an error that grows with
 * it. */
static void test_composition(void)
{
    int i;
    for (i = 0; i < 2000; i++) {
        const vm_body b = random_body(i % 3 ? 1 : 0.03);
        const vm_real first = R(uniform(-3, 3)), second = R(uniform(-3, 3)), unit = R(i % 2 ? 1024. : 1. / 1024);
        const double scale = eps * (1 + size_of(b.omega) * (fabs((double)first) + fabs((double)second)));
        vm_body later;
        check_stop_and_return(&b, first, second, scale, i);
        CHECK(vm_torque_free_rotation(&b, first, &later) == VM_OK);
        check_reversed(&b, &later, first, i);
        check_renamed(&b, &later, first, scale, i);
        check_units(&b, &later, first, unit);
    }
}

/* q0 Exp(v), the elementary solution for constant omega = v/t in body axes */
static vm_quat turned_by(vm_quat q0, double x, double y, double z)
{
    const double angle = sqrt(x * x + y * y + z * z), f = angle > 0 ? sin(angle / 2) / angle : 0;
    const double turn[4] = {cos(angle / 2), x * f, y * f, z * f};
    return vm_quat_times(q0, quaternion(turn));
}

static void check_elementary(const char *name, vm_vec3 J, vm_vec3 omega, vm_quat q0, vm_real t, vm_quat end,
                             vm_vec3 spin)
{
    const double scale = eps * (2 + size_of(omega) * fabs((double)t)); /* the elementary solution's own */
    vm_torque_free m;
    vm_quat q = q0;
    vm_vec3 w = omega;
    CHECK(vm_torque_free_init_principal(&m, J, q0, omega, 1) == VM_OK);
    CHECK(vm_torque_free_attitude(&m, 1 + t, &q, &w) == VM_OK);
    check_error(name, "attitude", "eps*", difference(q, end) / scale, 8, (double)t, (double)omega.z);
    check_error(name, "omega", "eps*", size_of(vm_sub(w, spin)) / (size_of(omega) + 1e-30) / scale, 8, (double)t,
                (double)omega.z);
}

/* With the axes named anew, by 0, 1 or 2 places */
static vm_vec3 permuted(vm_vec3 a, int by)
{
    if (by == 1) return vmi_vec3(a.z, a.x, a.y);
    if (by == 2) return vmi_vec3(a.y, a.z, a.x);
    return a;
}

/* A body that is symmetric about axis z, x or y: it turns about the axis at w_z (Jt - Jz)/Jt, and that axis about J
 * omega. */
static void check_symmetric(double Jt, double Jz, vm_vec3 w, vm_quat q0, vm_real t, int axis)
{
    const double T = (double)t, r = (double)w.z * (Jt - Jz) / Jt * T;
    const double share = Jz / Jt, x = (double)w.x, y = (double)w.y;
    const double spun[3] = {x * cos(r) + y * sin(r), y * cos(r) - x * sin(r), (double)w.z};
    const vm_vec3 about = permuted(vmi_vec3(w.x, w.y, R(share * (double)w.z)), axis);
    const vm_vec3 z = permuted(vmi_vec3(0, 0, 1), axis);
    vm_quat end = turned_by(q0, (double)about.x * T, (double)about.y * T, (double)about.z * T);
    end = turned_by(end, (double)z.x * r, (double)z.y * r, (double)z.z * r);
    check_elementary(Jz > 0 ? "symmetric" : "rod", permuted(vmi_vec3(R(Jt), R(Jt), R(Jz)), axis), permuted(w, axis),
                     q0, t, end, permuted(vector(spun), axis));
}

/* Rest, spheres, points, principal axes, symmetric bodies and rods about each axis by the elementary solutions */
static void test_special(void)
{
    static const double axial[] = {1.5, 0.3, 1 - 1e-3, 2, 1e-6, 0}; /* moments beside 1 across */
    int i, k;
    for (i = 0; i < 300; i++) {
        const double quat[4] = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        const vm_quat q0 = quaternion(quat);
        const vm_vec3 J = vmi_vec3(R(3), R(2.5), R(1)), w = random_vector(2), none = vmi_vec3(0, 0, 0);
        const vm_real t = R((int)uniform(-2000, 2000) / 64.);
        const double T = (double)t;
        const vm_vec3 one = vmi_vec3(i % 3 == 0 ? w.x : 0, i % 3 == 1 ? w.y : 0, i % 3 == 2 ? w.z : 0);
        vm_quat end = turned_by(q0, (double)w.x * T, (double)w.y * T, (double)w.z * T);
        check_elementary("at rest", J, none, q0, t, q0, none);
        check_elementary("sphere", vmi_vec3(2, 2, 2), w, q0, t, end, w);
        check_elementary("point", none, w, q0, t, end, w);
        end = turned_by(q0, (double)one.x * T, (double)one.y * T, (double)one.z * T);
        check_elementary("principal axis", J, one, q0, t, end, one);
        for (k = 0; k < 6; k++) check_symmetric(1, (double)R(axial[k]), w, q0, t, i % 3);
    }
}

/* A rod along any direction, whose inertia is a rod's but for rounding errors, turns at constant omega. */
static void test_tilted_rod(void)
{
    int i;
    for (i = 0; i < 300; i++) {
        const vm_vec3 axis = random_vector(1);
        vm_vec3 side = random_vector(1);
        vm_body b, c;
        memset(&b, 0, sizeof b);
        b.mass = 1;
        b.inertia = vmi_inertia_of_point(axis);
        side = vm_sub(side, vm_scale(vm_dot(side, axis) / vm_dot(axis, axis), axis)); /* across */
        b.omega = side;
        CHECK(vm_torque_free_rotation(&b, R(uniform(0, 3)), &c) == VM_OK);
        check_error("tilted rod", "omega", "eps", size_of(vm_sub(c.omega, side)) / size_of(side) / eps,
                    50 * (1 + size_of(axis)), i, size_of(side));
    }
}

/* Two motions from the same attitude, 2 s on: how far the attitudes are apart */
static double apart_after_2s(vm_vec3 J1, vm_vec3 omega1, vm_vec3 J2, vm_vec3 omega2)
{
    const vm_quat unit = {1, 0, 0, 0};
    vm_torque_free first, second;
    vm_quat p = unit, q = unit;
    vm_vec3 omega;
    CHECK(vm_torque_free_init_principal(&first, J1, unit, omega1, 0) == VM_OK);
    CHECK(vm_torque_free_init_principal(&second, J2, unit, omega2, 0) == VM_OK);
    CHECK(vm_torque_free_attitude(&first, 2, &p, &omega) == VM_OK);
    CHECK(vm_torque_free_attitude(&second, 2, &q, &omega) == VM_OK);
    return difference(p, q);
}

/* Next to the special bodies the motions are next to theirs. */
static void test_limits(void)
{
    const vm_vec3 w = vmi_vec3(R(0.75), R(0.5), R(-1)), J = vmi_vec3(3, 2, 1), F = vmi_vec3(6, 4, 3);
    const vm_vec3 symmetric = vmi_vec3(1, 1, R(1.5)), sphere = vmi_vec3(1, 1, 1),
                  on_separatrix = vmi_vec3(1, R(0.5), 2);
    int k;
    for (k = 4; k < (is_float ? 22 : 50); k++) {
        const double e = ldexp(1, -k), scale = e + 8 * eps;
        double off = apart_after_2s(vmi_vec3(R(1 + e), 1, R(1.5)), w, symmetric, w);
        check_error("limit", "symmetric", "e", off / scale, 3, k, 0);
        off = apart_after_2s(vmi_vec3(R(1 + e), 1, R(1 - e)), w, sphere, w);
        check_error("limit", "sphere", "e", off / scale, 3, k, 0);
        off = apart_after_2s(F, vmi_vec3(1, R(0.5), R(2 * (1 + e))), F, on_separatrix);
        check_error("limit", "separatrix", "e", off / scale, 8, k, 0);
        off = apart_after_2s(F, vmi_vec3(1, R(0.5), R(2 * (1 - e))), F, on_separatrix);
        check_error("limit", "separatrix", "e", off / scale, 8, k, 1);
        off = apart_after_2s(J, vmi_vec3(R(e), 1, R(e)), J, vmi_vec3(0, 1, 0));
        check_error("limit", "middle axis", "e", off / scale, 12, k, 0);
        off = apart_after_2s(J, vmi_vec3(R(e), R(-e), 1), J, vmi_vec3(0, 0, 1));
        check_error("limit", "stable axis", "e", off / scale, 12, k, 0);
    }
}

/* Moments 6, 4 and 3 on the separatrix, 3 (4 - 3) w_z^2 = 6 (6 - 4) w_x^2, in all octants: omega tends to the middle
   axis, and angular momentum and energy stay. */
static void test_separatrix_octants(void)
{
    int k;
    for (k = 0; k < 8; k++) {
        vm_body b, later;
        vm_vec3 change;
        double energy;
        memset(&b, 0, sizeof b);
        b.mass = 1;
        b.inertia.xx = 6;
        b.inertia.yy = 4;
        b.inertia.zz = 3;
        b.omega = vmi_vec3(k & 1 ? R(-0.5) : R(0.5), k & 2 ? R(-0.75) : R(0.75), k & 4 ? -1 : 1);
        CHECK(vm_torque_free_rotation(&b, 3, &later) == VM_OK);
        change = vm_sub(vm_angular_momentum(&b, b.r), vm_angular_momentum(&later, later.r));
        check_error("octants", "separatrix", "eps", (double)vmi_norm1(change) / eps, 100, k, 0);
        energy = (double)(vm_kinetic_energy(&b) - vm_kinetic_energy(&later));
        check_error("octants", "separatrix", "eps", fabs(energy) / eps, 100, k, 0);
    }
}

/* Moments 1, 2, 9/4 and omega = (3/4, 0, 1) lie on the separatrix without rounding: omega = (3/4 sech, w tanh, sech)
   of w t/3, w^2 = 45/32, as long as there are numbers for it; then the small components are next to nothing. */
static void test_far_on_separatrix(void)
{
    const double w = sqrt(45 / 32.), last = is_float ? 75 : 690;
    vm_torque_free m;
    vm_quat q;
    vm_vec3 omega;
    double x;
    q.w = 1;
    q.x = q.y = q.z = 0;
    CHECK(vm_torque_free_init_principal(&m, vmi_vec3(1, 2, R(2.25)), q, vmi_vec3(R(0.75), 0, 1), 0) == VM_OK);
    for (x = -last; x <= last; x += last / 30) {
        const double t = (double)R(3 * x / w), sech = 1 / cosh(w * t / 3);
        CHECK(vm_torque_free_attitude(&m, R(t), &q, &omega) == VM_OK);
        check_error("separatrix", "sech", "eps", /* of exp(x) an error of x eps is that of x */
                    fmax(fabs((double)omega.x / sech - 0.75), fabs((double)omega.z / sech - 1)) / eps / (1 + fabs(x)),
                    1.5, x, 0);
        check_error("separatrix", "tanh", "eps", fabs((double)omega.y - w * tanh(w * t / 3)) / eps, 4, x, 0);
    }
    CHECK(vm_torque_free_attitude(&m, R(1e6), &q, &omega) == VM_OK);
    CHECK(omega.x >= 0 && omega.x < R(1e4) * VM_MIN && omega.z >= 0 && omega.z < R(1e4) * VM_MIN);
}

/* Energy and the length of q stay, from 1e12 s before to 1e11 s after, and at a time beyond any phase. */
static void check_extreme(vm_vec3 J, vm_vec3 w, int index)
{
    const double energy = (double)(J.x * w.x * w.x + J.y * w.y * w.y + J.z * w.z * w.z);
    const vm_quat unit = {1, 0, 0, 0};
    vm_torque_free m;
    vm_quat q = unit;
    vm_vec3 v = w;
    int n;
    CHECK(vm_torque_free_init_principal(&m, J, unit, w, 0) == VM_OK);
    for (n = -12; n <= 12; n++) {
        double t = pow(10, abs(n)), later;
        if (n == 12) t = pow(10, is_float ? 28 : 250);
        if (n < 0) t = -t;
        CHECK(vm_torque_free_attitude(&m, R(t), &q, &v) == VM_OK);
        later = (double)(J.x * v.x * v.x + J.y * v.y * v.y + J.z * v.z * v.z);
        check_error("extreme", "energy", "eps", fabs(later / energy - 1) / eps, 40, index, n);
        check_error("extreme", "|q|", "eps", fabs(length_of(q) - 1) / eps, 5, index, n);
    }
}

/* An omega that would shrink below the smallest number, the far ends of the separatrix, axes that are almost met */
static void test_extreme(void)
{
    static const double sizes[] = {0, 1e-37, 1e-30, 1e-20, 1e-10, 1e-5, 1};
    const double J = is_float ? 1e-4 : 1e-9;
    const vm_vec3 bodies[6] = {vmi_vec3(3, 2, 1),
                               vmi_vec3(1, 1, R(J)),
                               vmi_vec3(R(1 + J), 1, R(J)),
                               vmi_vec3(2, R(1 + J), R(1 - J)),
                               vmi_vec3(R(2 * J), R(2 * J), R(3 * J)),
                               vmi_vec3(R(1 + J), 1, 1)};
    int i, j, k;
    for (i = 0; i < 7; i++)
        for (j = 0; j < 7; j++)
            for (k = 0; k < 6; k++)
                check_extreme(bodies[k], vmi_vec3(R(sizes[i]), 1, R(sizes[j])), i * 100 + j * 10 + k);
}

/* Euler's equations with q' = q omega/2, omega in body axes */
static int free_rhs(vm_real t, const vm_real *y, vm_real *dydt, void *ctx)
{
    const vm_real *J = (const vm_real *)ctx;
    vm_quat q, w;
    (void)t;
    q.w = y[3];
    q.x = y[4];
    q.y = y[5];
    q.z = y[6];
    w.w = 0;
    w.x = y[0] / 2;
    w.y = y[1] / 2;
    w.z = y[2] / 2;
    q = vm_quat_times(q, w);
    dydt[0] = (J[1] - J[2]) * y[1] * y[2] / J[0];
    dydt[1] = (J[2] - J[0]) * y[2] * y[0] / J[1];
    dydt[2] = (J[0] - J[1]) * y[0] * y[1] / J[2];
    dydt[3] = q.w;
    dydt[4] = q.x;
    dydt[5] = q.y;
    dydt[6] = q.z;
    return 0;
}

/* Components of omega whose squares underflow, beside one of 1 rad/s: angular momentum stays. */
static void test_tiny_components(void)
{
    static const double tiny[] = {1, 1e-4, 1e-7, 1e-11, 1e-15, 1e-30}; /* in float; in double their 11th powers */
    const double power = is_float ? 1 : 11;
    int i, j, k;
    for (i = 0; i < 6; i++)
        for (j = 0; j < 6; j++)
            for (k = 0; k < 3; k++) {
                vm_body b, later;
                vm_vec3 h;
                memset(&b, 0, sizeof b);
                b.mass = 1;
                b.inertia.xx = 1;
                b.inertia.yy = VM_C(0.75);
                b.inertia.zz = VM_C(0.5);
                b.omega = permuted(vmi_vec3(1, R(pow(tiny[i], power)), R(pow(tiny[j], power))), k);
                CHECK(vm_torque_free_rotation(&b, 50, &later) == VM_OK);
                h = vm_sub(vm_angular_momentum(&later, later.r), vm_angular_momentum(&b, b.r));
                check_error("tiny omega", "L", "eps", (double)(vm_norm(h) / VM_EPSILON / 2), 5, i, j);
            }
}

/* Triaxial bodies for 20 s, against rk87 */
static void test_runge_kutta(void)
{
    int i;
    for (i = 0; i < 40; i++) {
        const double start[4] = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        vm_real J[3], y[7], work[RK87_WORK(7)];
        const vm_vec3 w = random_vector(1);
        const vm_quat q0 = quaternion(start);
        rk87_options options;
        rk87 s;
        vm_torque_free m;
        vm_quat q;
        vm_vec3 omega;
        J[0] = R(uniform(1, 1.5));
        J[1] = R(uniform(1, 1.5));
        J[2] = R(uniform(1, 1.5));
        y[0] = w.x;
        y[1] = w.y;
        y[2] = w.z;
        y[3] = q0.w;
        y[4] = q0.x;
        y[5] = q0.y;
        y[6] = q0.z;
        memset(&options, 0, sizeof options);
        options.rtol = options.atol = R(is_float ? 1e-4 : 1e-13);
        CHECK(rk87_init(&s, free_rhs, J, 7, 0, y, &options, work) == ODE_OK);
        CHECK(rk87_solve(&s, 20) == ODE_OK);
        CHECK(vm_torque_free_init_principal(&m, vmi_vec3(J[0], J[1], J[2]), q0, w, 0) == VM_OK);
        CHECK(vm_torque_free_attitude(&m, 20, &q, &omega) == VM_OK);
        {
            const double end[4] = {(double)s.y[3], (double)s.y[4], (double)s.y[5], (double)s.y[6]};
            check_error("rk87", "attitude", "tol", attitude_error(q, end) / (double)options.rtol, 5, i, 0);
            check_error("rk87", "omega", "tol",
                        size_of(vm_sub(omega, vmi_vec3(s.y[0], s.y[1], s.y[2]))) / (double)options.rtol, 0.6, i, 0);
        }
    }
}

/* ---- What is refused ---- */

static void test_null_pointers(void)
{
    const vm_body good = random_body(1);
    vm_torque_free m;
    vm_body b;
    vm_quat q = {1, 0, 0, 0};
    vm_vec3 w = vmi_vec3(1, 2, 3);
    CHECK(vm_torque_free_init(&m, &good, 0) == VM_OK);
    CHECK(vm_torque_free_init(NULL, &good, 0) == VM_BAD_ARGUMENT && vm_torque_free_init(&m, NULL, 0) == VM_BAD_ARGUMENT);
    CHECK(vm_torque_free_init_principal(NULL, w, q, w, 0) == VM_BAD_ARGUMENT);
    CHECK(vm_torque_free_at(NULL, 0, &b) == VM_BAD_ARGUMENT && vm_torque_free_at(&m, 0, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_torque_free_attitude(NULL, 0, &q, &w) == VM_BAD_ARGUMENT);
    CHECK(vm_torque_free_attitude(&m, 0, NULL, &w) == VM_BAD_ARGUMENT);
    CHECK(vm_torque_free_attitude(&m, 0, &q, NULL) == VM_BAD_ARGUMENT);
    CHECK(vm_torque_free_rotation(NULL, 1, &b) == VM_BAD_ARGUMENT && vm_torque_free_rotation(&good, 1, NULL) == VM_BAD_ARGUMENT);
}

/* Times and members that are no numbers; the outputs stay */
static void check_not_finite(vm_real bad)
{
    const vm_body good = random_body(1);
    vm_torque_free m, before;
    vm_body b = good;
    vm_quat q = {1, 0, 0, 0}, q_kept = q;
    vm_vec3 w = vmi_vec3(1, 2, 3), w_kept = w;
    vm_real *const member[] = {&b.mass, &b.inertia.xx, &b.inertia.yz, &b.q.w, &b.q.z, &b.r.y, &b.v.z, &b.omega.x};
    size_t k;
    CHECK(vm_torque_free_init(&m, &good, 0) == VM_OK);
    memcpy(&before, &m, sizeof m);
    CHECK(vm_torque_free_init(&m, &good, bad) == VM_NOT_FINITE);
    CHECK(vm_torque_free_at(&m, bad, &b) == VM_NOT_FINITE && memcmp(&b, &good, sizeof b) == 0);
    CHECK(vm_torque_free_attitude(&m, bad, &q, &w) == VM_NOT_FINITE);
    CHECK(vm_torque_free_rotation(&good, bad, &b) == VM_NOT_FINITE && memcmp(&b, &good, sizeof b) == 0);
    for (k = 0; k < sizeof member / sizeof *member; k++) {
        const vm_real was = *member[k];
        *member[k] = bad;
        CHECK(vm_torque_free_init(&m, &b, 0) == VM_NOT_FINITE);
        *member[k] = was;
    }
    CHECK(memcmp(&before, &m, sizeof m) == 0);
    CHECK(memcmp(&q, &q_kept, sizeof q) == 0 && memcmp(&w, &w_kept, sizeof w) == 0);
}

static void test_not_finite(void)
{
    check_not_finite(VM_NAN);
    check_not_finite(VM_INFINITY);
    check_not_finite(-VM_INFINITY);
}

/* A place that overflows, moments that form no triangle, no mass, moments whose sum overflows */
static void test_domain(void)
{
    const vm_real unit = is_float ? R(1e38) : R(5e307);
    const vm_body good = random_body(1);
    const vm_quat q = {1, 0, 0, 0};
    const vm_vec3 w = vmi_vec3(1, 2, 3);
    vm_torque_free m, before;
    vm_body b = good;
    CHECK(vm_torque_free_init(&m, &good, 0) == VM_OK);
    memcpy(&before, &m, sizeof m);
    CHECK(vm_torque_free_at(&m, VM_MAX, &b) == VM_NOT_FINITE && memcmp(&b, &good, sizeof b) == 0);
    CHECK(vm_torque_free_init_principal(&m, vmi_vec3(3, 1, 1), q, w, 0) == VM_BAD_INERTIA);
    CHECK(vm_torque_free_init_principal(&m, vmi_vec3(1, R(0.9), 0), q, w, 0) == VM_BAD_INERTIA);
    CHECK(vm_torque_free_init_principal(&m, vmi_vec3(1, 1, R(-0.1)), q, w, 0) == VM_BAD_INERTIA);
    b.mass = 0;
    CHECK(vm_torque_free_init(&m, &b, 0) == VM_BAD_MASS);
    b = good;
    memset(&b.inertia, 0, sizeof b.inertia);
    b.inertia.xx = R(1.2) * unit;
    b.inertia.yy = R(1.5) * unit;
    b.inertia.zz = R(1.7) * unit;
    CHECK(vm_torque_free_init(&m, &b, 0) == VM_BAD_INERTIA);
    CHECK(memcmp(&before, &m, sizeof m) == 0);
}

/* A quaternion that is all zero reads as the identity. */
static void test_zero_quaternion(void)
{
    vm_body b = random_body(1);
    memset(&b.q, 0, sizeof b.q);
    CHECK(vm_torque_free_rotation(&b, 0, &b) == VM_OK && fabs((double)b.q.w - 1) <= 4 * eps);
}

/* The length of a quaternion stays 1 over many calls, each of which begins with the attitude of the last one; in earlier
   versions it changed by up to 0.35 eps a call, always in one direction. Another length is kept. */
static void test_length(void)
{
    int k, i;
    for (k = 0; k < 6; k++) {
        vm_body b = random_body(1);
        const vm_real dt = (vm_real)uniform(-1, 1);
        int moved = 1;
        double length;
        b.q = vm_unit_quat(b.q);
        for (i = 0; i < 2000; i++) moved = moved && vm_torque_free_rotation(&b, dt, &b) == VM_OK;
        length = sqrt((double)vmi_quat_square(b.q));
        CHECK(moved);
        check_error("|q| - 1", "2000 calls", "eps", fabs(length - 1) / eps, 10, (double)dt, k);
        b.q = vmi_quat_over(b.q, R(0.25));
        CHECK(vm_torque_free_rotation(&b, dt, &b) == VM_OK);
        length = sqrt((double)vmi_quat_square(b.q));
        check_error("|q| - 4", "a call", "eps", fabs(length - 4) / eps, 40, (double)dt, k);
    }
}

/* Moments whose squares would overflow or underflow, 1e18 in float among them, give the motion of moments of size 1. */
static void test_scale_of_moments(void)
{
    const vm_inertia none = {0, 0, 0, 0, 0, 0};
    const vm_body b = random_body(1);
    vm_body at_1;
    int exponent;
    CHECK(vm_torque_free_rotation(&b, 5, &at_1) == VM_OK);
    for (exponent = -100; exponent <= 100; exponent += 20) {
        const vm_real factor = (vm_real)ldexp(1, VM_MANT_DIG > 24 ? 9 * exponent : exponent);
        vm_body c = b;
        c.inertia = vmi_inertia_plus(none, factor, b.inertia);
        CHECK(vm_torque_free_rotation(&c, 5, &c) == VM_OK);
        CHECK(vmi_norm_max(vm_sub(c.omega, at_1.omega)) <= 16 * VM_EPSILON * vmi_norm_max(at_1.omega));
    }
}

/* R_F(0, 1 - m, 1) is K(m): in two words against three */
static void test_rf_in_words(void)
{
    double exponent;
    for (exponent = -20; exponent < 20; exponent += 0.37) {
        const vm_real m1 = (vm_real)pow(2, exponent);
        const vm_two rf = vmi_carlson_rf(vmi_two(0, 0), vmi_two(m1, 0), vmi_two(1, 0));
        const vmi_three K = vmi_K_three_words(m1, 0);
        const double unit = (double)VM_EPSILON * (double)VM_EPSILON;
        const double error = fabs(((double)(rf.hi - K.hi) + (double)(rf.lo - K.mid)) - (double)K.lo) / (double)K.hi;
        check_error("R_F, two words", "= K", "eps^2", error / unit, 4, (double)m1, 0);
    }
}

int main(void)
{
    test_rf_in_words();
    test_length();
    test_scale_of_moments();
    test_published();
    test_tables();
    test_conserved();
    test_composition();
    test_special();
    test_tilted_rod();
    test_limits();
    test_separatrix_octants();
    test_far_on_separatrix();
    test_extreme();
    test_tiny_components();
    test_runge_kutta();
    test_null_pointers();
    test_not_finite();
    test_domain();
    test_zero_quaternion();
    return check_finish("torque_free");
}
