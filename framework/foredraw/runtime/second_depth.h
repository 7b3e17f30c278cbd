/* Second-depth anti-aliasing: where the edges of the geometry lie between pixels, from the depth of what is seen and
 * the depth of the nearest back face. C99, no allocation, no state.
 *
 * Persson: Second-Depth Anti-Aliasing, in Graphics Gems for Games, SIGGRAPH 2012. Depth as rasterisers store it (z / w)
 * is linear on the screen within a triangle. Two faces that meet in a crease are two lines that cross there. At a
 * silhouette the thickness of a body, from its front to its nearest back face, comes to zero.
 *
 * A frame draws what FOREDRAW_second_depth names with front faces culled, copies that depth, goes on with the scene,
 * and in the end resolves each pixel. Samples are those of a row or a column, the pixel's own in the middle:
 *
 *   rule = foredraw_second_depth_unorm(24, 0);                                                  once
 *   row = foredraw_second_depth_edge(&rule, depths, seconds, before, behind);                   pixels x - 3 to x + 3
 *   column = foredraw_second_depth_edge(&rule, depths, seconds, before, behind);                pixels y - 3 to y + 3
 *   foredraw_second_depth_offset(row, column, offset);
 *   colour = bilinear(x + offset[0], y + offset[1])          of the frame as it was drawn, linear, before tone mapping
 *
 * Three things beyond the paper. The pixel's own depth decides which face a crease leaves it on. Two samples are of one
 * body only if their depths overlap, from the front to the back face, or their fronts are on a line with a third. And
 * at a round rim, where the thickness goes as a root, its square is the line. Each axis decides by itself, and where
 * the sky or the frame's border leaves nothing to go by, there is no edge. */
#ifndef FOREDRAW_RUNTIME_SECOND_DEPTH_H
#define FOREDRAW_RUNTIME_SECOND_DEPTH_H

#include <math.h>

/* Samples on each side of the pixel's own. */
#define FOREDRAW_SECOND_DEPTH_REACH 3

/* Stands for the place of an edge: there is none. */
#define FOREDRAW_SECOND_DEPTH_NONE 2.0f

/* Three samples are on a line if the bend, |a - 2 b + c|, is at most this part of the line's slope. */
#define FOREDRAW_SECOND_DEPTH_STRAIGHT 0.25f

typedef struct foredraw_second_depth_rule {
  float towards_far;        /* 1: what is farther away has a larger depth; -1: a smaller one */
  float absolute, relative; /* slopes, per pixel, below absolute + relative * depth are noise */
  float round_rims;         /* 1: the square of the thickness may be the line; 0: never */
} foredraw_second_depth_rule;

/* Depth in so many bits, 16 or 24. Reversed (not 0): 1 is near. */
static inline foredraw_second_depth_rule foredraw_second_depth_unorm(unsigned bits, int reversed) {
  foredraw_second_depth_rule rule;
  rule.towards_far = reversed ? -1.0f : 1.0f;
  rule.absolute = 8.0f / (float)((1ul << bits) - 1ul);
  rule.relative = 0.0f;
  rule.round_rims = 1.0f;
  return rule;
}

/* Depth in floats of 32 bits. */
static inline foredraw_second_depth_rule foredraw_second_depth_float(int reversed) {
  foredraw_second_depth_rule rule;
  rule.towards_far = reversed ? -1.0f : 1.0f;
  rule.absolute = 0.0f;
  rule.relative = 8.0f / 16777216.0f;
  rule.round_rims = 1.0f;
  return rule;
}

/* How far from the line through two samples the third is. */
static inline float foredraw_second_depth_bend(float a, float b, float c) { return fabsf(a - 2.0f * b + c); }

/* Where the faces left and right of the pixel meet, from the pixel's middle, in pixels; NONE where that is more than
 * half a pixel away, or the pixel itself is on neither of them. */
static inline float foredraw_second_depth_crease(const float depth[7], float least) {
  const float slope_before = depth[2] - depth[1], slope_behind = depth[5] - depth[4];
  const float turn = slope_before - slope_behind;
  const float crease = (depth[4] - slope_behind - (depth[2] + slope_before)) / (fabsf(turn) > least ? turn : 1.0f);
  const float bend = crease > 0.0f ? foredraw_second_depth_bend(depth[1], depth[2], depth[3])
                                   : foredraw_second_depth_bend(depth[3], depth[4], depth[5]);
  if (fabsf(turn) > least && fabsf(crease) <= 0.5f && bend <= FOREDRAW_SECOND_DEPTH_STRAIGHT * fabsf(turn))
    return crease;
  return FOREDRAW_SECOND_DEPTH_NONE;
}

/* Whether the first two samples are of one body: their depths overlap, or the third front is on the line of theirs. Of
 * a thin thing and what lies behind it neither is so. */
static inline int foredraw_second_depth_is_one_body(const float front[3], const float back[3], int has_third) {
  if (front[0] <= back[1] && front[1] <= back[0]) return 1;
  return has_third && foredraw_second_depth_bend(front[0], front[1], front[2]) <=
                          FOREDRAW_SECOND_DEPTH_STRAIGHT * fabsf(front[1] - front[0]);
}

/* How far a body goes on beyond the first of three samples, in pixels, until its thickness is zero; NONE where it does
 * not come to zero there, or the first two are not of one body. The third, if it is there, tells whether the rim is
 * round. `front` and `back` rise with the distance. */
static inline float foredraw_second_depth_rim(const float front[3], const float back[3], int has_third, float least,
                                              float round_rims) {
  const float t0 = back[0] - front[0], t1 = back[1] - front[1], t2 = back[2] - front[2], slope = t1 - t0;
  const float bend = foredraw_second_depth_bend(t0, t1, t2);
  const float q0 = t0 * t0, q1 = t1 * t1, q_slope = q1 - q0, q_bend = foredraw_second_depth_bend(q0, q1, t2 * t2);
  if (!(t0 > 0.0f) || !(slope > least) || !foredraw_second_depth_is_one_body(front, back, has_third))
    return FOREDRAW_SECOND_DEPTH_NONE;
  if (has_third && round_rims > 0.0f && q_bend <= FOREDRAW_SECOND_DEPTH_STRAIGHT * q_slope &&
      q_bend * slope < bend * q_slope)
    return q0 / q_slope;
  return t0 / slope;
}

/* Where the body that lies towards the samples behind the pixel begins, from the pixel's middle: at most 0 if the pixel
 * is on it. front[0] and back[0] are the pixel's own; so many samples are `there` behind it, and `opposite` before it.
 */
static inline float foredraw_second_depth_silhouette(const float front[4], const float back[4], int there, int opposite,
                                                     float least, float round_rims) {
  float rim;
  if (there < 2) return FOREDRAW_SECOND_DEPTH_NONE;
  rim = foredraw_second_depth_rim(front, back, 1, least, round_rims);
  if (rim <= 0.5f) return opposite > 0 ? -rim : FOREDRAW_SECOND_DEPTH_NONE;
  rim = foredraw_second_depth_rim(front + 1, back + 1, there > 2, least, round_rims);
  return rim >= 0.5f && rim <= 1.0f ? 1.0f - rim : FOREDRAW_SECOND_DEPTH_NONE;
}

/* Where the nearest edge crosses the row or column, from the pixel's middle: -1/2 to 1/2, or NONE. Of the seven samples
 * `before` are in the frame ahead of the pixel's own, and `behind` behind it, 0 to 3 each; the others are not used, but
 * must be finite. What lies on the edge's other side is in the frame. */
static inline float foredraw_second_depth_edge(const foredraw_second_depth_rule* rule, const float depth[7],
                                               const float second[7], int before, int behind) {
  const float least = rule->absolute + rule->relative * fmaxf(fabsf(depth[3]), fmaxf(fabsf(depth[2]), fabsf(depth[4])));
  float edge = FOREDRAW_SECOND_DEPTH_NONE, left, right, front[4], back[4];
  int i;
  if (before > 0 && behind > 0 && !(foredraw_second_depth_bend(depth[2], depth[3], depth[4]) > 0.5f * least))
    return edge;
  if (before > 1 && behind > 1) edge = foredraw_second_depth_crease(depth, least);
  if (edge < FOREDRAW_SECOND_DEPTH_NONE) return edge;
  for (i = 0; i < 4; ++i) {
    front[i] = depth[3 + i] * rule->towards_far;
    back[i] = second[3 + i] * rule->towards_far;
  }
  right = foredraw_second_depth_silhouette(front, back, behind, before, least, rule->round_rims);
  for (i = 0; i < 4; ++i) {
    front[i] = depth[3 - i] * rule->towards_far;
    back[i] = second[3 - i] * rule->towards_far;
  }
  left = foredraw_second_depth_silhouette(front, back, before, behind, least, rule->round_rims);
  return fabsf(left) < fabsf(right) ? -left : right;
}

/* What to add to the pixel's middle before a bilinear fetch: along the axis of the nearer edge towards its other side,
 * by the part of the pixel that lies there. 0 and 0 where there is no edge. */
static inline void foredraw_second_depth_offset(float row, float column, float offset[2]) {
  const int is_row = fabsf(row) <= fabsf(column);
  const float edge = is_row ? row : column, part = fmaxf(0.5f - fabsf(edge), 0.0f);
  offset[0] = offset[1] = 0.0f;
  offset[is_row ? 0 : 1] = edge < 0.0f ? -part : part;
}

#endif
