/* Answers with fewer numbers than it should. */
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  answer->count = 1;
  return FOREDRAW_DONE;
}
MODULE("too-short")
