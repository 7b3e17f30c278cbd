/* Says that nothing can be gained, and that it is done. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  host->keep(host->self, "it is good already");
  return FOREDRAW_DONE;
}
MODULE("keeps")
