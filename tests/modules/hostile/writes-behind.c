/* Writes far behind its answer. */
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  volatile uint32_t* values = answer->values;
  values[(uint64_t)1 << 36] = 0;
  return FOREDRAW_DONE;
}
MODULE("writes-behind")
