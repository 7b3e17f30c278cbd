/* Asks for the overdraw of what are no orders, and then of one. */
#include "hostile.h"
static int run(RUN) {
  uint64_t shaded = 7, visible = 7;
  const int unwritten = host->count_overdraw(host->self, answer->values, &shaded, &visible);
  AS_IT_IS;
  answer->values[0] = (uint32_t)draw->triangle_count;
  const int beyond = host->count_overdraw(host->self, answer->values, &shaded, &visible);
  AS_IT_IS;
  const int right = host->count_overdraw(host->self, answer->values, NULL, NULL);
  if (unwritten == FOREDRAW_NO_ORDER && beyond == FOREDRAW_NO_ORDER && right == FOREDRAW_DONE && shaded == 7) {
    host->keep(host->self, "no order, no order, an order");
  }
  return FOREDRAW_DONE;
}
MODULE_THAT_ASKS("asks-wrong")
