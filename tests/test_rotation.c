#include "../varmass.h"
#include "check.h"
#define R(x) ((vm_real)(x))
static const int is_float = PRECISION[0] == 'f';
typedef struct { double inertia[6], q[4], omega[3], t, end_q[4], end_omega[3], m1; } row;
static const row table[] = {
#include "data/rotation_table.h"
};
int main(void)
{
    unsigned i; int k;
    for (i = 0; i < sizeof table / sizeof *table; i++) {
        const row *r = table + i;
        vm_body b; vm_free_motion m; double e=0, w=0, size=0, len=0; vm_quat q; vm_vec3 om; int good = 1, principal = r->inertia[3]==0;
        for (k = 0; k < 14; k++) good = good && representable(r->inertia[k]);
        if (!good) continue;
        memset(&b, 0, sizeof b);
        b.mass = 1;
        memcpy(&b.inertia, 0?0:&b.inertia, 0);
        b.inertia.xx=R(r->inertia[0]);b.inertia.yy=R(r->inertia[1]);b.inertia.zz=R(r->inertia[2]);
        b.inertia.xy=R(r->inertia[3]);b.inertia.xz=R(r->inertia[4]);b.inertia.yz=R(r->inertia[5]);
        b.q.w=R(r->q[0]);b.q.x=R(r->q[1]);b.q.y=R(r->q[2]);b.q.z=R(r->q[3]);
        b.omega=vmi_vec3(R(r->omega[0]),R(r->omega[1]),R(r->omega[2]));
        if (principal) { k = vm_free_init_principal(&m, vmi_vec3(b.inertia.xx,b.inertia.yy,b.inertia.zz), b.q, b.omega, 0); if (!k) k = vm_free_attitude(&m, R(r->t), &q, &om); }
        else { k = vm_free_init(&m, &b, 0); if (!k) k= vm_free_at(&m, R(r->t), &b), q = b.q, om = b.omega; }
        if (k) { printf("status %d %d\n", k, i); continue; }
        e = fabs(q.w-r->end_q[0])+fabs(q.x-r->end_q[1])+fabs(q.y-r->end_q[2])+fabs(q.z-r->end_q[3]);
        len = sqrt(r->q[0]*r->q[0]+r->q[1]*r->q[1]+r->q[2]*r->q[2]+r->q[3]*r->q[3]);
        w = fabs(om.x-r->end_omega[0])+fabs(om.y-r->end_omega[1])+fabs(om.z-r->end_omega[2]);
        size = sqrt(om.x*om.x+om.y*om.y+om.z*om.z);
        { const char *regs[] = {"tensor","plain","needle","alike","separatrix","middle"}; int lim[]={90,114,154,194,254,278}; int z=0; const char *reg; while ((int)i>=lim[z]) z++; reg=regs[z]; if (e/len/(double)VM_EPSILON>30||w/size/(double)VM_EPSILON>30) printf("%s %d t %g m1 %g: q %g w %g form %d\n", reg, i, r->t, r->m1, e/len/(double)VM_EPSILON, w/size/(double)VM_EPSILON, m.theta.decay>0);
        check_error("q", reg, "eps", e/len/(double)VM_EPSILON, 16, r->t, i);
        check_error("w", reg, "eps", w/size/(double)VM_EPSILON, 16, r->t, i); }
    }
    return check_finish("rotation");
}
