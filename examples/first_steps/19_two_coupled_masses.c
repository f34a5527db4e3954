/* Two coupled masses hand over their vibration. Two buckets of sand hang on springs of their own with the force x^3, and a
   spring of 0.004 N/m joins them. Both lose 0.2 g a second, so that their frequencies stay equal. At first one swings 1 m
   and the other 0.1 m. Would each pass its vibration on to the other, as two equal pendulums on a string do? Not
   here: a strong spring vibrates faster the wider it swings, so that the buckets are out of step before much is passed on.
   The averaged equations need steps of many periods; the equation of motion is integrated beside them.

   cc -O2 19_two_coupled_masses.c -lm && ./a.out [file.csv] */
