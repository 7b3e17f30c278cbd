/* Takes all memory that there is. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  for (volatile int i = 0; i == 0;) memset(malloc(1 << 20), 1, 1 << 20);
  return FOREDRAW_DONE;
}
MODULE("takes-memory")
