/* The header alone, as a C compiler of an engine sees it: a table on the stack, looked up. */

#include <foredraw/runtime/order_table.h>

#include <stdio.h>

static int failures = 0;

static void expect(uint32_t found, uint32_t wanted, const char* what) {
  if (found == wanted) return;
  printf("%s: %u, but expected %u\n", what, (unsigned)found, (unsigned)wanted);
  ++failures;
}

int order_table_test(void) {
  static const uint32_t keyframes[] = {2, 1};
  static const float times[] = {0, 1, 0};
  static const uint8_t order[] = {
      0, 1, 2, 3, /* clip 0 at 0 s: from above -X to +X by way of -Z, and back by way of +Z; from below */
      4, 5, 6, 7, /* at 1 s */
      8, 8, 9, 9, /* clip 1 */
  };
  static const uint16_t sequences[] = {0, 1, 2, /* of order 0 */ 2, 0, 1 /* of order 1 */};
  foredraw_order_table table = {2, keyframes, times, 2, 2, order, 0, NULL};
  static const float above_front[] = {0, 2, 1};
  static const float below_front[] = {0, -2, 1};
  static const float below_back[] = {0, -2, -1};
  static const float hardly_below[] = {0, -0.05f, 1};
  static const float hardly_above[] = {0, 0.05f, 1};
  foredraw_order_state state = {0, 0, 0};

  expect(foredraw_order_at(&table, 0, 0, above_front, NULL), 1, "above, in front");
  expect(foredraw_order_at(&table, 0, 0.4f, below_front, NULL), 3, "below, in front");
  expect(foredraw_order_at(&table, 0, 0.6f, below_back, NULL), 6, "later, below, behind");
  expect(foredraw_order_at(&table, 1, 7, below_back, NULL), 9, "the other clip");
  expect(foredraw_order_at(&table, FOREDRAW_NO_CLIP, 0, below_back, NULL), 0, "no clip");

  expect(foredraw_order_at(&table, 0, 0, above_front, &state), 1, "first look");
  expect(foredraw_order_at(&table, 0, 0, hardly_below, &state), 1, "hardly out of the cell");
  expect(foredraw_order_at(&table, 0, 0, below_front, &state), 3, "clearly out of it");
  expect(foredraw_order_at(&table, 0, 0, hardly_above, &state), 3, "hardly back");
  expect(foredraw_order_at(&table, 0, 1, hardly_above, &state), 7, "time passes without delay");

  if (foredraw_draw_sequence(&table, 1) != NULL) {
    printf("a table without sequences has one\n");
    ++failures;
  }
  table.parts = 3;
  table.sequences = sequences;
  expect(foredraw_draw_sequence(&table, 0)[2], 2, "sequence of order 0, last");
  expect(foredraw_draw_sequence(&table, 1)[0], 2, "sequence of order 1, first");
  expect(foredraw_draw_sequence(&table, 1)[2], 1, "sequence of order 1, last");
  return failures;
}
