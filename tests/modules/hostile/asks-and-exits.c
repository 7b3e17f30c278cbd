/* Leaves while the program counts what it asked for. */
#include "hostile.h"

#include <pthread.h>
static void* leave(void* nothing) {
  (void)nothing;
  usleep(1000);
  _exit(3);
}
static int run(RUN) {
  pthread_t thread;
  UNUSED;
  pthread_create(&thread, NULL, leave, NULL);
  for (;;) host->count_overdraw(host->self, NULL, NULL, NULL);
  return FOREDRAW_DONE;
}
MODULE_THAT_ASKS("asks-and-exits")
