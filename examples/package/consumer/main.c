/* How much faster does a mass of 1 kg on a spring of 1 N/m^3 swing when half of it has leaked away?
   cc main.c $(pkg-config --cflags --libs varmass) && ./a.out */
#include "varmass.h"
#include <stdio.h>

int main(void)
{
    const vm_real amplitude = vm_osc_amplitude_law(0.5, 0, 0, 3), before = vm_osc_period(1, 1, 3);
    const vm_real after = vm_osc_period(amplitude, VM_SQRT(2), 3);
    printf("amplitude %.6f, period %.6f s instead of %.6f s\n", amplitude, after, before);
    return 0;
}
