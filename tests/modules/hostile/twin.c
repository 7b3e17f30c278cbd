/* Names a triangle twice. */
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  answer->values[0] = answer->values[1];
  return FOREDRAW_DONE;
}
MODULE("twin")
