/* Which of its index buffers a frame loop draws: the table that Foredraw writes, looked up by clip, time and where the
 * camera is. C99, no allocation, no state but the caller's; docs/reference/draw-orders.md tells where the
 * numbers come from.
 *
 *   foredraw_order_state state = {0};                                  once for each character that is on the screen
 *   ...
 *   uint32_t order = foredraw_order_at(&table, clip, time, towards_camera, &state);             for every frame
 *   const uint16_t* sequence = foredraw_draw_sequence(&table, order);      parts are drawn as it says; NULL: as ever
 *
 * Only + - * / and square roots touch the direction, so that every machine finds the same cells. */
#ifndef FOREDRAW_RUNTIME_ORDER_TABLE_H
#define FOREDRAW_RUNTIME_ORDER_TABLE_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* No clip of the table is playing. */
#define FOREDRAW_NO_CLIP UINT32_MAX
/* What foredraw_keyframe_at() answers where the table says nothing. */
#define FOREDRAW_NO_KEYFRAME UINT32_MAX
/* How far beyond the border of its cell a direction must be before the cell is left, in parts of a cell. */
#define FOREDRAW_ORDER_MARGIN 0.125f

/* The bytes as they are stored, and what they are of. Nothing is copied: the pointers must stay good. */
typedef struct foredraw_order_table {
  uint32_t clips;            /* 0: the pose does not matter */
  const uint32_t* keyframes; /* [clip] how many it has */
  const float* times;        /* seconds, of all clips in turn; rising in each clip */
  uint32_t theta_steps;      /* at least 1, below 2^24 */
  uint32_t phi_steps;        /* at least 1, below 2^24 */
  const uint8_t* order;      /* [keyframe of all clips in turn][theta][phi] */
  uint32_t parts;            /* that are drawn in a sequence; 0: in that of the file */
  const uint16_t* sequences; /* [order][place] number of a part, below `parts` */
} foredraw_order_table;

/* The cell that a subject was last looked at from. All zero: from none yet. */
typedef struct foredraw_order_state {
  uint32_t is_set;
  uint32_t theta;
  uint32_t phi;
} foredraw_order_state;

/* A direction among the cells: cell 3 is from 3 to 4. */
typedef struct foredraw_cell_place {
  float theta; /* steps from +Y */
  float phi;   /* steps from -X, by way of -Z */
  float ring;  /* sine of theta: how much shorter the circle of this theta is than the equator */
} foredraw_cell_place;

/* The angle of (x, y) from +x towards +y, in radians from -pi to pi, within 1e-6 of the exact one; 0 where there is
 * none. The tangent of a quarter of the angle is small enough for a short series. */
static inline float foredraw_angle(float x, float y) {
  const float pi = 3.14159265f;
  const float across = fabsf(x);
  const float up = fabsf(y);
  const float most = across < up ? up : across;
  float t, square, angle;
  if (!(most > 0)) return 0;
  t = (across < up ? across : up) / most;
  t = t / (1 + sqrtf(1 + t * t));
  t = t / (1 + sqrtf(1 + t * t));
  square = t * t;
  angle = 4 * t * (1 - square * (1.0f / 3 - square * (1.0f / 5 - square / 7)));
  if (across < up) angle = pi / 2 - angle;
  if (x < 0) angle = pi - angle;
  return y < 0 ? -angle : angle;
}

/* Where among the cells a direction of any length points. */
static inline foredraw_cell_place foredraw_place_of(const foredraw_order_table* table, const float towards_camera[3]) {
  const float pi = 3.14159265f;
  foredraw_cell_place place;
  float x = towards_camera[0], y = towards_camera[1], z = towards_camera[2];
  float most = fabsf(x) > fabsf(y) ? fabsf(x) : fabsf(y);
  float level, length;
  if (fabsf(z) > most) most = fabsf(z);
  if (most > 0) { /* squares of very long or short ones would not be floats */
    x /= most;
    y /= most;
    z /= most;
  }
  level = sqrtf(x * x + z * z);
  length = sqrtf(x * x + y * y + z * z);
  place.theta = foredraw_angle(y, level) / pi * (float)table->theta_steps;
  place.phi = (foredraw_angle(x, z) + pi) / (2 * pi) * (float)table->phi_steps;
  place.ring = length > 0 ? level / length : 0;
  return place;
}

/* The cell of a place, and of what is no number the first one. The last theta has an end, phi goes round. */
static inline uint32_t foredraw_cell_of(float at, uint32_t steps, int goes_round) {
  if (!(at > 0)) return 0;
  if (at < (float)steps) return (uint32_t)at;
  return goes_round ? 0 : steps - 1;
}

/* Whether a place is in the cell, or so little beside it that it stays. */
static inline int foredraw_stays(const foredraw_order_table* table, const foredraw_cell_place* place,
                                 const foredraw_order_state* state) {
  const float phi_steps = (float)table->phi_steps;
  float theta, phi;
  if (!state->is_set || state->theta >= table->theta_steps || state->phi >= table->phi_steps) return 0;
  theta = fabsf(place->theta - ((float)state->theta + 0.5f)) - 0.5f;
  phi = fabsf(place->phi - ((float)state->phi + 0.5f));
  if (phi > phi_steps / 2) phi = phi_steps - phi;
  phi = (phi - 0.5f) * place->ring; /* near a pole it takes next to nothing to be at any phi */
  return theta <= FOREDRAW_ORDER_MARGIN && phi <= FOREDRAW_ORDER_MARGIN;
}

/* The number among the keyframes of all clips of the one nearest in time, of two equally near the earlier one; 0 where
 * the table has no clips, and FOREDRAW_NO_KEYFRAME where it has, but not this one. Times before the first keyframe and
 * behind the last one are at these: whoever loops a clip wraps its time. O(clips + log keyframes). */
static inline uint32_t foredraw_keyframe_at(const foredraw_order_table* table, uint32_t clip, float time) {
  const float* times;
  uint32_t first = 0, low = 0, high, i;
  if (table->clips == 0) return 0;
  if (clip >= table->clips || table->keyframes[clip] == 0) return FOREDRAW_NO_KEYFRAME;
  for (i = 0; i < clip; ++i) first += table->keyframes[i];
  times = table->times + first;
  high = table->keyframes[clip] - 1;
  while (low < high) { /* the first that is not before `time`, or the last one */
    const uint32_t middle = low + (high - low) / 2;
    if (times[middle] < time) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low > 0 && time - times[low - 1] <= times[low] - time) --low;
  return first + low;
}

/* The number of the index buffer to draw: 0 is primitive.indices itself, which is also the answer while a clip plays
 * that the table does not have.
 *   clip            its number in the table; of several that are blended the one that weighs most
 *   time            in the clip, seconds
 *   towards_camera  from the middle of the subject (the centre of its bounding sphere) to the camera, in the subject's
 *                   own space, of any length: for a character the space of the glTF scene that it came in
 *   state           where not null: the last cell is left only when the direction is clearly outside of it, so that a
 *                   camera on a border does not flicker; one for each instance of the subject */
static inline uint32_t foredraw_order_at(const foredraw_order_table* table, uint32_t clip, float time,
                                         const float towards_camera[3], foredraw_order_state* state) {
  const uint32_t keyframe = foredraw_keyframe_at(table, clip, time);
  const foredraw_cell_place place = foredraw_place_of(table, towards_camera);
  foredraw_order_state cell;
  cell.is_set = 1;
  cell.theta = foredraw_cell_of(place.theta, table->theta_steps, 0);
  cell.phi = foredraw_cell_of(place.phi, table->phi_steps, 1);
  if (state) {
    if (foredraw_stays(table, &place, state)) cell = *state;
    *state = cell;
  }
  if (keyframe == FOREDRAW_NO_KEYFRAME) return 0;
  return table->order[((size_t)keyframe * table->theta_steps + cell.theta) * table->phi_steps + cell.phi];
}

/* In which sequence to draw the parts with this order, as many numbers as the table has parts; NULL: as in the file. */
static inline const uint16_t* foredraw_draw_sequence(const foredraw_order_table* table, uint32_t order) {
  return table->parts > 0 ? table->sequences + (size_t)order * table->parts : NULL;
}

#endif
