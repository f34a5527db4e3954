/* The float half of the program that holds both precisions (mixed_double.c is the other). */
#define VM_USE_FLOAT
#define VM_MIXED_PRECISIONS /* the other half is in double */
#include "../varmass.h"

float float_half(float x);

float float_half(float x)
{
    vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}}, part = whole;
    part.mass = 1;
    part.inertia.xx = part.inertia.yy = part.inertia.zz = 0.1f;
    part.r.x = x;
    part.v.y = 2;
    return vm_separate(&whole, &part, NULL, &whole) == VM_OK ? whole.omega.z : -1;
}
