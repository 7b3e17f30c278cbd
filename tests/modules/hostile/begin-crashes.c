/* Ends when it is loaded. */
#include "hostile.h"
static int run(RUN) { return AS_IT_IS; }
__attribute__((constructor)) static void begin(void) { raise(SIGSEGV); }
MODULE("begin-crashes")
