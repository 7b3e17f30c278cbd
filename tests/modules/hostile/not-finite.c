/* Tells a figure that is no number. */
#include <math.h>
#include "hostile.h"
static const foredraw_metric metrics[] = {{"moon", "", "Fullness", 0}};
static int run(RUN) {
  UNUSED;
  host->measure(host->self, "moon", 1, 2, NAN);
  return FOREDRAW_DONE;
}
MODULE_OF("not-finite", FOREDRAW_EVALUATOR, metrics, 1)
