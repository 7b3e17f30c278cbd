/* Says that it wrote more than there is room for. */
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  answer->count += 1000000;
  return FOREDRAW_DONE;
}
MODULE("count-raised")
