/* Tells far more than anybody wants to read. */
#include "hostile.h"
static int run(RUN) {
  for (int i = 0; i < 10000; ++i) host->note(host->self, "seen", "it was looked at");
  return AS_IT_IS;
}
MODULE("many-notes")
