/* The header alone, as a C compiler of an engine sees it. */
#include <foredraw/runtime/seam_table.h>

#include "check.h"

int seam_table_test(void) {
  static const uint16_t heights[4] = {1000, 3000, 2000, 65535};
  static const uint32_t firsts[3] = {0, 3, 3}, ends[2] = {0, 65535}, turned[2] = {65535, 0};
  static const uint8_t parts_log2[3] = {2, 0, 1};
  static const foredraw_seam_side sides[4] = {{1, 0}, {4, 1}, {5, 3}, {90, 4}};
  foredraw_seam_table table;
  foredraw_seam_side missing;
  uint32_t place;
  table.heights = heights, table.height_count = 4;
  table.firsts = firsts, table.parts_log2 = parts_log2, table.edge_count = 3;
  CHECK(foredraw_seam_table_is_sound(&table));
  CHECK(foredraw_seam_side_of(sides, 4, 4) == &sides[1]);
  CHECK(foredraw_seam_side_of(sides, 4, 90) == &sides[3]);
  CHECK(foredraw_seam_side_of(sides, 4, 0) == NULL);
  CHECK(foredraw_seam_side_of(sides, 4, 6) == NULL);
  CHECK(foredraw_seam_side_of(sides, 4, 91) == NULL);
  CHECK(foredraw_seam_side_of(sides, 0, 1) == NULL);

  CHECK(foredraw_seam_height(&table, &sides[0], ends, 0, 16) == 0);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 16384, 16) == 1000);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 24576, 16) == 2000);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 32768, 16) == 3000);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 49152, 16) == 2000);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 65536, 16) == 65535);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 70000, 16) == 65535);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 16384, 14) == 250);
  CHECK(foredraw_seam_height(&table, &sides[0], ends, 16384, 99) == 1000);
  CHECK(foredraw_seam_height(&table, &sides[2], ends, 65536, 16) == 65535); /* of one part: its ends alone */
  CHECK(foredraw_seam_height(&table, &sides[2], ends, 32768, 16) == 32767);
  CHECK(foredraw_seam_height(&table, &sides[3], ends, 32768, 16) == 65535);
  for (place = 0; place <= 65536u; ++place) { /* both triangles of an edge, wherever a tessellator puts a point */
    CHECK(foredraw_seam_height(&table, &sides[0], ends, place, 14) ==
          foredraw_seam_height(&table, &sides[1], turned, 65536u - place, 14));
  }
  missing.side = 0, missing.edge = 6;
  CHECK(foredraw_seam_height(&table, &missing, ends, 5, 14) == 0);
  missing.edge = UINT32_MAX;
  CHECK(foredraw_seam_height(&table, &missing, ends, 5, 14) == 0);

  table.height_count = 3;
  CHECK(!foredraw_seam_table_is_sound(&table));
  table.height_count = 4;
  {
    static const uint8_t far_too_many[3] = {2, 0, 200};
    static const uint32_t outside[3] = {0, 3, 4294967295u};
    table.parts_log2 = far_too_many;
    CHECK(!foredraw_seam_table_is_sound(&table));
    table.parts_log2 = parts_log2, table.firsts = outside;
    CHECK(!foredraw_seam_table_is_sound(&table));
  }
  return failures != 0;
}
