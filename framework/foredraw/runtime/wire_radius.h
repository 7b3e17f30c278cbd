/* Wires, ropes, rails: what is long and thin, drawn without gaps however far away it is. C99, no allocation, no state.
 *
 * E. Persson: Graphics Gems for Games, SIGGRAPH 2012, "Phone-wire anti-aliasing": a wire is never drawn thinner than a
 * pixel; where it is thinner, it fades by as much as it was widened. Beyond the paper, a fragment can find by itself
 * which part of its pixel the wire covers: then one sample is enough.
 *
 * A vertex of a wire knows the vector to its centre line, the half width of the section at its least, the line's
 * direction, and whether the section is flat, all in the mesh's space (`_FOREDRAW_WIRE`, `_FOREDRAW_WIRE_AXIS`):
 *
 *   half width > 0   it may be widened
 *   half width < 0   a joint with something else: it stays where it is, and the half width is that without its sign
 *   half width = 0   no wire
 *   flat = 1         a ribbon: the half width is half its breadth, in which the vector to the centre line lies
 *   flat = 0         as wide from every side
 *
 * How wide a wire is on the screen comes from the projection's Jacobian at the centre line, J (2 x 3, pixels for each
 * unit of the mesh). The line runs along J axis; with n the unit normal of that on the screen, a round section of half
 * width r is r |J^T n| wide to either side. In the middle of an upright picture that is the paper's
 * r / (w * pixel scale) in half pixels, with pixel scale = 1 / (P[1][1] * height). It holds as well for orthographic,
 * jittered, rolled and off-axis cameras, and for nodes that scale unevenly or mirror, as nothing is asked but the
 * matrix from the mesh to clip space and the size of the picture.
 *
 * J^T n, at right angles to the line and to the view, is also the direction in which wires are widened. A flat section
 * of half breadth b in the direction d shows b |n J d|, which is b |J^T n| times the cosine of the angle between d and
 * J^T n. Its borders are pushed apart on the screen.
 *
 *   vertex = foredraw_wire_vertex_at(&view, position, wire, axis, 0);       draw it at vertex.position
 *   alpha = foredraw_wire_fade(radius, drawn);                              fragment: both interpolated
 *
 * Interpolate both radii and divide in the fragment: on a long segment the quotient is no straight line. Draw a wire's
 * fragments of alpha 1 like everything else, and the others after everything opaque: blended, without writing depth. */
#ifndef FOREDRAW_RUNTIME_WIRE_RADIUS_H
#define FOREDRAW_RUNTIME_WIRE_RADIUS_H

#include <math.h>

/* From the mesh's space to the screen: row[0] and row[1] give a point's pixels times w, row[2] gives w. */
typedef struct foredraw_wire_view {
  float row[3][4];
} foredraw_wire_view;

/* A wire where its centre line passes a point. */
typedef struct foredraw_wire_section {
  float place[2];  /* of the point on the screen, in pixels */
  float across[2]; /* on the screen, of length 1, at right angles to the line */
  float aside[3];  /* in the mesh's space, of length 1: across the line and the view; 0 where there is no such thing */
  float pixels;    /* to either side, for each unit of half width; 0: the point is not ahead of the eye */
} foredraw_wire_section;

/* Where a vertex is drawn, and what its triangles interpolate. */
typedef struct foredraw_wire_vertex {
  float position[3];
  float radius;     /* half of what is seen of the wire across its line */
  float drawn;      /* half of what is drawn */
  float half_pixel; /* half of what is a pixel wide there */
} foredraw_wire_vertex;

/* `clip_from_mesh`: column by column. Pixels are counted along clip space's axes from its lower corner, whichever way
 * its y runs. `width`, `height`: of the picture, in pixels. */
static inline foredraw_wire_view foredraw_wire_view_of(const float clip_from_mesh[16], float width, float height) {
  foredraw_wire_view view;
  int c;
  for (c = 0; c < 4; ++c) {
    const float x = clip_from_mesh[4 * c], y = clip_from_mesh[4 * c + 1], w = clip_from_mesh[4 * c + 3];
    view.row[0][c] = 0.5f * width * (x + w);
    view.row[1][c] = 0.5f * height * (y + w);
    view.row[2][c] = w;
  }
  return view;
}

static inline float foredraw_wire_row(const float row[4], const float point[3]) {
  return row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
}

/* `axis`: along the line, of any length above 0. Where it points at the eye, the line is a point on the screen, and any
 * direction is across it. Nothing is divided by 0, whatever is put in. */
static inline foredraw_wire_section foredraw_wire_section_at(const foredraw_wire_view* view, const float centre[3],
                                                             const float axis[3]) {
  foredraw_wire_section at = {{0.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, 0.0f};
  const float w = foredraw_wire_row(view->row[2], centre);
  float x[3], y[3]; /* the Jacobian's rows, times w */
  float along_x = 0.0f, along_y = 0.0f, squares = 0.0f, length;
  int c;
  if (!(w > 0.0f)) return at;
  at.place[0] = foredraw_wire_row(view->row[0], centre) / w;
  at.place[1] = foredraw_wire_row(view->row[1], centre) / w;
  for (c = 0; c < 3; ++c) {
    x[c] = view->row[0][c] - at.place[0] * view->row[2][c];
    y[c] = view->row[1][c] - at.place[1] * view->row[2][c];
    along_x += x[c] * axis[c];
    along_y += y[c] * axis[c];
  }
  length = sqrtf(along_x * along_x + along_y * along_y);
  if (length > 0.0f) {
    at.across[0] = -along_y / length;
    at.across[1] = along_x / length;
  }
  for (c = 0; c < 3; ++c) {
    at.aside[c] = at.across[0] * x[c] + at.across[1] * y[c];
    squares += at.aside[c] * at.aside[c];
  }
  length = sqrtf(squares);
  for (c = 0; c < 3; ++c) at.aside[c] = length > 0.0f ? at.aside[c] / length : 0.0f;
  at.pixels = length / w;
  return at;
}

/* The half width that is half a pixel there: a wire of it is a pixel wide. 0 where the point is not ahead of the eye.
 */
static inline float foredraw_wire_half_pixel(const foredraw_wire_section* at) {
  return at->pixels > 0.0f ? 0.5f / at->pixels : 0.0f;
}

/* To be drawn for `half_width`: at least half a pixel, where it may be widened. */
static inline float foredraw_wire_drawn(float half_width, float half_pixel) {
  return half_width > 0.0f && half_pixel > half_width ? half_pixel : fabsf(half_width);
}

/* Half of what a section is wide from all sides in the mean, which is what coverage needs; `half_width` is its least.
 * The mean width of a convex outline is its perimeter / pi (Cauchy). Of a regular polygon with corners R from the
 * centre and sides r that is half of it: R sin(p) / p with cos(p) = r / R, and (2 R + r) / 3 is within a hundredth of
 * it from three corners on (Cusanus). Of what is flat, or round, R = r. */
static inline float foredraw_wire_mean(const float to_centre[3], float half_width) {
  const float r = fabsf(half_width);
  const float corner = sqrtf(to_centre[0] * to_centre[0] + to_centre[1] * to_centre[1] + to_centre[2] * to_centre[2]);
  return corner > r ? (2.0f * corner + r) / 3.0f : r;
}

static inline float foredraw_wire_dot(const float a[3], const float b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* How far a vertex of a flat section is from the centre line, at right angles to it. `axis`: of length 1. */
static inline float foredraw_wire_breadth(const float to_centre[3], const float axis[3]) {
  const float along = foredraw_wire_dot(to_centre, axis);
  float squares = 0.0f;
  int c;
  for (c = 0; c < 3; ++c) {
    const float part = to_centre[c] - along * axis[c];
    squares += part * part;
  }
  return sqrtf(squares);
}

/* Half of what is seen of a flat section: `half_width`, with its sign, from the front, and 0 from its edge. */
static inline float foredraw_wire_seen(const foredraw_wire_section* at, const float to_centre[3], const float axis[3],
                                       float half_width) {
  const float breadth = foredraw_wire_breadth(to_centre, axis);
  const float shown = fabsf(foredraw_wire_dot(to_centre, at->aside));
  return breadth > shown ? half_width * (shown / breadth) : half_width;
}

/* To be drawn where fragments compute the coverage of a wire of that mean radius: so much that the middle of every
 * pixel that it touches is inside, or, with several samples, all samples of that pixel. */
static inline float foredraw_wire_covering(float half_width, float mean, const foredraw_wire_section* at, int samples) {
  const float to_corner = 0.5f * (fabsf(at->across[0]) + fabsf(at->across[1])), room = 1.0f / 64.0f;
  if (!(half_width > 0.0f) || !(at->pixels > 0.0f)) return fabsf(half_width);
  return mean + ((samples > 1 ? 2.0f : 1.0f) * to_corner + room) / at->pixels;
}

/* The vertex, where its round wire is drawn so wide: widened across the line on the screen alone. Its depth stays, or a
 * wire along a surface would come through to the other side. What is not widened stays where it is, to the bit. */
static inline void foredraw_wire_moved(const float position[3], const float to_centre[3], float half_width, float drawn,
                                       const foredraw_wire_section* at, float moved[3]) {
  const float wider = half_width > 0.0f ? drawn / half_width - 1.0f : 0.0f;
  const float outwards = -wider * foredraw_wire_dot(to_centre, at->aside);
  int c;
  for (c = 0; c < 3; ++c) moved[c] = wider > 0.0f ? position[c] + outwards * at->aside[c] : position[c];
}

/* The same of a flat one: by as much farther from the centre line on the screen as it is drawn wider. Vertices between
 * its borders move by their part. */
static inline void foredraw_wire_pushed(const float position[3], const float to_centre[3], const float axis[3],
                                        float half_width, float by, const foredraw_wire_section* at, float moved[3]) {
  const float part = half_width > 0.0f ? foredraw_wire_breadth(to_centre, axis) / half_width : 0.0f;
  const float outwards = foredraw_wire_dot(to_centre, at->aside) > 0.0f ? -part * by : part * by;
  int c;
  for (c = 0; c < 3; ++c) moved[c] = by > 0.0f && part > 0.0f ? position[c] + outwards * at->aside[c] : position[c];
}

/* `wire`: the vector to the centre line and the half width; `axis`: the direction, of length 1, and whether it is flat.
 * `covers`: how many samples a pixel has, where fragments compute their coverage; 0 where they fade. */
static inline foredraw_wire_vertex foredraw_wire_vertex_at(const foredraw_wire_view* view, const float position[3],
                                                           const float wire[4], const float axis[4], int covers) {
  const float centre[3] = {position[0] + wire[0], position[1] + wire[1], position[2] + wire[2]};
  const foredraw_wire_section at = foredraw_wire_section_at(view, centre, axis);
  const int is_flat = axis[3] > 0.5f;
  foredraw_wire_vertex vertex;
  vertex.half_pixel = foredraw_wire_half_pixel(&at);
  if (is_flat) {
    vertex.radius = fabsf(foredraw_wire_seen(&at, wire, axis, wire[3]));
  } else {
    vertex.radius = covers ? foredraw_wire_mean(wire, wire[3]) : fabsf(wire[3]);
  }
  if (covers) {
    vertex.drawn = foredraw_wire_covering(wire[3], vertex.radius, &at, covers);
  } else {
    vertex.drawn = foredraw_wire_drawn(wire[3] > 0.0f ? vertex.radius : -vertex.radius, vertex.half_pixel);
  }
  if (is_flat) {
    foredraw_wire_pushed(position, wire, axis, wire[3], vertex.drawn - vertex.radius, &at, vertex.position);
  } else {
    foredraw_wire_moved(position, wire, wire[3], vertex.drawn, &at, vertex.position);
  }
  return vertex;
}

/* Alpha: what part of a widened wire is there. */
static inline float foredraw_wire_fade(float radius, float drawn) {
  return drawn > radius && drawn > 0.0f ? radius / drawn : 1.0f;
}

/* How much is shown of the light in the one place that a fragment knows; the rest is the mean over the wire's width.
 * All of it from a pixel on, as nothing is changed there; nothing of it up to half a pixel: every fragment shows the
 * whole width then, and one place for all of it would flicker, though the outline does not. */
static inline float foredraw_wire_lit(float radius, float half_pixel) {
  const float lit = half_pixel > 0.0f ? 2.0f * radius / half_pixel - 1.0f : 1.0f;
  return lit > 0.0f ? lit < 1.0f ? lit : 1.0f : 0.0f;
}

/* The normal of a round wire at a part of its half width, -1 to 1, as it is seen: at right angles to the line, and in
 * the middle towards the eye. The mean light over the width is that of three normals, at 0 and at -/+ 0.7746, of which
 * the middle one counts 8 / 18 and the others 5 / 18 each (Gauss). `axis`, `to_eye`: in the space of the light, of any
 * length; where one points along the other, the middle is towards the eye all the same. */
static inline void foredraw_wire_normal(const float axis[3], const float to_eye[3], float part, float normal[3]) {
  const float squares = foredraw_wire_dot(axis, axis);
  const float along = squares > 0.0f ? foredraw_wire_dot(to_eye, axis) / squares : 0.0f;
  const float rest = part * part < 1.0f ? sqrtf(1.0f - part * part) : 0.0f;
  float middle[3], side[3], length, across;
  int c;
  for (c = 0; c < 3; ++c) middle[c] = to_eye[c] - along * axis[c];
  length = sqrtf(foredraw_wire_dot(middle, middle));
  if (!(length > 0.0f)) {
    for (c = 0; c < 3; ++c) middle[c] = to_eye[c];
    length = sqrtf(foredraw_wire_dot(middle, middle));
  }
  for (c = 0; c < 3; ++c) side[c] = axis[(c + 1) % 3] * middle[(c + 2) % 3] - axis[(c + 2) % 3] * middle[(c + 1) % 3];
  across = sqrtf(foredraw_wire_dot(side, side));
  for (c = 0; c < 3; ++c) {
    normal[c] = (length > 0.0f ? rest * middle[c] / length : 0.0f) + (across > 0.0f ? part * side[c] / across : 0.0f);
  }
}

/* What part of a pixel's square lies on one side of a line: `distance` pixels from the square's middle, positive on
 * that side. The square's width along the line's normal is a trapezoid. */
static inline float foredraw_wire_side(float distance, const float across[2]) {
  const float a = fabsf(across[0]), b = fabsf(across[1]), most = a > b ? a : b, least = a > b ? b : a;
  const float to_corner = 0.5f * (a + b), to_flat = 0.5f * (most - least), size = fabsf(distance);
  float outside; /* of the half that lies farther on */
  if (size >= to_corner) {
    outside = 0.0f;
  } else if (size <= to_flat) {
    outside = 0.5f - size / most;
  } else {
    outside = (to_corner - size) * (to_corner - size) / (2.0f * most * least);
  }
  return distance > 0.0f ? 1.0f - outside : outside;
}

/* Alpha of a fragment: what part of its pixel's square a straight wire of that radius covers, exactly but for the
 * rounding of floats; 1 where there is no wire. `at`: of the centre line that the fragment's triangle interpolates, and
 * so is `radius`, the vertices' mean. `x`, `y`: of the pixel's middle, as the view counts them. */
static inline float foredraw_wire_coverage(const foredraw_wire_section* at, float radius, float x, float y) {
  const float distance = (x - at->place[0]) * at->across[0] + (y - at->place[1]) * at->across[1];
  const float half = radius * at->pixels;
  if (!(half > 0.0f)) return 1.0f;
  return foredraw_wire_side(half + distance, at->across) + foredraw_wire_side(half - distance, at->across) - 1.0f;
}

#endif
