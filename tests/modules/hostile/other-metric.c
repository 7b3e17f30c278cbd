/* Tells a figure that it never said it has. */
#include "hostile.h"
static const foredraw_metric metrics[] = {{"moon", "", "Fullness", 0}};
static int run(RUN) {
  UNUSED;
  host->count(host->self, "sun", 1);
  return FOREDRAW_DONE;
}
MODULE_OF("other-metric", FOREDRAW_EVALUATOR, metrics, 1)
