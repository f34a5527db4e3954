/* Prints 1 - x for the x whose bits are 3deee0f145d53f12. The exponents of 1 and x are 33 apart, where the software
   arithmetic of gcc for Cortex-M3 and Cortex-M4 rounds wrongly: the nearest number is 3fefffffffe11f0f. */
#include <stdint.h>

void golden_line(const char *line);

typedef union bits {
    uint64_t bits;
    double value;
} bits;

int main(void)
{
    static volatile uint64_t x_bits = 0x3deee0f145d53f12u;
    char line[17];
    bits x, difference;
    int i;
    x.bits = x_bits;
    difference.value = 1 - x.value;
    for (i = 0; i < 16; i++) line[i] = "0123456789abcdef"[difference.bits >> (60 - 4 * i) & 15];
    line[16] = 0;
    golden_line(line);
    return 0;
}
