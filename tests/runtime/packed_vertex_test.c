/* The header alone, as a C compiler of an engine sees it. */

#include <foredraw/runtime/packed_vertex.h>

#include <math.h>
#include <stdio.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("%s\n", what);
  ++failures;
}

static foredraw_packed_layout good(void) {
  static const foredraw_packed_layout layout = {
      {{0, 0, 20}, {1, 0, 19}, {2, 0, 19}, {0, 20, 12}, {1, 19, 12}, {2, 19, 13}, {1, 31, 1}, {3, 0, 16}, {3, 16, 16}},
      {-500000, -3, 16777216 - 524287},
      1.0f / 1024.0f,
      {0, -20},
      {1.0f / 65534.0f, 0.001f},
      0};
  return layout;
}

static void expect_refused(foredraw_packed_layout layout, const char* what) {
  expect(!foredraw_packed_is_layout(&layout), what);
}

static void refuses_what_is_no_layout(void) {
  foredraw_packed_layout layout = good();
  expect(foredraw_packed_is_layout(&layout), "a layout is refused");
  layout.field[FOREDRAW_PACKED_X].bits = 21, expect_refused(layout, "fields that overlap");
  layout = good(), layout.field[FOREDRAW_PACKED_V].shift = 17, expect_refused(layout, "a field over the word's end");
  layout = good(), layout.field[FOREDRAW_PACKED_V].shift = 0xffffffffu, expect_refused(layout, "a shift of 2^32 - 1");
  layout = good(), layout.field[FOREDRAW_PACKED_V].bits = 0xffffffffu, expect_refused(layout, "2^32 - 1 bits");
  layout = good(), layout.field[FOREDRAW_PACKED_V].word = 4, expect_refused(layout, "a fifth word");
  layout = good(), layout.field[FOREDRAW_PACKED_Z].bits = 0, expect_refused(layout, "no z");
  layout = good(), layout.field[FOREDRAW_PACKED_NORMAL_1].bits = 11, expect_refused(layout, "uneven normals");
  layout = good(), layout.field[FOREDRAW_PACKED_SIGN].bits = 0, expect_refused(layout, "a tangent without sign");
  layout = good(), layout.field[FOREDRAW_PACKED_U].bits = 0, expect_refused(layout, "v without u");
  layout = good(), layout.field[FOREDRAW_PACKED_NORMAL_0].bits = layout.field[FOREDRAW_PACKED_NORMAL_1].bits = 0;
  expect_refused(layout, "a tangent without normal");
  layout = good(), layout.origin[2] += 1, expect_refused(layout, "a lattice beyond 2^24");
  layout = good(), layout.origin[0] = -16777217, expect_refused(layout, "an origin below -2^24");
  layout = good(), layout.step = 0.001f, expect_refused(layout, "a step that is no power of two");
  layout = good(), layout.step = 0.0f, expect_refused(layout, "a step of 0");
  layout = good(), layout.step = -1.0f, expect_refused(layout, "a step below 0");
  layout = good(), layout.step = (float)INFINITY, expect_refused(layout, "an infinite step");
  layout = good(), layout.uv_step[1] = (float)NAN, expect_refused(layout, "a step of u that is no number");
  layout = good(), layout.is_spherical = 2, expect_refused(layout, "a method that is not known");
}

static void positions_are_the_nearest_of_the_lattice(void) {
  const foredraw_packed_layout layout = good();
  uint32_t seed = 1;
  int i, c;
  for (i = 0; i < 100000; ++i) {
    foredraw_packed_vertex vertex, again;
    uint32_t row[4];
    memset(&vertex, 0, sizeof vertex);
    vertex.normal[2] = vertex.tangent[0] = 1;
    for (c = 0; c < 3; ++c) {
      const double most = (double)(layout.origin[c] + (int32_t)foredraw_packed_most(layout.field[c].bits));
      seed = seed * 1664525u + 1013904223u;
      vertex.position[c] =
          (float)(((double)layout.origin[c] + (most - (double)layout.origin[c]) * (double)seed / 4294967296.0) / 1024);
    }
    expect(foredraw_packed_encode(&layout, &vertex, row) == 0, "a vertex within does not fit");
    foredraw_packed_decode(&layout, row, &again);
    for (c = 0; c < 3; ++c) {
      const double wanted = nearbyint((double)vertex.position[c] * 1024) / 1024;
      expect((double)again.position[c] == wanted, "not the nearest one of the lattice");
    }
  }
}

static void says_what_does_not_fit(void) {
  const foredraw_packed_layout layout = good();
  foredraw_packed_vertex vertex, again;
  uint32_t row[4];
  memset(&vertex, 0, sizeof vertex);
  vertex.position[2] = 16300;
  vertex.normal[0] = 3e-10f;
  vertex.tangent[1] = 5e10f;
  vertex.tangent[3] = -0.5f;
  vertex.uv[0] = 1;
  expect(foredraw_packed_encode(&layout, &vertex, row) == 0, "lengths do not matter");
  foredraw_packed_decode(&layout, row, &again);
  expect(fabsf(again.normal[0] - 1) < 1e-6f && again.normal[1] == 0 && again.normal[2] == 0, "an axis is not exact");
  expect(fabsf(again.tangent[1] - 1) < 1e-6f && again.tangent[0] == 0 && again.tangent[2] == 0, "nor its tangent");
  expect(again.tangent[3] == -1, "the sign is lost");
  vertex.position[0] = (float)NAN;
  expect(foredraw_packed_encode(&layout, &vertex, row) == FOREDRAW_PACKED_POSITION_OUTSIDE, "NaN fits");
  vertex.position[0] = 1e30f;
  expect(foredraw_packed_encode(&layout, &vertex, row) == FOREDRAW_PACKED_POSITION_OUTSIDE, "1e30 fits");
  foredraw_packed_decode(&layout, row, &again);
  expect(again.position[0] == (float)(1048575 - 500000) / 1024, "it is not clamped");
  vertex.position[0] = 0;
  vertex.uv[1] = -0.0206f;
  expect(foredraw_packed_encode(&layout, &vertex, row) == FOREDRAW_PACKED_UV_OUTSIDE, "a uv below fits");
  vertex.uv[1] = -0.0204f;
  vertex.tangent[1] = 0;
  vertex.tangent[0] = -7;
  expect(foredraw_packed_encode(&layout, &vertex, row) == FOREDRAW_PACKED_NO_TANGENT, "a tangent along the normal");
  vertex.normal[0] = (float)NAN;
  expect((foredraw_packed_encode(&layout, &vertex, row) & FOREDRAW_PACKED_NO_NORMAL) != 0, "a normal of NaN");
  vertex.normal[0] = 0;
  expect((foredraw_packed_encode(&layout, &vertex, row) & FOREDRAW_PACKED_NO_NORMAL) != 0, "a normal of 0");
  foredraw_packed_decode(&layout, row, &again);
  expect(fabsf(again.normal[2] - 1) < 1e-6f, "it is not +z");
}

/* Any bits at all are some vertex, with a frame. */
static void any_bits_are_a_vertex(int is_spherical) {
  foredraw_packed_layout layout = good();
  uint32_t seed = 7;
  int i, c;
  layout.is_spherical = (uint32_t)is_spherical;
  for (i = 0; i < 200000; ++i) {
    foredraw_packed_vertex vertex;
    uint32_t row[4];
    float normal = 0, tangent = 0, between = 0;
    for (c = 0; c < 4; ++c) row[c] = seed = seed * 1664525u + 1013904223u;
    foredraw_packed_decode(&layout, row, &vertex);
    for (c = 0; c < 3; ++c) {
      normal += vertex.normal[c] * vertex.normal[c];
      tangent += vertex.tangent[c] * vertex.tangent[c];
      between += vertex.normal[c] * vertex.tangent[c];
    }
    expect(fabsf(normal - 1) < 1e-6f && fabsf(tangent - 1) < 2e-6f && fabsf(between) < 1e-6f, "no frame");
  }
}

int packed_vertex_test(void) {
  refuses_what_is_no_layout();
  positions_are_the_nearest_of_the_lattice();
  says_what_does_not_fit();
  any_bits_are_a_vertex(0);
  any_bits_are_a_vertex(1);
  return failures;
}
