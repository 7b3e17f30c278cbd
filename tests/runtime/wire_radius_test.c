/* The header alone, as a C compiler of an engine sees it, beside what a wire's projection is when it is measured point
 * by point. */

#include "check.h"
#include "wire_view.h"

#include <string.h>

static void multiply(float a[4][4], float b[4][4], float to[4][4]) {
  int r, c, k;
  for (r = 0; r < 4; ++r) {
    for (c = 0; c < 4; ++c) {
      to[r][c] = 0.0f;
      for (k = 0; k < 4; ++k) to[r][c] += a[r][k] * b[k][c];
    }
  }
}

/* Half the width that the points of a circle around the line have on the screen, at right angles to the line. */
static double measured(const foredraw_wire_view* view, const double centre[3], const double axis[3], double r) {
  double side[3] = {axis[1], -axis[0], 0}, up[3], along[3], line[2], most = 0, length, place[2];
  int i, c;
  if (axis[0] == 0 && axis[1] == 0) side[0] = 1;
  length = sqrt(side[0] * side[0] + side[1] * side[1]);
  for (c = 0; c < 3; ++c) side[c] /= length;
  for (c = 0; c < 3; ++c) up[c] = axis[(c + 1) % 3] * side[(c + 2) % 3] - axis[(c + 2) % 3] * side[(c + 1) % 3];
#define PROJECTED(point, to)                                                                   \
  do {                                                                                         \
    double h_[3];                                                                              \
    int r_;                                                                                    \
    for (r_ = 0; r_ < 3; ++r_)                                                                 \
      h_[r_] = (double)view->row[r_][0] * (point)[0] + (double)view->row[r_][1] * (point)[1] + \
               (double)view->row[r_][2] * (point)[2] + (double)view->row[r_][3];               \
    (to)[0] = h_[0] / h_[2], (to)[1] = h_[1] / h_[2];                                          \
  } while (0)
  for (c = 0; c < 3; ++c) along[c] = centre[c] + 1e-4 * axis[c];
  PROJECTED(centre, place);
  PROJECTED(along, line);
  line[0] -= place[0], line[1] -= place[1];
  length = sqrt(line[0] * line[0] + line[1] * line[1]);
  for (i = 0; i < 3600; ++i) {
    const double angle = i * 3.14159265358979 / 1800;
    double point[3], at[2], distance;
    for (c = 0; c < 3; ++c) point[c] = centre[c] + r * (cos(angle) * side[c] + sin(angle) * up[c]);
    PROJECTED(point, at);
    distance = fabs((at[1] - place[1]) * line[0] - (at[0] - place[0]) * line[1]) / length;
    if (distance > most) most = distance;
  }
  return most;
}

static void check_widths(void) {
  float perspective[4][4] = {{1.2f, 0, 0.3f, 0}, {0, 1.6f, -0.2f, 0}, {0, 0, -1, -0.1f}, {0, 0, -1, 0}}; /* off-axis */
  float parallel[4][4] = {{0.2f, 0, 0, 0.1f}, {0, 0.3f, 0, 0}, {0, 0, -0.01f, 0}, {0, 0, 0, 1}};
  float rolled[4][4] = {{0.8f, -0.6f, 0, 0}, {0.6f, 0.8f, 0, 0}, {0, 0, 1, -7}, {0, 0, 0, 1}};
  float nodes[4][4][4] = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
                          {{10, 0, 0, 0}, {0, 10, 0, 0}, {0, 0, 10, -30}, {0, 0, 0, 1}},
                          {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 5, 0}, {0, 0, 0, 1}},
                          {{-1, 0, 0, 0}, {0, 2, 0.5f, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  static const double axes[5][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0, 0.8}, {-0.48, 0.6, 0.64}};
  static const double centres[3][3] = {{0, 0, 0}, {2, 1, 0.5}, {-1.5, 1.2, -0.5}};
  int camera, node, axis, place, c;
  for (camera = 0; camera < 2; ++camera) {
    for (node = 0; node < 4; ++node) {
      float moved[4][4], clip[4][4];
      foredraw_wire_view view;
      multiply(rolled, nodes[node], moved);
      multiply(camera == 0 ? perspective : parallel, moved, clip);
      view = view_of(clip);
      for (axis = 0; axis < 5; ++axis) {
        for (place = 0; place < 3; ++place) {
          float centre[3], direction[3];
          foredraw_wire_section at;
          const double r = 1e-4;
          double width_there;
          for (c = 0; c < 3; ++c) centre[c] = (float)centres[place][c], direction[c] = (float)axes[axis][c];
          at = foredraw_wire_section_at(&view, centre, direction);
          width_there = measured(&view, centres[place], axes[axis], r);
          if (axis == 2 && camera == 1 && node < 3) continue; /* end on: no direction is across */
          CHECK(fabs((double)at.pixels * r / width_there - 1) < 2e-3);
        }
      }
    }
  }
}

/* In the middle of an upright picture it is the paper's pixel size. */
static void check_pixel_scale(void) {
  float clip[4][4] = {{1.2f, 0, 0, 0}, {0, 1.6f, 0, 0}, {0, 0, -1, -0.1f}, {0, 0, -1, 0}};
  static const float centre[3] = {0, 0, -50}, along_x[3] = {1, 0, 0}, ahead[3] = {0, 0, -1};
  const foredraw_wire_view view = view_of(clip);
  const float pixel_scale = 1.0f / (1.6f * height);
  const foredraw_wire_section at = foredraw_wire_section_at(&view, centre, along_x);
  const foredraw_wire_section end_on = foredraw_wire_section_at(&view, centre, ahead);
  CHECK(fabsf(foredraw_wire_half_pixel(&at) / (50.0f * pixel_scale) - 1.0f) < 1e-5f);
  CHECK(fabsf(foredraw_wire_half_pixel(&end_on) / (50.0f * pixel_scale) - 1.0f) < 1e-5f);
}

/* One segment from 3 m to 300 m: what its widened outline covers, times alpha, is what the wire covers. */
static void check_long_segment(void) {
  float clip[4][4] = {{1.2f, 0, 0, 0}, {0, 1.6f, 0, 0}, {0, 0, -1, -0.1f}, {0, 0, -1, 0}};
  const foredraw_wire_view view = view_of(clip);
  static const float near_end[3] = {1, -1, -3}, far_end[3] = {1, -1, -300}, axis[3] = {0, 0, 1};
  const float r = 0.0005f;
  foredraw_wire_section at[2];
  double drawn[2], ink = 0, wanted = 0;
  int i;
  at[0] = foredraw_wire_section_at(&view, near_end, axis);
  at[1] = foredraw_wire_section_at(&view, far_end, axis);
  for (i = 0; i < 2; ++i) drawn[i] = (double)foredraw_wire_drawn(r, foredraw_wire_half_pixel(&at[i]));
  CHECK(drawn[0] > (double)r && drawn[1] > 50 * drawn[0]);
  for (i = 0; i < 10000; ++i) { /* even steps on the screen: the share of the far end by perspective */
    const double t = (i + 0.5) / 10000, wa = 3, wb = 300, share = t / wb / ((1 - t) / wa + t / wb);
    const double between = drawn[0] + share * (drawn[1] - drawn[0]), w = wa + share * (wb - wa);
    ink += between / w * (double)foredraw_wire_fade(r, (float)between);
    wanted += (double)r / w;
  }
  CHECK(fabs(ink / wanted - 1) < 0.001);
}

static void check_coverage(void) {
  int i;
  for (i = 0; i < 2000; ++i) {
    const double angle = 0.0137 * i, half = 0.02 + 0.001 * i, distance = -1.6 + 0.0016 * i;
    foredraw_wire_section at = {{7.5f, 3.5f}, {0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 1.0f};
    double inside = 0;
    int row, column;
    const int cells = 100;
    at.across[0] = (float)cos(angle), at.across[1] = (float)sin(angle);
    for (row = 0; row < cells; ++row) {
      for (column = 0; column < cells; ++column) {
        const double x = (column + 0.5) / cells - 0.5, y = (row + 0.5) / cells - 0.5;
        if (fabs(distance + x * cos(angle) + y * sin(angle)) <= half) ++inside;
      }
    }
    CHECK(fabs((double)foredraw_wire_coverage(&at, (float)half, 7.5f + (float)(distance * cos(angle)),
                                              3.5f + (float)(distance * sin(angle))) -
               inside / cells / cells) < 0.012);
  }
}

/* Regular sections: the mean of their widths, measured. */
static void check_mean(void) {
  int sides, i, s;
  for (sides = 3; sides <= 16; ++sides) {
    const double pi = 3.14159265358979;
    const float corner[3] = {0, 0.6f, 0.8f};
    double sum = 0;
    for (i = 0; i < 1000; ++i) {
      double low = 2, high = -2;
      for (s = 0; s < sides; ++s) {
        const double at = cos(2 * pi * s / sides + 2 * pi * i / 1000);
        if (at < low) low = at;
        if (at > high) high = at;
      }
      sum += (high - low) / 2 / 1000;
    }
    CHECK(fabs((double)foredraw_wire_mean(corner, (float)cos(pi / sides)) / sum - 1) < 0.01);
  }
  {
    static const float nowhere[3] = {0, 0, 0}, ribbon[3] = {0.3f, 0, 0};
    CHECK(foredraw_wire_mean(nowhere, 0.5f) == 0.5f && foredraw_wire_mean(nowhere, -0.5f) == 0.5f);
    CHECK(foredraw_wire_mean(ribbon, 0.3f) == 0.3f);
  }
}

/* Beside each other the squares of a row leave nothing out: a wire has all its ink, in whatever direction it runs. */
static void check_ink(void) {
  int i, x, y;
  for (i = 0; i < 200; ++i) {
    const double angle = 0.0314 * i;
    foredraw_wire_section at = {{0.3f, -0.2f}, {0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 1.0f};
    double sum = 0;
    at.across[0] = (float)cos(angle), at.across[1] = (float)sin(angle);
    if (fabs(sin(angle)) < fabs(cos(angle))) { /* a row of a steep line, a column of a flat one */
      for (x = -20; x <= 20; ++x) sum += (double)foredraw_wire_coverage(&at, 0.05f, (float)x, 0.0f);
      CHECK(fabs(sum * fabs(cos(angle)) - 0.1) < 1e-4);
    } else {
      for (y = -20; y <= 20; ++y) sum += (double)foredraw_wire_coverage(&at, 0.05f, 0.0f, (float)y);
      CHECK(fabs(sum * fabs(sin(angle)) - 0.1) < 1e-4);
    }
  }
}

static void check_ends(void) {
  float clip[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, -0.1f}, {0, 0, -1, 0}};
  const foredraw_wire_view view = view_of(clip);
  static const float behind[3] = {0, 0, 5}, eye[3] = {0, 0, 0}, axis[3] = {1, 0, 0}, nowhere[3] = {0, 0, 0};
  static const float ahead[3] = {0, 0, -4};
  static const float position[3] = {0.1f, -0.3f, 1e-7f}, to_centre[3] = {0.3f, 1e20f, 7};
  float moved[3];
  foredraw_wire_section at = foredraw_wire_section_at(&view, behind, axis);
  CHECK(at.pixels == 0.0f && foredraw_wire_half_pixel(&at) == 0.0f);
  CHECK(foredraw_wire_drawn(0.2f, foredraw_wire_half_pixel(&at)) == 0.2f);
  CHECK(foredraw_wire_covering(0.2f, 0.3f, &at, 1) == 0.2f);
  at = foredraw_wire_section_at(&view, eye, axis);
  CHECK(at.pixels == 0.0f);
  at = foredraw_wire_section_at(&view, nowhere, nowhere);
  CHECK(at.pixels == 0.0f);
  at = foredraw_wire_section_at(&view, ahead, axis);
  foredraw_wire_moved(position, to_centre, 0.2f, 0.2f, &at, moved);
  CHECK(memcmp(moved, position, sizeof moved) == 0);
  foredraw_wire_moved(position, to_centre, -0.2f, foredraw_wire_drawn(-0.2f, 5.0f), &at, moved); /* a joint stays */
  CHECK(memcmp(moved, position, sizeof moved) == 0);
  foredraw_wire_moved(position, to_centre, 0.0f, foredraw_wire_drawn(0.0f, 5.0f), &at, moved);
  CHECK(memcmp(moved, position, sizeof moved) == 0);
  CHECK(foredraw_wire_fade(0.2f, 0.2f) == 1.0f && foredraw_wire_fade(0.0f, 0.0f) == 1.0f);
  CHECK(foredraw_wire_fade(0.1f, 0.4f) == 0.25f);
  CHECK(foredraw_wire_drawn(0.1f, 0.4f) == 0.4f && foredraw_wire_drawn(0.5f, 0.4f) == 0.5f);
  CHECK(foredraw_wire_lit(0.5f, 0.5f) == 1.0f && foredraw_wire_lit(0.25f, 0.5f) == 0.0f);
  CHECK(foredraw_wire_lit(0.375f, 0.5f) == 0.5f && foredraw_wire_lit(1.0f, 0.0f) == 1.0f);
  CHECK(foredraw_wire_drawn((float)NAN, 0.4f) != 0.4f);
}

int wire_radius_test(void) {
  check_widths();
  check_pixel_scale();
  check_long_segment();
  check_coverage();
  check_mean();
  check_ink();
  check_ends();
  return failures;
}
