/* The header alone, as a C compiler of an engine sees it: a square of two triangles, of which one collapse leaves one.
 */

#include <foredraw/runtime/progressive_mesh.h>

#include <stdio.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("%s\n", what);
  ++failures;
}

int progressive_mesh_test(void) {
  static const foredraw_split splits[2] = {{3, 1, 0, 0.5f}, {4, 2, 1, 0.0f}};
  static const foredraw_patch patches[1] = {{2, 3, 0}};
  uint32_t indices[6] = {0, 1, 3, 1, 2, 3};
  foredraw_progressive_mesh mesh = {splits, 1, patches, indices, 4, 2, 1};

  expect(foredraw_progressive_triangles(&mesh) == 2 && foredraw_progressive_vertices(&mesh) == 4, "full detail");
  foredraw_progressive_go(&mesh, 0);
  expect(foredraw_progressive_triangles(&mesh) == 1 && foredraw_progressive_vertices(&mesh) == 3, "the coarse state");
  expect(indices[2] == 0, "the corner is not patched");
  foredraw_progressive_go(&mesh, 9);
  expect(mesh.done == 1 && indices[2] == 3, "the corner does not come back");
  expect(foredraw_progressive_splits_for(&mesh, 0.6f) == 0 && foredraw_progressive_splits_for(&mesh, 0.1f) == 1,
         "error");
  expect(foredraw_progressive_splits_within(&mesh, 1) == 0 && foredraw_progressive_splits_within(&mesh, 2) == 1,
         "triangles");
  return failures;
}
