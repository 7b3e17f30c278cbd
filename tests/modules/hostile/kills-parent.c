/* Kills who watches it. */
#include "hostile.h"
static int run(RUN) {
  kill(getppid(), SIGKILL);
  sleep(1);
  return AS_IT_IS;
}
MODULE("kills-parent")
