#include <foredraw/runtime/order_table.h>

#include <stdio.h>
#include <string.h>

int main(void) {
  static const uint8_t orders[2] = {3, 5}; /* from above, from below */
  const float above[3] = {0, 1, 0}, below[3] = {0, -1, 0};
  foredraw_order_table table;
  foredraw_order_state state;
  memset(&table, 0, sizeof table);
  memset(&state, 0, sizeof state);
  table.theta_steps = 2;
  table.phi_steps = 1;
  table.order = orders;
  if (foredraw_order_at(&table, FOREDRAW_NO_CLIP, 0, above, &state) != 3) return 1;
  if (foredraw_order_at(&table, FOREDRAW_NO_CLIP, 0, below, &state) != 5) return 2;
  puts("drawn");
  return 0;
}
