/* Calls itself until the stack is full. */
#include "hostile.h"
static int deep(volatile int* from) {
  volatile int here[1000];
  here[0] = *from + 1;
  return here[0] == 0 ? 0 : deep(here) + here[999];
}
static int run(RUN) {
  UNUSED;
  volatile int zero = 0;
  return deep(&zero);
}
MODULE("overflows")
