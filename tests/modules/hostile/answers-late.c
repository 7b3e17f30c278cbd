/* Changes its answer after it returned. */
#include <pthread.h>
#include "hostile.h"
static void* spoil(void* values) {
  usleep(50000);
  for (int i = 0; i < 1000000; ++i) *(volatile uint32_t*)values = 7;
  return NULL;
}
static int run(RUN) {
  pthread_t thread;
  pthread_create(&thread, NULL, spoil, answer->values);
  return AS_IT_IS;
}
MODULE("answers-late")
