/* Asks for overdraw, and never answers. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  for (;;) host->count_overdraw(host->self, NULL, NULL, NULL);
  return FOREDRAW_DONE;
}
MODULE_THAT_ASKS("asks-for-ever")
