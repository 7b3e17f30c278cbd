/* radial IN: an orderer of one's own, beside Foredraw's on the same model. */
#include <foredraw/c/foredraw.h>

#include <math.h>
#include <stdio.h>
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

/* Triangles far from the mesh's origin first. */
static int radial(void* user, const foredraw_draw* draw, const foredraw_value* options, foredraw_answer* answer,
                  const foredraw_host* host) {
  far_triangle* triangles = malloc((draw->triangle_count + 1) * sizeof *triangles);
  (void)user, (void)host;
  if (triangles == NULL) return FOREDRAW_FAILED;
  for (uint64_t t = 0; t < draw->triangle_count; ++t) {
    const far_triangle here = {0, (uint32_t)t};
    triangles[t] = here;
    for (int corner = 0; corner < 3; ++corner) {
      const float* p = draw->positions + 3 * (uint64_t)draw->indices[3 * t + corner];
      const double y = options[0].number * p[1];
      triangles[t].distance += sqrt(p[0] * p[0] + y * y + p[2] * p[2]);
    }
  }
  qsort(triangles, draw->triangle_count, sizeof *triangles, farther);
  for (uint64_t t = 0; t < draw->triangle_count; ++t) answer->values[t] = triangles[t].number;
  free(triangles);
  return FOREDRAW_DONE;
}

int main(int count, char** arguments) {
  const foredraw_option height = {"height", "How much height counts", "", FOREDRAW_NUMBER, 0, NULL, {0, 1.0, NULL}, 0.0,
                                  10.0};
  const foredraw_plugin plugin = {sizeof plugin,
                                  FOREDRAW_TRIANGLE_ORDERER,
                                  "my-radial",
                                  "Draws triangles far from the origin first",
                                  "own",
                                  NULL,
                                  "overdraw-ordered",
                                  "cache-ordered fetch-ordered",
                                  &height,
                                  NULL,
                                  1,
                                  0,
                                  1,
                                  NULL,
                                  radial};
  const char* pipelines[] = {"tipsify, vertex-fetch", "my-radial, vertex-fetch", "my-radial(height=.5), vertex-fetch"};
  foredraw_context* context = foredraw_context_new(NULL);
  foredraw_scene* scene = NULL;
  foredraw_text text = {NULL, 0};
  int status = count == 2 ? foredraw_add_plugin(context, &plugin, &text) : FOREDRAW_MISTAKE;
  if (status == FOREDRAW_DONE) status = foredraw_read(context, arguments[1], &scene, &text);
  if (status == FOREDRAW_DONE) {
    const foredraw_scene* scenes[] = {scene};
    foredraw_text_free(&text);
    status = foredraw_compare(context, scenes, 1, pipelines, 3, 0, &text);
  }
  puts(text.data != NULL ? text.data : foredraw_status_text(status));
  foredraw_text_free(&text);
  foredraw_scene_free(scene);
  foredraw_context_free(context);
  return status;
}
