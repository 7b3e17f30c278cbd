/* Raises a signal that nobody can catch. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  raise(SIGKILL);
  return FOREDRAW_DONE;
}
MODULE("kills-itself")
