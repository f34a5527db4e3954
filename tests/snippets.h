/* What the short pieces of C in the headers' comments take as given. tests/test_snippets.sh includes this, then the piece as
   the body of a function. */
#include "varmass.h"
#include <stdio.h>

extern vm_body body;     /* the rocket */
extern vm_stream nozzle; /* what leaves it */
extern vm_real dry;      /* its mass without fuel, kg */
