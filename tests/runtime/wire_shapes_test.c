/* Wires that are flat, how they are widened and lit: wire_radius.h beside what is seen on the screen. */

#include "check.h"
#include "wire_view.h"

#include <string.h>

/* How far a point is from the line on the screen, in pixels. */
static double from_line(const foredraw_wire_view* view, const foredraw_wire_section* at, const float point[3]) {
  const double w = (double)foredraw_wire_row(view->row[2], point);
  const double x = (double)foredraw_wire_row(view->row[0], point) / w - (double)at->place[0];
  const double y = (double)foredraw_wire_row(view->row[1], point) / w - (double)at->place[1];
  return x * (double)at->across[0] + y * (double)at->across[1];
}

/* A ribbon, turned about its line: what is seen of it is what its borders are apart on the screen, and it is drawn a
 * pixel wide, or wide enough to compute its coverage, also from its edge. */
static void check_flat(void) {
  float clip[4][4] = {{1.2f, 0, 0.3f, 0}, {0, 1.6f, -0.2f, 0}, {0, 0, -1, -0.1f}, {0, 0, -1, 0}}; /* off-axis */
  const foredraw_wire_view view = view_of(clip);
  static const float centre[3] = {1.5f, -1, -8};
  const float half = 1e-3f, root = sqrtf(0.5f);
  const float axis[4] = {root, 0, root, 1}, side[3] = {root, 0, -root};
  const foredraw_wire_section at = foredraw_wire_section_at(&view, centre, axis);
  int i, border, covers, c;
  for (i = 0; i < 180; ++i) {
    const float angle = 0.0174532925f * (float)i;
    float border_at[2], pushed_at[2];
    for (covers = 0; covers < 5; covers += covers == 1 ? 3 : 1) {
      float drawn = 0, radius = 0;
      for (border = 0; border < 2; ++border) {
        float position[3], wire[4];
        foredraw_wire_vertex vertex;
        for (c = 0; c < 3; ++c) {
          wire[c] = half * (cosf(angle) * side[c] + (c == 1 ? sinf(angle) : 0.0f)) * (border == 0 ? 1.0f : -1.0f);
          position[c] = centre[c] - wire[c];
        }
        wire[3] = half;
        vertex = foredraw_wire_vertex_at(&view, position, wire, axis, covers);
        border_at[border] = (float)from_line(&view, &at, position);
        pushed_at[border] = (float)from_line(&view, &at, vertex.position);
        drawn = vertex.drawn, radius = vertex.radius;
        CHECK(drawn > radius && fabsf(vertex.half_pixel * at.pixels - 0.5f) < 1e-4f);
        CHECK(fabsf(drawn * at.pixels -
                    (covers ? radius * at.pixels +
                                  (covers > 1 ? 1.0f : 0.5f) * (fabsf(at.across[0]) + fabsf(at.across[1])) + 1.0f / 64
                            : 0.5f)) < 1e-4f);
        wire[3] = -half; /* a joint stays */
        vertex = foredraw_wire_vertex_at(&view, position, wire, axis, covers);
        CHECK(memcmp(vertex.position, position, sizeof position) == 0 && vertex.radius == radius);
      }
      CHECK(fabsf(border_at[0] + border_at[1]) < 1e-4f);
      CHECK(fabsf(fabsf(border_at[0]) - radius * at.pixels) < 1e-4f);
      CHECK(fabsf(fabsf(pushed_at[0]) - drawn * at.pixels) < 2e-3f && fabsf(pushed_at[0] + pushed_at[1]) < 2e-3f);
    }
  }
  { /* in its middle it moves as little as it is long; without a direction, it is as broad as it is */
    static const float middle[4] = {0, 1e-6f, 0, 1e-3f}, nowhere[4] = {0, 0, 0, 1e-3f};
    foredraw_wire_vertex vertex = foredraw_wire_vertex_at(&view, centre, middle, axis, 0);
    CHECK(fabs(from_line(&view, &at, vertex.position)) < 1e-3);
    vertex = foredraw_wire_vertex_at(&view, centre, nowhere, axis, 0);
    CHECK(memcmp(vertex.position, centre, sizeof centre) == 0 && vertex.radius == 1e-3f);
  }
  { /* from two pixels on it stays where it is, to the bit */
    static const float position[3] = {1.5f, -1.1f, -8}, wide[4] = {0, 0.1f, 0, 0.1f};
    const foredraw_wire_vertex vertex = foredraw_wire_vertex_at(&view, position, wide, axis, 0);
    CHECK(memcmp(vertex.position, position, sizeof position) == 0 && vertex.drawn == vertex.radius);
  }
}

/* A tube is widened across its line on the screen, and comes no nearer to the eye. */
static void check_depth(void) {
  float clip[4][4] = {{1.2f, 0, 0.3f, 0}, {0, 1.6f, -0.2f, 0}, {0, 0, -1, -0.1f}, {0, 0, -1, 0}};
  const foredraw_wire_view view = view_of(clip);
  static const float centre[3] = {1.5f, -1, -8}, side[3] = {0.8f, 0, 0.6f};
  const float axis[4] = {0.6f, 0, -0.8f, 0}, half = 1e-3f;
  const foredraw_wire_section at = foredraw_wire_section_at(&view, centre, axis);
  float widest = 0;
  int i, c;
  for (i = 0; i < 360; ++i) {
    const float angle = 0.0174532925f * (float)i;
    float position[3], wire[4], toward = 0, way = 0;
    foredraw_wire_vertex vertex;
    for (c = 0; c < 3; ++c) {
      wire[c] = -half * (cosf(angle) * side[c] + (c == 1 ? sinf(angle) : 0.0f));
      position[c] = centre[c] - wire[c];
    }
    wire[3] = half;
    vertex = foredraw_wire_vertex_at(&view, position, wire, axis, 0);
    for (c = 0; c < 3; ++c) {
      toward += (vertex.position[c] - position[c]) * centre[c]; /* the eye is at the origin */
      way += (vertex.position[c] - position[c]) * axis[c];
    }
    CHECK(fabsf(toward) < 1e-5f && fabsf(way) < 1e-6f);
    if (fabs(from_line(&view, &at, vertex.position)) > (double)widest)
      widest = (float)fabs(from_line(&view, &at, vertex.position));
  }
  CHECK(fabsf(widest - 0.5f) < 2e-3f);
}

/* Three normals make the mean light over a round wire's width. */
static void check_light(void) {
  static const float axis[3] = {0.6f, 0, 1.7f}, to_eye[3] = {-2, 3, 5}, along[3] = {1.2f, 0, 3.4f};
  static const float suns[3][3] = {{0, 1, 0}, {-0.48f, 0.6f, 0.64f}, {0.36f, 0.48f, 0.8f}};
  float normal[3];
  int sun, i;
  for (sun = 0; sun < 3; ++sun) {
    static const float parts[3] = {-0.7746f, 0, 0.7746f}, weights[3] = {5, 8, 5};
    double mean = 0, three = 0;
    for (i = 0; i < 2000; ++i) {
      foredraw_wire_normal(axis, to_eye, ((float)i + 0.5f) / 1000 - 1, normal);
      CHECK(fabsf(foredraw_wire_dot(normal, normal) - 1) < 1e-4f && fabsf(foredraw_wire_dot(normal, axis)) < 1e-4f);
      mean += 0.0005 * fmax(0, (double)foredraw_wire_dot(normal, suns[sun]));
    }
    for (i = 0; i < 3; ++i) {
      foredraw_wire_normal(axis, to_eye, parts[i], normal);
      three += (double)weights[i] / 18 * fmax(0, (double)foredraw_wire_dot(normal, suns[sun]));
    }
    CHECK(fabs(three - mean) < 0.04);
  }
  foredraw_wire_normal(axis, along, 0.3f, normal); /* end on */
  CHECK(foredraw_wire_dot(normal, normal) > 0.9f && foredraw_wire_dot(normal, along) > 0);
  foredraw_wire_normal(suns[0], normal, 2, normal);
  CHECK(foredraw_wire_dot(normal, normal) < 4.1f);
}

int wire_shapes_test(void) {
  check_flat();
  check_depth();
  check_light();
  return failures;
}
