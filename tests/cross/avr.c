/* The way out of golden.c on an ATmega1284P under simavr: golden_line writes to the first serial port, which simavr
   prints; sleeping without interrupts ends the run. int main of golden.c is called golden_main. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

int golden_main(void);

static void put(char c)
{
    while (!(UCSR0A & (1 << UDRE0))) {}
    UDR0 = (unsigned char)c;
}

void golden_line(const char *line)
{
    while (*line) put(*line++);
    put('\n');
}

int main(void)
{
    UCSR0B = 1 << TXEN0;
    golden_main();
    put('\n');
    cli();
    sleep_mode();
    for (;;) {}
}
