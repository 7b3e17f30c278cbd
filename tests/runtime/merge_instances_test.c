/* The header alone, as a C compiler of an engine sees it: the paper's example in small, three slots of six entries. */

#include <foredraw/runtime/merge_instances.h>

#include <stdio.h>

static int failures = 0;

static void expect(uint32_t found, uint32_t wanted, const char* what) {
  if (found == wanted) return;
  printf("%s: %u, but expected %u\n", what, (unsigned)found, (unsigned)wanted);
  ++failures;
}

int merge_instances_test(void) {
  static const uint32_t indices[] = {
      0, 1, 2, 2, 2, 2,                   /* a triangle, and padding */
      3, 4, 5, 5, 4, 6, 6, 4, 7, 7, 4, 3, /* four of them: two slots */
  };
  static const foredraw_merged_slot slots[] = {{77, 77}, {0, 5}, {6, 9}, {12, 9}};
  const foredraw_merged_draw draw = {6, 1, 3, slots, indices};
  static const float transform[12] = {1, 0, 0, 10, 0, -2, 0, 20, 0, 0, 3, 30};
  static const float position[3] = {1, 1, 1};
  float world[3];

  expect(foredraw_merged_vertex_count(&draw), 18, "vertices");
  expect(foredraw_merged_vertex_at(&draw, 1).vertex, 1, "a vertex of the first slot");
  expect(foredraw_merged_vertex_at(&draw, 1).instance, 5, "its instance");
  expect(foredraw_merged_vertex_at(&draw, 11).vertex, 6, "the last vertex of the second slot");
  expect(foredraw_merged_vertex_at(&draw, 17).vertex, 3, "the last vertex");
  expect(foredraw_merged_vertex_at(&draw, 17).instance, 9, "its instance");
  expect((uint32_t)foredraw_merged_is_padding(&draw, 0), 0, "a triangle");
  expect((uint32_t)foredraw_merged_is_padding(&draw, 1), 1, "padding");
  foredraw_merged_to_world(transform, position, world);
  expect((uint32_t)world[0], 11, "x");
  expect((uint32_t)world[1], 18, "y");
  expect((uint32_t)world[2], 33, "z");
  expect((uint32_t)foredraw_merged_is_mirrored(transform), 1, "mirrored");
  return failures;
}
