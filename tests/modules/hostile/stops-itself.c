/* Raises a signal after which nothing happens. */
#include "hostile.h"
static int run(RUN) {
  raise(SIGSTOP);
  return AS_IT_IS;
}
MODULE("stops-itself")
