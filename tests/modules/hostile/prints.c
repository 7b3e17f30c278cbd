/* Writes where the program's JSON goes. */
#include "hostile.h"
static int run(RUN) {
  printf("the moon is full\n");
  fflush(stdout);
  (void)!write(1, "{", 1);
  return AS_IT_IS;
}
MODULE("prints")
