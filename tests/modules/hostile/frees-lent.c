/* Frees what is not its own. */
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  void* volatile lent = (void*)(uintptr_t)draw->indices;
  free(lent);
  return FOREDRAW_DONE;
}
MODULE("frees-lent")
