/* One tessellation level for all: the paper's, the one by square root, and what a tessellator makes of both. */
#include "check.h"

#include <foredraw/runtime/tessellation_level.h>

static uint32_t triangles_of(float level, foredraw_spacing spacing) { /* as it is drawn */
  return foredraw_tessellation_triangles(foredraw_tessellation_parts(level, spacing));
}

static void levels_are_the_papers(void) {
  CHECK(foredraw_tessellation_by_count(4, 15, 1) == 15);
  CHECK(foredraw_tessellation_by_count(4, 15, 4) == 15);
  CHECK(foredraw_tessellation_by_count(4, 15, 8) == 7.5f);
  CHECK(foredraw_tessellation_by_count(4, 15, 60) == 1);
  CHECK(foredraw_tessellation_by_count(4, 15, 4000000000u) == 1);
  CHECK(foredraw_tessellation_by_root(4, 15, 16) == 7.5f);
  CHECK(foredraw_tessellation_by_root(4, 15, 900) == 1);
}

static void nothing_divides_by_nothing(void) {
  CHECK(foredraw_tessellation_by_count(0, 15, 0) == 15);
  CHECK(foredraw_tessellation_by_count(0, 15, 3) == 1);
  CHECK(foredraw_tessellation_by_root(0, 15, 0) == 15);
  CHECK(foredraw_tessellation_by_root(0, 15, 3) == 1);
  CHECK(foredraw_tessellation_by_count(4, 0, 2) == 1);
  CHECK(foredraw_tessellation_by_root(4, 1, 2) == 1);
  CHECK(foredraw_tessellation_by_count(4294967295u, 4294967295u, 4294967295u) == 4294967296.0f);
}

/* "Divides triangles evenly" it does not, and "never exceeds" it does. */
static void the_papers_bound_breaks(void) {
  const uint32_t budget = 4 * 337;
  const uint32_t at_4_m =
      foredraw_tessellation_floor(foredraw_tessellation_by_count(4, 15, 16), FOREDRAW_SPACING_EQUAL);
  uint32_t n, first = 0;
  CHECK(at_4_m == 3 && 16 * foredraw_tessellation_triangles(at_4_m) == 208); /* 15 % of the budget */
  for (n = 2000; n > 0; --n) {
    const float level = foredraw_tessellation_by_count(4, 15, n);
    if (n * triangles_of((float)foredraw_tessellation_floor(level, FOREDRAW_SPACING_EQUAL), FOREDRAW_SPACING_EQUAL) >
        budget)
      first = n;
  }
  CHECK(first == budget + 1); /* a level of 1 is a triangle; by 1.5 T^2 it would be M Tmax^2 */
}

/* Rounded up, as tessellators do, the level by square root takes more than the budget; made whole before, never but for
 * the half triangle that 15 is short of 1.5 * 15^2. */
static void levels_have_to_be_made_whole(void) {
  const foredraw_spacing spacings[2] = {FOREDRAW_SPACING_EQUAL, FOREDRAW_SPACING_FRACTIONAL_ODD};
  uint32_t s, n;
  CHECK(5 * triangles_of(foredraw_tessellation_by_root(4, 15, 5), FOREDRAW_SPACING_EQUAL) == 1470);
  for (s = 0; s < 2; ++s) {
    uint32_t broken = 0, by_a_half = 0;
    for (n = 1; n <= 1348; ++n) {
      const float level = foredraw_tessellation_by_root(4, 15, n);
      const uint32_t whole = foredraw_tessellation_floor(level, spacings[s]);
      const uint32_t taken = n * triangles_of((float)whole, spacings[s]);
      broken += n * triangles_of(level, spacings[s]) > 4 * 337;
      by_a_half += taken > 4 * 337;
      CHECK(taken <= 4 * 15 * 15 * 3 / 2);
    }
    CHECK(broken > 700);
    CHECK(by_a_half == (s == 0 ? 3 : 0));
  }
}

static void parts_are_those_of_vulkan(void) {
  static const uint32_t known[8] = {1, 6, 13, 24, 37, 54, 73, 96};
  uint32_t i;
  for (i = 0; i < 8; ++i) CHECK(foredraw_tessellation_triangles(i + 1) == known[i]);
  CHECK(foredraw_tessellation_triangles(64) == 6144);
  CHECK(triangles_of(16, FOREDRAW_SPACING_FRACTIONAL_ODD) == 433);
  CHECK(triangles_of(12.5f, FOREDRAW_SPACING_EQUAL) == 253);
  CHECK(foredraw_tessellation_parts(0.5f, FOREDRAW_SPACING_FRACTIONAL_EVEN) == 2);
  CHECK(foredraw_tessellation_parts(-1, FOREDRAW_SPACING_EQUAL) == 1);
  CHECK(foredraw_tessellation_parts(1e30f, FOREDRAW_SPACING_EQUAL) == 64);
  CHECK(foredraw_tessellation_parts(INFINITY, FOREDRAW_SPACING_FRACTIONAL_ODD) == 63);
  CHECK(foredraw_tessellation_parts(NAN, FOREDRAW_SPACING_FRACTIONAL_ODD) == 1);
}

static void whole_levels_stay(void) {
  int s;
  float level;
  for (s = FOREDRAW_SPACING_EQUAL; s <= FOREDRAW_SPACING_FRACTIONAL_EVEN; ++s) {
    const foredraw_spacing spacing = (foredraw_spacing)s;
    for (level = 0; level < 70; level += 0.125f) {
      const uint32_t whole = foredraw_tessellation_floor(level, spacing);
      CHECK(foredraw_tessellation_parts((float)whole, spacing) == whole);
      CHECK((float)whole <= level || whole == foredraw_tessellation_parts(0, spacing));
      CHECK((float)whole > level - 2 || level >= 63);
    }
    CHECK(foredraw_tessellation_floor(NAN, spacing) == foredraw_tessellation_parts(0, spacing));
  }
}

int tessellation_level_test(void) {
  levels_are_the_papers();
  nothing_divides_by_nothing();
  the_papers_bound_breaks();
  levels_have_to_be_made_whole();
  parts_are_those_of_vulkan();
  whole_levels_stay();
  return failures != 0;
}
