/* Ends its process, and says why. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  fprintf(stderr, "the moon is full\n");
  abort();
}
MODULE("aborts")
