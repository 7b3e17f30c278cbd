/* The header alone, as a C compiler of an engine sees it. */

#include <foredraw/runtime/geomorph.h>

#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("%s\n", what);
  ++failures;
}

static int same_bits(const float* a, const float* b, size_t count) { return memcmp(a, b, count * sizeof *a) == 0; }

int geomorph_test(void) {
  static const float fine[6] = {0.1f, -0.0f, 1e30f, 3.0f, 1.0f, 16777216.0f};
  static const float coarse[6] = {0.3f, 0.0f, -1e-30f, 3.0f, -0.0f, 16777217.5f};
  static const float along_x[3] = {1, 0, 0}, along_y[3] = {0, 1, 0}, back[3] = {-1, 0, 0};
  static const uint32_t first[3] = {1, 1, 0}, second[2] = {7, 5};
  float to[6], direction[3], four[4] = {9, 9, 9, 9};
  uint32_t chain[3];
  int i, c;

  foredraw_geomorph(fine, coarse, 0.0f, 6, to);
  expect(same_bits(to, fine, 6), "at 0 it is not the level");
  foredraw_geomorph(fine, coarse, 1.0f, 6, to);
  expect(same_bits(to, coarse, 6), "at 1 it is not the next level");
  foredraw_geomorph(fine, coarse, -3.0f, 6, to);
  expect(same_bits(to, fine, 6), "below 0 it is not the level");
  foredraw_geomorph(fine, coarse, (float)NAN, 6, to);
  expect(same_bits(to, fine, 6), "with NaN it is not the level");
  foredraw_geomorph(fine, coarse, 7.0f, 6, to);
  expect(same_bits(to, coarse, 6), "above 1 it is not the next level");
  for (i = 1; i < 1000; ++i) {
    foredraw_geomorph(fine, coarse, (float)i / 1000.0f, 6, to);
    for (c = 0; c < 6; ++c) {
      const float least = fine[c] < coarse[c] ? fine[c] : coarse[c], most = fine[c] < coarse[c] ? coarse[c] : fine[c];
      expect(to[c] >= least && to[c] <= most, "it leaves the two");
    }
  }
  foredraw_geomorph_direction(along_x, along_y, 0.5f, direction);
  expect(fabsf(direction[0] - sqrtf(0.5f)) < 1e-6f && fabsf(direction[1] - sqrtf(0.5f)) < 1e-6f,
         "a normal is not of length 1");
  foredraw_geomorph_direction(along_x, back, 0.5f, direction);
  expect(direction[0] == 0.0f, "opposite normals have no middle");
  foredraw_geomorph_direction(along_x, along_y, 1.0f, direction);
  expect(same_bits(direction, along_y, 3), "at 1 a normal is not the next one");
  foredraw_geomorph_direction(fine, coarse, 0.5f, four);
  expect(four[3] == 9.0f, "a direction is of three numbers");
  foredraw_geomorph_chain(first, second, 3, chain);
  expect(chain[0] == 5 && chain[1] == 5 && chain[2] == 7, "ancestors of ancestors");
  return failures;
}
