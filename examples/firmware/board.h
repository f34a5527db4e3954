/* The board: prints lines by semihosting, and has a counter. RISC-V counts instructions. MPS2 boards (Cortex-M3, M4, M7) have a
   counter of 25 MHz. Under qemu -icount shift=10 an instruction takes 1024 ns, and so the number of instructions between
   two readings follows exactly from their difference. */
#ifndef BOARD_H
#define BOARD_H
#include <stdint.h>

#ifdef __riscv
static inline void board_print(const char *text)
{
    register long a0 __asm__("a0") = 0x04; /* SYS_WRITE0 */
    register const char *a1 __asm__("a1") = text;
    __asm__ volatile(".option push\n.option norvc\n.balign 16\nslli x0,x0,0x1f\nebreak\nsrai x0,x0,7\n.option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
}

static inline uint32_t board_counter(void)
{
    uint32_t count;
    __asm__ volatile(".option push\n.option arch, +zicsr\ncsrr %0, minstret\n.option pop" : "=r"(count));
    return count;
}
#else
static inline void board_print(const char *text)
{
    register int r0 __asm__("r0") = 0x04; /* SYS_WRITE0 */
    register const char *r1 __asm__("r1") = text;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

static inline uint32_t board_counter(void) { return *(volatile uint32_t *)0x40028018u; }
#endif

/* The number of instructions from one reading of the counter to a later one. On the MPS2 boards it must be less than
   1.6e8, since their counter begins again after 2^32 ticks of 40 ns. */
static inline uint32_t board_instructions(uint32_t from, uint32_t to)
{
#ifdef __riscv
    return to - from;
#else
    return (uint32_t)(((to - from) * (uint64_t)40 + 512) >> 10);
#endif
}

static inline void board_print_number(int32_t x, int width)
{
    char text[16];
    int i = 15, negative = x < 0;
    uint32_t rest = negative ? (uint32_t)0 - (uint32_t)x : (uint32_t)x;
    text[i] = 0;
    do text[--i] = (char)('0' + rest % 10);
    while (rest /= 10);
    if (negative) text[--i] = '-';
    for (width -= 15 - i; width > 0; width--) board_print(" ");
    board_print(text + i);
}

#endif
