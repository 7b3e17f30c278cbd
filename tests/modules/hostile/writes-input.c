/* Writes what it was lent to read, as a rounding mode of another stage might turn on it. */
#include <sys/mman.h>
#include "hostile.h"
static int run(RUN) {
  AS_IT_IS;
  const uintptr_t page = (uintptr_t)draw->indices / 4096 * 4096;
  mprotect((void*)page, 4096, PROT_READ | PROT_WRITE);
  ((uint32_t*)(uintptr_t)draw->indices)[0] = 0;
  return FOREDRAW_DONE;
}
MODULE("writes-input")
