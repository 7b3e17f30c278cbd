/* Closes every descriptor. */
#include "hostile.h"
static int run(RUN) {
  for (int descriptor = 0; descriptor < 1024; ++descriptor) close(descriptor);
  return AS_IT_IS;
}
MODULE("closes")
