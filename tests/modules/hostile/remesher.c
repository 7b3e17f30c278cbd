/* Remeshers that answer wrong: in what, says WRONG. */
#include "hostile.h"
enum {
  beyond = 1,
  from_beyond,
  unwritten,
  odd_count,
  more_triangles,
  more_vertices,
  none_left,
  no_vertices,
  lossless,
  clustered,
  exits,
  counts_overdraw
};
static int run(RUN) {
  const uint64_t last = answer->count - 1;
  UNUSED;
  if (WRONG == unwritten) return FOREDRAW_DONE;
  for (uint32_t v = 0; v < draw->vertex_count; ++v) answer->vertex_from[v] = v;
  memcpy(answer->values, draw->indices, answer->count * sizeof *answer->values);
  if (WRONG == beyond) answer->values[last] = draw->vertex_count;
  if (WRONG == from_beyond) answer->vertex_from[0] = draw->vertex_count;
  if (WRONG == odd_count) answer->count -= 1;
  if (WRONG == more_triangles) answer->count += 3;
  if (WRONG == more_vertices) answer->vertex_count += 1;
  if (WRONG == none_left) answer->count = 0;
  if (WRONG == no_vertices) answer->vertex_count = 0;
  if (WRONG == lossless) answer->count = 3; /* all but one triangle go */
  if (WRONG == exits) exit(7);
  if (WRONG == counts_overdraw && host->count_overdraw(host->self, NULL, NULL, NULL) == FOREDRAW_MISTAKE) {
    host->fail(host->self, "it may not ask for overdraw");
    return FOREDRAW_FAILED;
  }
  return FOREDRAW_DONE;
}
static const foredraw_plugin plugin = {.size = sizeof plugin,
                                       .kind = FOREDRAW_REMESHER,
                                       .name = "hostile-remesher",
                                       .summary = "Misbehaves",
                                       .reference = "own",
                                       .provides = WRONG == clustered ? "clustered" : NULL,
                                       .run = run,
                                       .flags = WRONG == lossless ? FOREDRAW_LOSSLESS : 0};
static const foredraw_plugin* const plugins[] = {&plugin};
static const foredraw_module module = {sizeof module, 1, 1, 1, "hostile", "0", plugins};
FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) {
  (void)as_it_is;
  return &module;
}
