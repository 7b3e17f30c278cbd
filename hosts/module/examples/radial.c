/* A module: an orderer of triangles. cc -std=c99 -shared -fPIC -o radial.so radial.c */
#include <foredraw/c/module.h>

#include <stdlib.h>

typedef struct far_triangle {
  double distance;
  uint32_t number;
} far_triangle;

static int farther(const void* a, const void* b) {
  const far_triangle *one = a, *other = b;
  if (one->distance != other->distance) return one->distance > other->distance ? -1 : 1;
  return one->number < other->number ? -1 : 1; /* equal ones keep their sequence, on every machine */
}

/* Triangles far from the mesh's origin first; distances are squares, of which the sum over the corners counts. */
static int radial(void* user, const foredraw_draw* draw, const foredraw_value* options, foredraw_answer* answer,
                  const foredraw_host* host) {
  far_triangle* triangles = malloc((draw->triangle_count + 1) * sizeof *triangles);
  (void)user, (void)host;
  if (triangles == NULL) return FOREDRAW_FAILED;
  for (uint64_t t = 0; t < draw->triangle_count; ++t) {
    double sum = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const float* p = draw->positions + 3 * (uint64_t)draw->indices[3 * t + corner];
      const double x = p[0], y = options[0].number * p[1], z = p[2];
      sum += x * x + y * y + z * z;
    }
    triangles[t].distance = sum >= 0 ? sum : -1; /* not where a position is no number */
    triangles[t].number = (uint32_t)t;
  }
  qsort(triangles, draw->triangle_count, sizeof *triangles, farther);
  for (uint64_t t = 0; t < draw->triangle_count; ++t) answer->values[t] = triangles[t].number;
  free(triangles);
  return FOREDRAW_DONE;
}

static const foredraw_option options[] = {{.name = "height",
                                           .doc = "How much height counts",
                                           .type = FOREDRAW_NUMBER,
                                           .initial = {.number = 1},
                                           .least = 0,
                                           .most = 10}};
static const foredraw_plugin plugin = {.size = sizeof(foredraw_plugin),
                                       .kind = FOREDRAW_TRIANGLE_ORDERER,
                                       .name = "acme-radial",
                                       .summary = "Draws triangles far from the origin first",
                                       .reference = "own",
                                       .provides = "overdraw-ordered", /* traits */
                                       .breaks = "cache-ordered fetch-ordered clustered",
                                       .options = options,
                                       .option_count = 1,
                                       .runs_on_many_threads = 1,
                                       .run = radial};
static const foredraw_plugin* const plugins[] = {&plugin};
static const foredraw_module module = {sizeof(foredraw_module), FOREDRAW_MODULE_MAJOR, 0, 1, "acme", "1.0.0", plugins};

FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) { return &module; }
