/* Fails, with control characters and bytes that are no UTF-8, and says that it is done. */
#include "hostile.h"
static int run(RUN) {
  host->fail(host->self, "the moon\nis \x1b[2J full\xff");
  return AS_IT_IS;
}
MODULE("fails")
