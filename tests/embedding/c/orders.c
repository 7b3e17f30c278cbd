/* An engine's own mesh, ordered by stages of pipelines. */
#include <foredraw/c/foredraw.h>

#include <stdio.h>

typedef struct vertex {
  unsigned char colour[4];
  float position[3];
} vertex;

int main(void) {
  const unsigned short indices[] = {0, 1, 2, 3, 4, 5, 2, 1, 3};
  const vertex vertices[6] = {{{0}, {0, 0, 0}}, {{0}, {1, 0, 0}}, {{0}, {0, 1, 0}},
                              {{0}, {1, 1, 0}}, {{0}, {2, 1, 0}}, {{0}, {1, 2, 0}}};
  const foredraw_triangles triangles = {indices, 9, sizeof *indices, 6};
  const foredraw_positions positions = {vertices[0].position, sizeof *vertices};
  foredraw_context* context = foredraw_context_new(NULL);
  foredraw_text text = {NULL, 0};
  uint32_t order[3];
  int status = FOREDRAW_DONE;
  status = foredraw_order(context, "lookahead, occlusion-order(quality=high)", &triangles, &positions, order, &text);
  if (status == FOREDRAW_DONE) printf("%u %u %u\n", order[0], order[1], order[2]);
  if (status != FOREDRAW_DONE && text.data != NULL) puts(text.data);
  foredraw_text_free(&text);
  foredraw_context_free(context);
  return status;
}
