/* A module that answers with the order that there is: what a call costs besides its work. */
#include <foredraw/c/module.h>

static int run(void* user, const foredraw_draw* draw, const foredraw_value* options, foredraw_answer* answer,
               const foredraw_host* host) {
  (void)user, (void)draw, (void)options, (void)host;
  for (uint64_t i = 0; i < answer->count; ++i) answer->values[i] = (uint32_t)i;
  return FOREDRAW_DONE;
}

static const foredraw_plugin plugin = {.size = sizeof plugin,
                                       .kind = FOREDRAW_TRIANGLE_ORDERER,
                                       .name = "bench-as-it-is",
                                       .summary = "Leaves the order",
                                       .reference = "own",
                                       .runs_on_many_threads = 1,
                                       .run = run};
static const foredraw_plugin* const plugins[] = {&plugin};
static const foredraw_module module = {sizeof module, FOREDRAW_MODULE_MAJOR, 0, 1, "bench", "1.0.0", plugins};

FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) { return &module; }
