/* Leaves. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  exit(0);
}
MODULE("exits")
