/* A tray on a hard spring loses its load: 10 kg and 0.1 kg/s less each second. Where is it after t seconds? The kit gives
   the position at any time by one call, from a plan that a PC has prepared. plan.h was written by
     cc -DVM_USE_FLOAT examples/print_plan.c -lm && ./a.out closed 3 10 -0.1 100 0 1 0 0.1 0 3 30 >plan.h */
#define VM_USE_FLOAT
#include <varmass.h>
#include "plan.h"

void setup() { Serial.begin(9600); }

void loop()
{
    const vm_real t = (vm_real)(millis() % 30000UL) / 1000; /* the plan holds for 30 s */
    vm_real x, v;
    if (vm_osc_closed_at_order3(&plan, t, &x, &v) == VM_OK) Serial.println(x, 5);
    delay(100);
}
