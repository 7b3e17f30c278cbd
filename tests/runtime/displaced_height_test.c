/* The header alone, as a C compiler of an engine sees it. */
#include <foredraw/runtime/displaced_height.h>

#include "check.h"

static uint32_t seed = 1;

static uint32_t random_bits(void) {
  seed = seed * 1664525u + 1013904223u;
  return seed >> 8;
}

static int32_t random_place(void) { return (int32_t)(random_bits() % 4096000u) - 2048000; }

static void places(void) {
  CHECK(foredraw_height_place(0.0f, 4096) == 0);
  CHECK(foredraw_height_place(1.0f, 4096) == 4096 * 256);
  CHECK(foredraw_height_place(-0.25f, 100) == -6400);
  CHECK(foredraw_height_place(0.5f / 256.0f, 1) == 0); /* halves to the even one */
  CHECK(foredraw_height_place(1.5f / 256.0f, 1) == 2);
  CHECK(foredraw_height_place(-1.5f / 256.0f, 1) == -2);
  CHECK(foredraw_height_place((float)NAN, 512) == 0);
  CHECK(foredraw_height_place(1e30f, 512) == FOREDRAW_HEIGHT_MOST_PLACE);
  CHECK(foredraw_height_place(-1e30f, 512) == -FOREDRAW_HEIGHT_MOST_PLACE);
  CHECK(foredraw_height_place((float)INFINITY, 1) == FOREDRAW_HEIGHT_MOST_PLACE);
  CHECK(foredraw_height_place(3.0f, 65536) == 3 * 65536 * 256);
}

static void expect_weights(float a, float b, float c, uint32_t wa, uint32_t wb, uint32_t wc) {
  float at[3];
  uint32_t w[3];
  at[0] = a, at[1] = b, at[2] = c;
  foredraw_height_weights(at, w);
  CHECK(w[0] == wa && w[1] == wb && w[2] == wc);
}

static void weights(void) {
  int i, k;
  expect_weights(1, 0, 0, 65536, 0, 0);
  expect_weights(0, 0, 1, 0, 0, 65536);
  expect_weights(0.25f, 0.75f, 0, 16384, 49152, 0);
  expect_weights(0, 0, 0, 65536, 0, 0);
  expect_weights((float)NAN, -1, 7, 0, 0, 65536);
  expect_weights(1, 1, 1, 0, 65536, 0);
  expect_weights(0.3f, 0.5f, 0.5f, 19661, 45875 - 32768, 32768);
  for (k = 0; k <= 64; ++k) {
    const float t = (float)k / 64.0f;
    expect_weights(1 - t, t, 0, 65536u - 1024u * (uint32_t)k, 1024u * (uint32_t)k, 0);
    expect_weights(0, t, 1 - t, 0, 1024u * (uint32_t)k, 65536u - 1024u * (uint32_t)k);
  }
  for (i = 0; i < 100000; ++i) { /* an edge from both of its triangles */
    const float t = (float)random_bits() / 16777216.0f;
    float there[3], back[3];
    uint32_t w[3], v[3];
    there[0] = 1 - t, there[1] = t, there[2] = 0;
    back[0] = 0, back[1] = t, back[2] = 1 - t;
    foredraw_height_weights(there, w);
    foredraw_height_weights(back, v);
    CHECK(w[0] + w[1] == 65536 && w[2] == 0);
    CHECK(w[0] == v[2] && w[1] == v[1] && v[0] == 0);
  }
}

/* What a shader without 64-bit numbers adds. */
static int32_t in_halves(const int32_t c[3], const uint32_t w[3]) {
  int32_t a = 0, b = 0;
  int i;
  for (i = 0; i < 3; ++i) {
    const int32_t upper = (int32_t)(((uint32_t)c[i] + 0x80000000u) >> 12) - 0x80000;
    a += (int32_t)w[i] * upper;
    b += (int32_t)w[i] * (c[i] - 4096 * upper);
  }
  {
    const int32_t sixteenths = (int32_t)(((uint32_t)a + 0x80000000u) >> 4) - 0x8000000;
    return sixteenths + (((a - 16 * sixteenths) * 4096 + b + 32768) >> 16);
  }
}

static void between(void) {
  int i, c;
  const int32_t far_corners[3] = {FOREDRAW_HEIGHT_MOST_PLACE, -FOREDRAW_HEIGHT_MOST_PLACE, FOREDRAW_HEIGHT_MOST_PLACE};
  const uint32_t first[3] = {65536, 0, 0}, halves[3] = {32768, 32768, 0};
  const int32_t odd[3] = {3, 4, 0}, below[3] = {-3, -4, 0};
  CHECK(foredraw_height_between(far_corners, first) == FOREDRAW_HEIGHT_MOST_PLACE);
  CHECK(foredraw_height_between(far_corners, halves) == 0);
  CHECK(foredraw_height_between(odd, halves) == 4); /* halves up */
  CHECK(foredraw_height_between(below, halves) == -3);
  for (i = 0; i < 100000; ++i) {
    int32_t corners[3], turned[3];
    uint32_t w[3], v[3];
    int32_t at;
    double exact = 0;
    w[0] = random_bits() % 65537u;
    w[1] = random_bits() % (65537u - w[0]);
    w[2] = 65536u - w[0] - w[1];
    for (c = 0; c < 3; ++c) {
      corners[c] = i % 2 ? random_place() : (int32_t)(random_bits() % 134217729u) * 8 % 134217729 - 67108864;
      exact += (double)w[c] * corners[c] / 65536.0;
    }
    for (c = 0; c < 3; ++c) turned[c] = corners[(c + 1) % 3], v[c] = w[(c + 1) % 3];
    at = foredraw_height_between(corners, w);
    CHECK(at == (int32_t)floor(exact + 0.5));
    CHECK(at == foredraw_height_between(turned, v));
    CHECK(at == in_halves(corners, w));
  }
}

static void texels(void) {
  int32_t i;
  static const uint32_t mirrored[12] = {0, 1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0};
  for (i = -30; i < 30; ++i) {
    CHECK(foredraw_height_texel(i, 3, FOREDRAW_HEIGHT_REPEAT) == (uint32_t)((i + 30) % 3));
    CHECK(foredraw_height_texel(i, 3, FOREDRAW_HEIGHT_MIRRORED) == mirrored[(i + 30) % 12]);
    CHECK(foredraw_height_texel(i, 3, FOREDRAW_HEIGHT_CLAMPED) == (uint32_t)(i < 0 ? 0 : i > 2 ? 2 : i));
    CHECK(foredraw_height_texel(i, 1, (uint8_t)(i + 30)) == 0);
  }
  CHECK(foredraw_height_texel(INT32_MIN, 65536, FOREDRAW_HEIGHT_MIRRORED) == 0);
  CHECK(foredraw_height_texel(INT32_MAX, 65536, FOREDRAW_HEIGHT_REPEAT) == 65535);
  CHECK(foredraw_height_texel(INT32_MAX, 7, 200) == 6);
}

/* The texel of a row or column at a number, by walking there. */
static uint32_t walked(int32_t number, uint32_t size, int wrap) {
  int32_t at = number;
  const int32_t n = (int32_t)size;
  while (at < 0 || at >= n) {
    if (wrap == FOREDRAW_HEIGHT_CLAMPED) return at < 0 ? 0u : size - 1u;
    if (wrap == FOREDRAW_HEIGHT_MIRRORED) at = at < 0 ? -1 - at : 2 * n - 1 - at;
    if (wrap == FOREDRAW_HEIGHT_REPEAT) at += at < 0 ? n : -n;
  }
  return (uint32_t)at;
}

static void heights(void) {
  static uint16_t map_texels[5 * 7];
  foredraw_height_map map;
  int i;
  for (i = 0; i < 35; ++i) map_texels[i] = (uint16_t)(i % 4 == 0 ? 65535u : random_bits() & 65535u);
  map.texels = map_texels, map.width = 5, map.height = 7;
  for (i = 0; i < 200000; ++i) {
    const int32_t x = (int32_t)(random_bits() % 16000u) - 8000, y = (int32_t)(random_bits() % 16000u) - 8000;
    const double u = x / 256.0 - 0.5, v = y / 256.0 - 0.5;
    const int32_t column = (int32_t)floor(u), row = (int32_t)floor(v);
    double sum = 0;
    int k;
    map.wrap[0] = (uint8_t)(i % 3), map.wrap[1] = (uint8_t)(i / 3 % 3), map.is_nearest = 0;
    for (k = 0; k < 4; ++k) {
      const uint32_t at_x = walked(column + k % 2, 5, map.wrap[0]), at_y = walked(row + k / 2, 7, map.wrap[1]);
      sum += (k % 2 ? u - column : 1 - u + column) * (k / 2 ? v - row : 1 - v + row) * map_texels[5 * at_y + at_x];
    }
    CHECK(foredraw_height_sum(&map, x, y) == (uint32_t)(sum * 65536.0)); /* exact in doubles */
    CHECK(foredraw_displaced_height(&map, x, y, 14) == (uint32_t)(sum / 4.0));
    CHECK(foredraw_displaced_height(&map, x, y, 12) == (uint32_t)(sum / 16.0));
    CHECK(foredraw_displaced_height(&map, x, y, 77) == (uint32_t)sum);
    map.is_nearest = 1;
    CHECK(foredraw_displaced_height(&map, x, y, 16) ==
          map_texels[5 * walked((int32_t)floor(y / 256.0), 7, map.wrap[1]) +
                     walked((int32_t)floor(x / 256.0), 5, map.wrap[0])]);
  }
  map.is_nearest = 0;
  for (i = 0; i < 35; ++i) map_texels[i] = 65535;
  for (i = 0; i < 1000; ++i) CHECK(foredraw_displaced_height(&map, random_place(), random_place(), 14) == 16383);
  CHECK(foredraw_height_sum(&map, FOREDRAW_HEIGHT_MOST_PLACE, -FOREDRAW_HEIGHT_MOST_PLACE) == 65535u * 65536u);
  CHECK(foredraw_height_part(16383, 14) == 1.0f && foredraw_height_part(0, 14) == 0.0f);
  CHECK(foredraw_height_part(65535, 0) == 1.0f);
  map.width = 0;
  CHECK(foredraw_height_sum(&map, 0, 0) == 0);
  map.width = 5, map.texels = NULL;
  CHECK(foredraw_height_sum(&map, 0, 0) == 0);
}

int displaced_height_test(void) {
  places();
  weights();
  between();
  texels();
  heights();
  return failures != 0;
}
