/* Says that it is done, and did nothing. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  return FOREDRAW_DONE;
}
MODULE("nothing-written")
