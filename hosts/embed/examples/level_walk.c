/* Walks a camera up to a model and past it, and makes it as fine as one pixel needs, in each of three ways: a level
 * whose vertices move to those of the next one, a mesh that becomes finer triangle by triangle, and one that is fine
 * where it is looked at. Says how many triangles each draws, and how long choosing them took. Reads what this writes:
 *
 *   foredraw optimize in.glb -o out.glb -p 'weld, quadric-collapse(placement=endpoint), \
 *     levels(ratios="0.5, 0.25, 0.12, 0.06, 0.03", keep-sequences=true), geomorphs(keep-sequences=true)'
 *   level_walk out.glb [frames, 60] */

#include "level_model.h"

#include <foredraw/runtime/geomorph.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const float allowed = 1;             /* pixels that the surface may be off */
static const float height = 1080;           /* of the picture, which is a square */
static const float half_angle = 0.5773503f; /* tangent of 30 degrees */
static const uint32_t changes = 2000;       /* splits and collapses a frame, at most */

static double microseconds_since(clock_t begin) { return 1e6 * (double)(clock() - begin) / CLOCKS_PER_SEC; }

/* The planes of a square picture. */
static void look(foredraw_refine_view* view, const float ahead[3], const float right[3], const float up[3]) {
  const float side = 1 / sqrtf(1 + half_angle * half_angle);
  int i, k;
  for (i = 0; i < 6; ++i) {
    const float* across = i < 2 ? right : up;
    const float sign = i % 2 == 0 ? 1.0f : -1.0f;
    float* plane = view->planes[i];
    for (k = 0; k < 3; ++k) plane[k] = i < 4 ? side * (half_angle * ahead[k] + sign * across[k]) : ahead[k];
    plane[3] = -foredraw_refine_dot(plane, view->eye);
  }
}

/* The camera of a frame: from 40 radii away to less than one and a half, and slowly turned aside. */
static float camera_at(float part, const float centre[3], float radius, foredraw_refine_view* view) {
  const float away = radius * 40 * powf(1.4f / 40, part);
  const float turn = 0.5f * part;
  const float ahead[3] = {sinf(turn), 0, -cosf(turn)};
  const float right[3] = {cosf(turn), 0, sinf(turn)};
  const float up[3] = {0, 1, 0};
  view->eye[0] = centre[0];
  view->eye[1] = centre[1];
  view->eye[2] = centre[2] + away;
  view->pixels = height / 2 / half_angle;
  view->surface = view->silhouette = allowed;
  view->back_sides = 0;
  look(view, ahead, right, up);
  return away - radius; /* to the nearest place that the model may have */
}

/* The coarsest level that may be drawn from there, and how far it is on its way to the next one: when it has arrived,
 * that may be drawn. So no vertex is ever off by more than what is allowed. */
static uint32_t level_at(const level_model* model, float units, float* alpha) {
  const uint32_t levels = level_model_levels(model);
  uint32_t level = 0;
  while (level + 1 < levels && level_model_level(model, level + 1).error <= units) ++level;
  *alpha = 0;
  if (level + 1 < levels) {
    const float now = level_model_level(model, level).error, next = level_model_level(model, level + 1).error;
    *alpha = (units - now) / (next - now);
  }
  return level;
}

static void morph(const level_model* model, uint32_t level, float alpha, float* blended) {
  const uint32_t* ancestors = level_model_level(model, level).ancestors;
  const float* positions = level_model_positions(model);
  const uint32_t vertices = level_model_vertices(model);
  uint32_t v;
  for (v = 0; v < vertices; ++v) {
    const uint32_t to = ancestors ? ancestors[v] : v;
    foredraw_geomorph(positions + 3 * v, positions + 3 * to, alpha, 3, blended + 3 * v);
  }
}

int main(int argc, char** argv) {
  const unsigned long asked = argc > 2 ? strtoul(argv[2], NULL, 10) : 60;
  const uint32_t frames = asked > 1000000 ? 1000000 : (uint32_t)asked;
  double triangles[3] = {0, 0, 0}, times[3] = {0, 0, 0};
  foredraw_progressive_mesh progressive;
  foredraw_refinement state;
  level_model* model;
  uint32_t* memory;
  float* blended;
  float centre[3], radius;
  uint32_t frame;
  int i;
  if (argc < 2 || frames == 0) {
    fprintf(stderr, "usage: level_walk FILE [frames, 60]\n");
    return 2;
  }
  model = level_model_load(argv[1]);
  if (!model) return 1;
  memory = (uint32_t*)malloc(sizeof(uint32_t) * foredraw_refine_words(level_model_refine(model)));
  blended = (float*)malloc(3 * sizeof(float) * level_model_vertices(model));
  if (!memory || !blended) return 1;
  foredraw_refine_begin(&state, level_model_refine(model), memory);
  progressive = level_model_progressive(model);
  level_model_ball(model, centre, &radius);

  printf(
      "        away | level     morphed triangles     us | triangle by triangle     us | selective  changes     us\n");
  for (frame = 0; frame < frames; ++frame) {
    foredraw_refine_view view;
    const float part = frames > 1 ? (float)frame / (float)(frames - 1) : 0;
    const float away = camera_at(part, centre, radius, &view);
    const float units = allowed * (away > 0 ? away : 0) / view.pixels; /* that are allowed there */
    double drawn[3], time[3];
    uint32_t level, changed;
    float alpha;
    clock_t begin = clock();

    level = level_at(model, units, &alpha);
    morph(model, level, alpha, blended);
    time[0] = microseconds_since(begin);
    drawn[0] = level_model_level(model, level).triangles;

    begin = clock();
    foredraw_progressive_go(&progressive, foredraw_progressive_splits_for(&progressive, units));
    time[1] = microseconds_since(begin);
    drawn[1] = foredraw_progressive_triangles(&progressive);

    begin = clock();
    changed = foredraw_refine(&state, foredraw_refine_view_wants, &view, changes);
    time[2] = microseconds_since(begin);
    drawn[2] = state.triangles;

    printf("%12.3f | %5u %11.2f %9.0f %6.0f | %20.0f %6.0f | %9.0f %8u %6.0f\n", (double)away, (unsigned)level,
           (double)alpha, drawn[0], time[0], drawn[1], time[1], drawn[2], (unsigned)changed, time[2]);
    for (i = 0; i < 3; ++i) {
      triangles[i] += drawn[i];
      times[i] += time[i];
    }
  }
  printf("mean of all  | %27.0f %6.1f | %20.0f %6.1f | %9.0f %15.1f\n", triangles[0] / frames, times[0] / frames,
         triangles[1] / frames, times[1] / frames, triangles[2] / frames, times[2] / frames);
  free(memory);
  free(blended);
  level_model_free(model);
  return 0;
}
