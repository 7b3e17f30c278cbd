/* Walks a camera once around a character while a clip plays, and prints which of its index buffers a frame loop would
 * draw. Reads what `foredraw optimize in.glb -o out.glb --draw-orders orders.json` writes.
 *
 *   character_orders orders.json [clip, 0 if left out] [steps of the walk, 36] */

#include <foredraw/runtime/order_table.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The whole file, as text. */
static char* text_of(const char* path, size_t* size) {
  FILE* file = fopen(path, "rb");
  char* text = NULL;
  long length = -1;
  if (file && fseek(file, 0, SEEK_END) == 0) length = ftell(file);
  if (length >= 0 && fseek(file, 0, SEEK_SET) == 0) text = (char*)malloc((size_t)length + 1);
  if (text) {
    *size = fread(text, 1, (size_t)length, file);
    text[*size] = '\0';
  }
  if (file) fclose(file);
  return text;
}

/* Behind the next `key`; NULL where there is none before `end`. Names can not hold a key: their quotes are escaped. */
static const char* behind(const char* text, const char* key, const char* end) {
  const char* found = strstr(text, key);
  return found && found < end ? found + strlen(key) : NULL;
}

/* Reads "1,2,3]" and returns how many numbers these are. */
static uint32_t numbers(const char* text, float* times, uint8_t* order) {
  uint32_t count = 0;
  char* next;
  for (;; text = next + (*next == ',')) {
    const double value = strtod(text, &next);
    if (next == text) return count;
    if (times) times[count] = (float)value;
    if (order) order[count] = (uint8_t)value;
    ++count;
  }
}

int main(int argc, char** argv) {
  const float turn = 6.28318531f;
  const uint32_t clip = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 0;
  const uint32_t steps = argc > 3 ? (uint32_t)strtoul(argv[3], NULL, 10) : 36;
  size_t size = 0;
  char* text = argc > 1 ? text_of(argv[1], &size) : NULL;
  const char* end = text ? strstr(text, "\"theta-steps\":") : NULL;
  const char* phi_steps = end ? behind(end, "\"phi-steps\":", text + size) : NULL;
  const char* cells = end ? behind(end, "\"order\":[", text + size) : NULL;
  /* No table has more numbers than its text has bytes. */
  uint32_t* keyframes = (uint32_t*)malloc((size + 1) * sizeof(uint32_t));
  float* times = (float*)malloc((size + 1) * sizeof(float));
  uint8_t* order = (uint8_t*)malloc(size + 1);
  foredraw_order_table table = {0, NULL, NULL, 1, 1, NULL};
  foredraw_order_state state = {0, 0, 0};
  float first = 0, last = 0;
  uint32_t known = 0, step;
  const char* at;
  if (!phi_steps || !cells || !keyframes || !times || !order) {
    fprintf(stderr, "character_orders: give it what --draw-orders wrote, with one table at least\n");
    return 1;
  }

  table.keyframes = keyframes;
  table.times = times;
  table.order = order;
  for (at = behind(text, "\"times\":[", end); at; at = behind(at, "\"times\":[", end)) {
    const uint32_t count = numbers(at, times + known, NULL);
    if (table.clips == clip && count > 0) {
      first = times[known];
      last = times[known + count - 1];
    }
    keyframes[table.clips++] = count;
    known += count;
  }
  table.theta_steps = (uint32_t)strtoul(behind(end, "\"theta-steps\":", text + size), NULL, 10);
  table.phi_steps = (uint32_t)strtoul(phi_steps, NULL, 10);
  numbers(cells, NULL, order);

  for (step = 0; step < steps; ++step) {
    const float part = (float)step / (float)steps;
    const float time = first + part * (last - first);
    const float towards_camera[3] = {cosf(part * turn), 0.3f, sinf(part * turn)};
    printf("%g degrees, %g s: order %u\n", 360 * (double)part, (double)time,
           (unsigned)foredraw_order_at(&table, clip, time, towards_camera, &state));
  }
  free(order);
  free(times);
  free(keyframes);
  free(text);
  return 0;
}
