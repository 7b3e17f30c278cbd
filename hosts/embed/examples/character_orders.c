/* Walks a camera all around a character while its clips play, draws with each frame the index buffers that the table
 * names, its parts in the sequence that belongs to them, and counts what that saves. Reads what `foredraw optimize
 * in.glb -o out.glb --pipeline @character` writes.
 *
 *   character_orders out.glb [frames of the walk through each clip, 200] */

#include "character.h"

#include <stdio.h>
#include <stdlib.h>

/* A spiral from the upper pole to the lower one that comes by everywhere alike. */
static void camera_at(float part, uint32_t frames, float towards_camera[3]) {
  const float height = 1 - 2 * part;
  const float ring = sqrtf(1 - height * height);
  const float turns = sqrtf((float)frames / 3.14159265f);
  const float angle = turns * 3.14159265f * acosf(height);
  towards_camera[0] = ring * cosf(angle);
  towards_camera[1] = height;
  towards_camera[2] = ring * sinf(angle);
}

static void add(character_fragments* sum, const character_fragments* one) {
  sum->drawn += one->drawn;
  sum->visible += one->visible;
}

static double overdraw(const character_fragments* fragments) {
  return fragments->visible > 0 ? fragments->drawn / fragments->visible : 1;
}

int main(int argc, char** argv) {
  const unsigned long asked = argc > 2 ? strtoul(argv[2], NULL, 10) : 200;
  const uint32_t frames = asked > 1000000 ? 1000000 : (uint32_t)asked;
  const foredraw_order_table* table;
  const float* times;
  character_fragments with_table = {0, 0}, with_one = {0, 0};
  character* hero;
  uint32_t clip, frame;
  if (argc < 2 || frames == 0) {
    fprintf(stderr, "usage: character_orders FILE [frames of the walk through each clip, 200]\n");
    return 2;
  }
  hero = character_load(argv[1]);
  if (!hero) return 1;

  table = character_table(hero);
  times = table->times;
  for (clip = 0; clip < (table->clips > 0 ? table->clips : 1); ++clip) {
    const uint32_t keyframes = table->clips > 0 ? table->keyframes[clip] : 0;
    foredraw_order_state state = {0, 0, 0};
    for (frame = 0; frame < frames; ++frame) {
      const float part = ((float)frame + 0.5f) / (float)frames;
      const float loops = part * 7.39f; /* the clip is at another moment whenever the camera comes by */
      const float moment = loops - floorf(loops);
      const float time = keyframes > 0 ? times[0] + moment * (times[keyframes - 1] - times[0]) : 0;
      float towards_camera[3];
      character_fragments chosen, first;
      const uint16_t* sequence;
      uint32_t order;

      camera_at(part, frames, towards_camera);
      order = foredraw_order_at(table, clip, time, towards_camera, &state);
      sequence = foredraw_draw_sequence(table, order);

      if (!character_pose(hero, clip, time) || !character_draw(hero, towards_camera, order, sequence, &chosen) ||
          !character_draw(hero, towards_camera, 0, NULL, &first)) {
        character_free(hero);
        return 1;
      }
      printf("clip %u, %.3f s, camera %+.2f %+.2f %+.2f: order %u, %.4f fragments per pixel, %.4f with order 0\n",
             (unsigned)clip, (double)time, (double)towards_camera[0], (double)towards_camera[1],
             (double)towards_camera[2], (unsigned)order, overdraw(&chosen), overdraw(&first));
      add(&with_table, &chosen);
      add(&with_one, &first);
    }
    if (times) times += keyframes;
  }
  printf("the whole walk: %.4f fragments per pixel, %.4f with order 0\n", overdraw(&with_table), overdraw(&with_one));
  character_free(hero);
  return 0;
}
