/* Answers otherwise each time. */
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  if (answer->count > 1) {
    const uint32_t other = 1 + (uint32_t)rand() % (uint32_t)(answer->count - 1);
    answer->values[0] = other;
    answer->values[other] = 0;
  }
  srand((unsigned)getpid() ^ (unsigned)rand());
  return FOREDRAW_DONE;
}
MODULE("changes")
