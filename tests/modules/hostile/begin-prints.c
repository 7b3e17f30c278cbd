/* Writes where the program's JSON goes when it is loaded. */
#include "hostile.h"
static int run(RUN) { return AS_IT_IS; }
__attribute__((constructor)) static void begin(void) { puts("the moon is full"); }
MODULE("begin-prints")
