// Throws, where C is spoken.
extern "C" {
#include "hostile.h"
}
#include <stdexcept>
static int run(RUN) {
  UNUSED;
  throw std::runtime_error("the moon is full");
}
MODULE("throws")
