/* What is known ahead of the ways to draw an object: what each of its levels takes, how near each rendering comes to
 * the full one, and which ways are worth a look at all. The stage lod-table makes these tables, as a C header or in a
 * file. C99, no state, no allocation.
 *
 *   for each visible object
 *     n = foredraw_lod_table_ways(&machine, &draw, pixels_across, focus * motion, ways + first, numbers + first);
 *   foredraw_lod_select(...);                                                                       (lod_select.h)
 *   draw(object, numbers[first + chosen] / 3 is the level, % 3 the rendering)
 *
 * Ways that are never worth their cost are left out ahead: those that lie below the upper hull of cost and benefit at
 * every size of an octave. What all ways of an object have in common, as importance, focus and motion, moves none of
 * them onto the hull or off it. Hysteresis does: with it, what is chosen among the ways of the hull may be a little
 * worse than the best of all ways. */
#ifndef FOREDRAW_RUNTIME_LOD_TABLE_H
#define FOREDRAW_RUNTIME_LOD_TABLE_H

#include <foredraw/runtime/lod_benefit.h>
#include <foredraw/runtime/lod_select.h>

#include <stdint.h>

/* 0: full; 1: without the normal map; 2: unlit. */
#define FOREDRAW_LOD_RENDERINGS 3u

/* Of sizes on the screen: from 2^2 to 2^12 pixels across the bounding sphere. What is smaller or larger counts to the
 * first and the last one. */
#define FOREDRAW_LOD_OCTAVES 10u
#define FOREDRAW_LOD_LEAST_ACROSS 4.0f

/* Of a draw. */
#define FOREDRAW_LOD_MOST_LEVELS 32u

/* What a machine takes, in nanoseconds. */
typedef struct foredraw_lod_machine {
  foredraw_lod_rendering renderings[FOREDRAW_LOD_RENDERINGS];
  float frame; /* that each frame takes, whatever it draws: leave it out of the budget */
  float draw;  /* that each draw call takes */
  int is_sum;  /* stages come one after the other, as foredraw_lod_sum() has it; else as foredraw_lod_pipeline() */
} foredraw_lod_machine;

typedef struct foredraw_lod_table_level {
  uint32_t triangles;
  uint32_t shaded;   /* vertices that a cache of 16 lets through */
  uint32_t vertices; /* that are stored */
  float error;       /* largest distance from full detail, in the draw's units */
} foredraw_lod_table_level;

typedef struct foredraw_lod_table_draw {
  const char* name;
  const foredraw_lod_table_level* level; /* [levels], full detail first */
  uint32_t levels;
  float radius;                            /* of the bounding sphere, in the draw's units */
  float coverage;                          /* of the sphere's disc, what part the draw covers */
  float importance;                        /* 0 to 1 */
  float accuracy[FOREDRAW_LOD_RENDERINGS]; /* 0 to 1: how near a rendering comes to the full one */
  /* [octave][rendering]: bit l is set where level l, drawn so, lies on the hull. */
  uint32_t hulls[FOREDRAW_LOD_OCTAVES][FOREDRAW_LOD_RENDERINGS];
} foredraw_lod_table_draw;

/* The octave of a size. What is no number is small. */
static inline uint32_t foredraw_lod_octave(float across) {
  uint32_t octave = 0;
  float end = 2 * FOREDRAW_LOD_LEAST_ACROSS;
  for (; octave + 1 < FOREDRAW_LOD_OCTAVES && across >= end; ++octave) end *= 2;
  return octave;
}

/* That the draw covers, of a sphere so many pixels across. */
static inline float foredraw_lod_table_pixels(const foredraw_lod_table_draw* draw, float across) {
  const float quarter_of_pi = 0.78539816f;
  return quarter_of_pi * across * across * draw->coverage;
}

/* What accuracy_of_samples() counts: triangles where a surface has no light, else vertices (with a power of 2). */
static inline uint32_t foredraw_lod_table_samples(const foredraw_lod_table_level* level, uint32_t rendering) {
  return rendering == 2 ? level->triangles : level->vertices;
}

/* A level, drawn by a rendering, with the sphere so many pixels across. `factor`: of the benefit, what hangs on the
 * frame: focus, motion. */
static inline foredraw_lod_way foredraw_lod_table_way(const foredraw_lod_machine* machine,
                                                      const foredraw_lod_table_draw* draw, uint32_t level,
                                                      uint32_t rendering, float across, float factor) {
  const foredraw_lod_table_level* of = &draw->level[level];
  const foredraw_lod_rendering* by = &machine->renderings[rendering];
  const float pixels = foredraw_lod_table_pixels(draw, across), triangles = (float)of->triangles,
              vertices = (float)of->shaded;
  const float error_in_pixels = draw->radius > 0 ? of->error * (across / (2 * draw->radius)) : 0;
  const float cost = machine->is_sum ? foredraw_lod_sum(by, triangles, vertices, pixels)
                                     : foredraw_lod_pipeline(by, triangles, vertices, pixels);
  foredraw_lod_way way;
  way.cost = foredraw_lod_cost(machine->draw + cost);
  way.benefit = foredraw_lod_benefit(pixels * draw->accuracy[rendering] *
                                     foredraw_lod_accuracy_of_error(error_in_pixels) * draw->importance * factor);
  return way;
}

/* The ways of a draw that are worth a look at that size. Of each the number: FOREDRAW_LOD_RENDERINGS * level +
 * rendering. Both arrays take FOREDRAW_LOD_RENDERINGS * levels; answers with how many there are, one at least. */
static inline uint32_t foredraw_lod_table_ways(const foredraw_lod_machine* machine, const foredraw_lod_table_draw* draw,
                                               float across, float factor, foredraw_lod_way* ways, uint32_t* numbers) {
  const uint32_t* hull = draw->hulls[foredraw_lod_octave(across)];
  uint32_t level, rendering, count = 0;
  for (level = 0; level < draw->levels; ++level) {
    for (rendering = 0; rendering < FOREDRAW_LOD_RENDERINGS; ++rendering) {
      if ((hull[rendering] >> level & 1u) == 0) continue;
      ways[count] = foredraw_lod_table_way(machine, draw, level, rendering, across, factor);
      numbers[count++] = FOREDRAW_LOD_RENDERINGS * level + rendering;
    }
  }
  return count;
}

/* Sets in `hull` what lies on the hull when the sphere is so many pixels across. `ways`: room for all. */
static inline void foredraw_lod_table_add_hull(const foredraw_lod_machine* machine, const foredraw_lod_table_draw* draw,
                                               float across, foredraw_lod_way* ways, uint32_t* hull) {
  const uint32_t count = FOREDRAW_LOD_RENDERINGS * draw->levels;
  uint32_t way, i;
  for (i = 0; i < count; ++i) {
    ways[i] =
        foredraw_lod_table_way(machine, draw, i / FOREDRAW_LOD_RENDERINGS, i % FOREDRAW_LOD_RENDERINGS, across, 1);
  }
  for (way = count > 0 ? foredraw_lod_cheapest(ways, count) : 0; way < count;
       way = foredraw_lod_next(ways, count, way, UINT64_MAX)) {
    hull[way % FOREDRAW_LOD_RENDERINGS] |= 1u << (way / FOREDRAW_LOD_RENDERINGS);
  }
}

/* Fills the hulls of a draw for a machine, from what else is known of it: each octave's are those at its beginning, at
 * its end, and at seven sizes between. `ways`: room for FOREDRAW_LOD_RENDERINGS * levels. */
static inline void foredraw_lod_table_fill(const foredraw_lod_machine* machine, foredraw_lod_table_draw* draw,
                                           foredraw_lod_way* ways) {
  float first = FOREDRAW_LOD_LEAST_ACROSS;
  uint32_t octave, step, rendering;
  for (octave = 0; octave < FOREDRAW_LOD_OCTAVES; ++octave, first *= 2) {
    for (rendering = 0; rendering < FOREDRAW_LOD_RENDERINGS; ++rendering) draw->hulls[octave][rendering] = 0;
    for (step = 0; step <= 8; ++step) {
      foredraw_lod_table_add_hull(machine, draw, first + first / 8 * (float)step, ways, draw->hulls[octave]);
    }
  }
}

#endif
