/* Never comes back, and does not look at `cancelled`. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  for (volatile int i = 0; i >= 0; i = 1 - i) {
  }
  return FOREDRAW_DONE;
}
MODULE("spins")
