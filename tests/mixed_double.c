/* float and double in one program: the same jump by both halves. Exits with 0 where they agree to float's
   precision. */
#include "../varmass.h"

float float_half(float x);

int main(void)
{
    vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}}, part = whole;
    part.mass = 1;
    part.inertia.xx = part.inertia.yy = part.inertia.zz = 0.1;
    part.r.x = 0.4;
    part.v.y = 2;
    if (vm_separate(&whole, &part, NULL, &whole)) return 1;
    return fabs(whole.omega.z - (double)float_half(0.4f)) < 4e-7 * fabs(whole.omega.z) && sizeof(vm_real) == 8 ? 0
                                                                                                               : 2;
}
