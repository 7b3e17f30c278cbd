#pragma once
/* The view in which tests look at wires. */

#include <foredraw/runtime/wire_radius.h>

static const float width = 400.0f, height = 300.0f;

/* Row by row here, for people; the header takes columns. */
static foredraw_wire_view view_of(float rows[4][4]) {
  float columns[16];
  int r, c;
  for (r = 0; r < 4; ++r) {
    for (c = 0; c < 4; ++c) columns[4 * c + r] = rows[r][c];
  }
  return foredraw_wire_view_of(columns, width, height);
}
