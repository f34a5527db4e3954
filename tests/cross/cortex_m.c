/* The least that a Cortex-M needs under an emulator: vectors, data and bss, the floating-point unit, and semihosting to
   write a line and to end with main's value. golden_line is the function by which golden.c writes. */
#include <stddef.h>
#include <stdint.h>

extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[], stack_top[];
int main(int argc, char **argv);
void golden_line(const char *line);
void initialise_monitor_handles(void);
void reset(void);

static int semihosting(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void golden_line(const char *line)
{
    semihosting(0x04, line); /* SYS_WRITE0 */
    semihosting(0x04, "\n");
}

static void leave(uint32_t status)
{
    uint32_t block[2];
    block[0] = 0x20026u;
    block[1] = status; /* ADP_Stopped_ApplicationExit */
    semihosting(0x20, block);               /* SYS_EXIT_EXTENDED */
    for (;;) {}
}

static void fault(void) { leave(99); }

void reset(void)
{
    uint32_t *to, *from = data_load;
    for (to = data_start; to < data_end;) *to++ = *from++;
    for (to = bss_start; to < bss_end;) *to++ = 0;
#ifdef __ARM_FP
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* CPACR: full access to the floating-point unit */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
#ifdef NEWLIB_CONSOLE
    initialise_monitor_handles();
#endif
    leave((uint32_t)main(0, NULL));
}

typedef union vector {
    uint32_t *stack;
    void (*handler)(void);
} vector;
#define FAULT {.handler = fault}
__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    {.stack = stack_top}, {.handler = reset}, FAULT, FAULT, FAULT, FAULT, FAULT, {0}, {0}, {0}, {0}, FAULT, FAULT, {0},
    FAULT, FAULT};
