/* Vertices of a cage as a pose has them, against sums in double precision. */
#include <foredraw/runtime/displaced_cage.h>
#include <foredraw/runtime/displaced_height.h>
#include <foredraw/runtime/displaced_surface.h>

#include "check.h"

static uint32_t state = 1;

static float random_number(void) { /* -1 to 1 */
  state = state * 1664525u + 1013904223u;
  return (float)(int32_t)(state >> 8) / 8388608.0f - 1.0f;
}

static double farther(double a, double b) { return a > b ? a : b; }

int displaced_cage_test(void) {
  double worst = 0;
  int i, j, r, c;
  for (i = 0; i < 10000; ++i) {
    foredraw_cage_map maps[6], map;
    foredraw_cage_skin skin = {{0, 5, 2, 3}, {0, 0, 0, 0}};
    foredraw_cage_vertex rest, posed;
    for (j = 0; j < 6; ++j) {
      for (r = 0; r < 3; ++r) {
        for (c = 0; c < 4; ++c) maps[j].row[r][c] = random_number();
      }
    }
    for (c = 0; c < 4; ++c) skin.weight[c] = random_number();
    for (c = 0; c < 3; ++c) {
      rest.position[c] = random_number();
      rest.direction[c] = random_number();
    }
    rest.x = i;
    rest.y = -i;
    map = foredraw_cage_blended(maps, skin.joint, skin.weight);
    posed = foredraw_cage_posed(&rest, &map);
    CHECK(posed.x == i && posed.y == -i);
    for (r = 0; r < 3; ++r) {
      double position = 0, direction = 0;
      for (j = 0; j < 4; ++j) {
        const float* row = maps[skin.joint[j]].row[r];
        double along = 0, turned = 0;
        for (c = 0; c < 3; ++c) {
          along += (double)row[c] * (double)rest.position[c];
          turned += (double)row[c] * (double)rest.direction[c];
        }
        position += (double)skin.weight[j] * (along + (double)row[3]);
        direction += (double)skin.weight[j] * turned;
      }
      worst = farther(worst, fabs(position - (double)posed.position[r]));
      worst = farther(worst, fabs(direction - (double)posed.direction[r]));
    }
  }
  CHECK(worst < 4e-6);
  CHECK(worst > 0); /* or nothing was computed in float */

  { /* The identity changes no bit, and one joint with all the weight is that joint. */
    const foredraw_cage_map maps[2] = {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
                                       {{{9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}}}};
    const uint32_t joint[4] = {0, 1, 1, 0};
    const float weight[4] = {1, 0, 0, 0};
    const foredraw_cage_vertex rest = {{0.1f, -0.7f, 1e-6f}, 3, {0.6f, 0, -0.8f}, 4};
    const foredraw_cage_map map = foredraw_cage_blended(maps, joint, weight);
    const foredraw_cage_vertex posed = foredraw_cage_posed(&rest, &map);
    for (c = 0; c < 3; ++c) CHECK(posed.position[c] == rest.position[c] && posed.direction[c] == rest.direction[c]);
  }
  return failures != 0;
}
