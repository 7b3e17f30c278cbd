#include <foredraw/runtime/tessellation_scale.h>

#include "check.h"

int tessellation_scale_test(void) {
  const foredraw_tessellation_scale table[3] = {{960, 0.25f, 1.0f}, {240, 0.5f, 1.0f}, {40, 2.0f, 3.0f}};
  uint32_t s;
  /* By the error. */
  CHECK(foredraw_tessellation_scale_for(table, 3, 1e9f) == 2);
  CHECK(foredraw_tessellation_scale_for(table, 3, 2.0f) == 2);
  CHECK(foredraw_tessellation_scale_for(table, 3, 1.99f) == 1);
  CHECK(foredraw_tessellation_scale_for(table, 3, 0.5f) == 1);
  CHECK(foredraw_tessellation_scale_for(table, 3, 0.49f) == 0);
  CHECK(foredraw_tessellation_scale_for(table, 3, 0.1f) == 0);
  CHECK(foredraw_tessellation_scale_for(table, 3, NAN) == 0);
  CHECK(foredraw_tessellation_scale_for(table, 1, 1e9f) == 0);
  CHECK(foredraw_tessellation_scale_for(0, 0, 1.0f) == 0);
  /* By triangles. */
  CHECK(foredraw_tessellation_scale_within(table, 3, 1000) == 0);
  CHECK(foredraw_tessellation_scale_within(table, 3, 960) == 0);
  CHECK(foredraw_tessellation_scale_within(table, 3, 959) == 1);
  CHECK(foredraw_tessellation_scale_within(table, 3, 40) == 2);
  CHECK(foredraw_tessellation_scale_within(table, 3, 0) == 2);
  CHECK(foredraw_tessellation_scale_within(0, 0, 7) == 0);
  /* Levels: whole scales are exact. */
  for (s = 0; s <= 6; ++s) {
    CHECK(foredraw_tessellation_scaled((uint8_t)s, 0.0f) == (float)(1u << s));
    CHECK(foredraw_tessellation_scaled(6, (float)s) == (float)(64u >> s));
    CHECK(foredraw_tessellation_scaled((uint8_t)s, (float)s) == 1.0f);
    CHECK(foredraw_tessellation_scaled((uint8_t)s, 99.0f) == 1.0f);
  }
  CHECK(foredraw_tessellation_scaled(255, 0.0f) == 64.0f);
  CHECK(foredraw_tessellation_scaled(3, NAN) == 8.0f);
  CHECK(foredraw_tessellation_scaled(3, -5.0f) == 8.0f);
  CHECK(foredraw_tessellation_scaled(3, INFINITY) == 1.0f);
  CHECK(foredraw_tessellation_scaled(3, 0.5f) > 5.6f && foredraw_tessellation_scaled(3, 0.5f) < 5.7f);
  return failures != 0;
}
