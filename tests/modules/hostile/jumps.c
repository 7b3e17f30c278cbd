/* Jumps over whoever called it, to where it was before. */
#include <setjmp.h>
#include "hostile.h"
static jmp_buf begin;
static int run(RUN) {
  UNUSED;
  longjmp(begin, 1);
}
static const foredraw_plugin plugin = {sizeof(foredraw_plugin),
                                       FOREDRAW_TRIANGLE_ORDERER,
                                       "hostile-jumps",
                                       "Misbehaves",
                                       "own",
                                       NULL,
                                       NULL,
                                       NULL,
                                       NULL,
                                       NULL,
                                       0,
                                       0,
                                       1,
                                       NULL,
                                       run};
static const foredraw_plugin* const plugins[] = {&plugin};
static const foredraw_module module = {sizeof(foredraw_module), 1, 0, 1, "hostile", "0", plugins};
FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) {
  (void)as_it_is;
  return setjmp(begin) == 0 ? &module : NULL;
}
