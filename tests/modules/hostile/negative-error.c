/* Tells a figure whose error is below 0. */
#include "hostile.h"
static const foredraw_metric metrics[] = {{"moon", "", "Fullness", 0}};
static int run(RUN) {
  UNUSED;
  host->measure(host->self, "moon", 1, 2, -1);
  return FOREDRAW_DONE;
}
MODULE_OF("negative-error", FOREDRAW_EVALUATOR, metrics, 1)
