/* Never comes to an end of its beginning. */
#include "hostile.h"
static int run(RUN) { return AS_IT_IS; }
__attribute__((constructor)) static void begin(void) { sleep(1000); }
MODULE("begin-waits")
