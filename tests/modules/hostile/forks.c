/* Leaves a process behind that lives on in a session of its own, and one that comes back. */
#include "hostile.h"
static int run(RUN) {
  if (fork() == 0) {
    setsid();
    if (fork() == 0) {
      signal(SIGTERM, SIG_IGN);
      for (;;) sleep(1000);
    }
    _exit(0);
  }
  fork();
  return AS_IT_IS;
}
MODULE("forks")
