/* The headers alone, as a C compiler of an engine sees them: a square around a middle, whose corners two splits move
 * in.
 */

#include <foredraw/runtime/selective_refine_check.h>

#include <stdio.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("%s\n", what);
  ++failures;
}

static int everything(const void* context, const foredraw_refine_mesh* mesh, uint32_t split) {
  (void)context;
  (void)mesh;
  (void)split;
  return 1;
}

static int nothing(const void* context, const foredraw_refine_mesh* mesh, uint32_t split) {
  return !everything(context, mesh, split);
}

int selective_refine_test(void) {
  /* Triangle 0 1 2; split 0 adds vertex 3 beside 2, split 1 adds vertex 4 beside 3. */
  static const foredraw_split splits[3] = {{3, 1, 0, 0.5f}, {4, 2, 1, 0.25f}, {5, 3, 2, 0.0f}};
  static const foredraw_patch patches[2] = {{2, 3, 2}, {2, 4, 3}};
  static const uint32_t corners[9] = {0, 1, 2, 3, 1, 2, 4, 1, 3};
  static const uint32_t needs[1] = {0};
  static const uint32_t point[5] = {2, 3, 4, 0, 1};
  static const foredraw_refine_node nodes[3] = {{4, 1, 2, 0, {1, 0, 0}, 2, {0, 0, 1}, 0},
                                                {0, 2, 2, 0, {0, 1, 0}, 1, {0, 0, 1}, 0},
                                                {2, 0, 2, 1, {0, 0, 0}, 0, {0, 0, 0}, 0}};
  static const foredraw_refine_mesh mesh = {splits, nodes, 2, patches, needs, corners, 3};
  static const foredraw_refine_arrays arrays = {point, 5, 5, 2, 1, 5};
  foredraw_refine_view view = {{0, 0, 9}, {{0}}, 100, 1, 1, 0};
  uint32_t memory[64];
  foredraw_refinement state;

  expect(foredraw_refine_words(&mesh) == 23 && foredraw_refine_check_words(&mesh, &arrays) == 28, "memory");
  expect(foredraw_refine_check(&mesh, &arrays, memory) == NULL, "a sound mesh is refused");
  foredraw_refine_begin(&state, &mesh, memory);
  expect(state.triangles == 1 && state.indices[2] == 2, "the base");
  expect(foredraw_refine_missing(&state, 1) == 0 && foredraw_refine_missing(&state, 0) == 2, "what is missing");
  expect(foredraw_refine_split(&state, 1, 9) == 2 && state.triangles == 3, "a split and the one that it needs");
  expect(state.indices[2] == 4 && state.indices[3] == 3 && state.indices[6] == 4, "corners");
  expect(foredraw_refine_collapse(&state, 0) == 0, "a split goes that another one needs");
  expect(foredraw_refine_collapse(&state, 1) == 1 && state.triangles == 2 && state.indices[2] == 3, "a collapse");
  expect(foredraw_refine(&state, everything, NULL, 9) == 1 && state.done == 2, "full detail");
  while (foredraw_refine(&state, nothing, NULL, 1) > 0) {
  }
  expect(state.done == 0 && state.indices[2] == 2, "the base again");
  while (foredraw_refine(&state, foredraw_refine_view_wants, &view, 9) > 0) {
  }
  expect(state.done == 2, "what is seen from the front");
  view.eye[2] = -9;
  while (foredraw_refine(&state, foredraw_refine_view_wants, &view, 9) > 0) {
  }
  expect(state.done == 0, "what shows its back");
  return failures;
}
