/* The board: prints lines by semihosting, and counts instructions. MPS2 boards (Cortex-M3, M4, M7) have a counter of
   25 MHz. With qemu -icount shift=10 an instruction takes 1024 ns, so that this counter gives the exact number of
   instructions. RISC-V has a counter of instructions. */
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

static inline uint32_t board_instructions(void)
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

static inline uint32_t board_instructions(void)
{
    return (uint32_t)((*(volatile uint32_t *)0x40028018u * (uint64_t)40 + 512) >> 10);
}
#endif

/* The number of instructions since board_instructions() returned `start`. It must be less than 2^32 40/1024, since the
   counter of the MPS2 boards then begins again at 0. */
static inline uint32_t board_instructions_since(uint32_t start)
{
    uint32_t passed = board_instructions() - start;
#ifndef __riscv
    if (passed > 167772160u) passed += 167772160u;
#endif
    return passed;
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
