/* Names a triangle that there is not. */
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  answer->values[0] = (uint32_t)draw->triangle_count;
  return FOREDRAW_DONE;
}
MODULE("beyond")
