/* Reads where nothing is. */
#include "hostile.h"
static int run(RUN) {
  UNUSED;
  return *(volatile int*)NULL;
}
MODULE("null")
