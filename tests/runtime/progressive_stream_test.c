/* The headers alone, as a C compiler of an engine sees them: a triangle of which a split makes a square is written by
 * the functions that read it. */

#include <foredraw/runtime/progressive_stream.h>

#include <stdio.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("%s\n", what);
  ++failures;
}

static void put_word(uint8_t* to, uint32_t word) {
  int k;
  for (k = 0; k < 4; ++k) to[k] = (uint8_t)(word >> 8 * k);
}

/* A header of one draw of one part without numbers. */
static size_t put_header(uint8_t* to, size_t coded) {
  static const uint32_t counts[3] = {4, 4, 2};
  const size_t bytes = FOREDRAW_STREAM_FIXED + 8 + 4;
  const float step = 0.5f;
  uint32_t step_bits;
  int k;
  memset(to, 0, bytes);
  memcpy(&step_bits, &step, sizeof step_bits);
  put_word(to, FOREDRAW_STREAM_MAGIC);
  put_word(to + 4, 1);
  put_word(to + 8, (uint32_t)bytes);
  put_word(to + 12, (uint32_t)(bytes + FOREDRAW_STREAM_CHUNK + coded));
  put_word(to + 16, 1);
  for (k = 0; k < 3; ++k) put_word(to + 20 + 4 * k, counts[k]);
  put_word(to + 32, 4);
  put_word(to + 48, step_bits);
  put_word(to + 52, 1);
  put_word(to + 56, 1);
  put_word(to + bytes - 4, foredraw_stream_checksum(FOREDRAW_STREAM_NO_BYTES, to, bytes - 4));
  return bytes;
}

/* The triangle 0 1 2, and the point 3 that splits off from 2: 1 3 2 closes the border. */
static size_t code(uint8_t* to, size_t room, foredraw_split_coding* coding) {
  static const int32_t places[12] = {0, 0, 0, 8, 0, 0, 0, 8, 0, 8, 8, 0};
  static const int32_t place[3] = {8, 8, 0};
  static const uint8_t moves[2] = {0, 0};
  static const uint32_t corner_names[6] = {0, 1, 2, 1, 3, 2};
  uint32_t names[4];
  foredraw_wanted_triangle base = {{0, 1, 2}, {0, 1, 2}, 0, FOREDRAW_NONE};
  foredraw_wanted_triangle added = {{1, 3, 2}, {1, 3, 2}, 0, FOREDRAW_NONE};
  foredraw_wanted wanted;
  uint32_t k;
  wanted.moves = moves;
  wanted.corner_names = corner_names;
  wanted.added = &base;
  wanted.added_count = 1;
  wanted.place = places;
  wanted.names = names;
  wanted.values = NULL;
  coding->wanted = &wanted;
  foredraw_writer_begin(&coding->coder, to, room);
  foredraw_code_base(coding, 3);
  wanted.added = &added;
  wanted.place = place;
  for (k = 0; k < 2; ++k) foredraw_code_is_split(coding, 0);
  foredraw_code_is_split(coding, 1);
  foredraw_code_next_split(coding);
  foredraw_writer_end(&coding->coder);
  expect(!coding->damaged && !coding->coder.failed && added.number == 1, "it is not written");
  return room - coding->coder.left;
}

static void numbers_come_back(void) {
  static const int32_t numbers[8] = {0, -1, 1, 77, -70000, INT32_MAX, INT32_MIN, 5};
  uint8_t bytes[256];
  foredraw_number_model model;
  foredraw_range_coder coder;
  size_t written;
  int i;
  foredraw_models_begin((foredraw_bit_model*)&model, sizeof model / sizeof(foredraw_bit_model));
  foredraw_writer_begin(&coder, bytes, sizeof bytes);
  for (i = 0; i < 8; ++i) foredraw_code_number(&coder, &model, numbers[i]);
  foredraw_writer_end(&coder);
  written = sizeof bytes - coder.left;
  foredraw_models_begin((foredraw_bit_model*)&model, sizeof model / sizeof(foredraw_bit_model));
  foredraw_reader_begin(&coder, bytes, written);
  for (i = 0; i < 8; ++i) expect(foredraw_code_number(&coder, &model, 0) == numbers[i], "a number does not come back");
  expect(!coder.failed, "the reader wants more than was written");
  expect(foredraw_ordered_float(foredraw_float_order(-1.5f)) == -1.5f, "a float does not come back");
  expect(foredraw_float_order(-1.5f) < foredraw_float_order(-1.0f) &&
             foredraw_float_order(0.5f) < foredraw_float_order(2.0f),
         "floats are not in order");
}

int progressive_stream_test(void) {
  static uint32_t memory[1 << 18];
  static uint8_t bytes[4096], again[4096];
  foredraw_stream_header header;
  foredraw_stream stream;
  const foredraw_split_mesh* mesh = &stream.coding.mesh;
  size_t head = put_header(bytes, 0), coded, count, i;
  uint32_t checksum;
  numbers_come_back();

  expect(foredraw_stream_read_header(bytes, head, &header) == 1, "the header is refused");
  expect(foredraw_stream_memory(&header, bytes) <= sizeof memory, "it wants much memory");
  foredraw_stream_begin(&stream, &header, bytes, memory);
  coded = code(again, sizeof again, &stream.coding);
  put_header(bytes, coded);
  put_word(bytes + head, (uint32_t)coded);
  put_word(bytes + head + 4, 1);
  put_word(bytes + head + 8, 4);
  put_word(bytes + head + 12, 2);
  put_word(bytes + head + 16, 0);
  checksum = foredraw_stream_checksum(FOREDRAW_STREAM_NO_BYTES, bytes + head, 20);
  put_word(bytes + head + 20, foredraw_stream_checksum(checksum, again, coded));
  memcpy(bytes + head + FOREDRAW_STREAM_CHUNK, again, coded);
  count = head + FOREDRAW_STREAM_CHUNK + coded;

  expect(foredraw_stream_read_header(bytes, head - 1, &header) == 0, "a part of a header is read");
  expect(foredraw_stream_read_header(bytes, count, &header) == 1, "the header is refused");
  foredraw_stream_begin(&stream, &header, bytes, memory);
  expect(foredraw_stream_take(&stream, bytes + head, count - head - 1) == 0 && !stream.damaged,
         "a part of a chunk is read");
  expect(foredraw_stream_take(&stream, bytes + head, count - head) == count - head, "the chunk is not read");
  expect(mesh->vertices == 4 && mesh->triangles == 2, "it is no square");
  expect(foredraw_stream_place(&stream, 3, 0) == 4.0f && foredraw_stream_place(&stream, 3, 1) == 4.0f,
         "the new vertex is elsewhere");
  for (i = 0; i < 6; ++i) expect(mesh->indices[i] < 4, "an index names no vertex");

  bytes[count - 1] ^= 1;
  foredraw_stream_begin(&stream, &header, bytes, memory);
  expect(foredraw_stream_take(&stream, bytes + head, count - head) == 0 && stream.damaged, "damage is not noticed");
  bytes[12] ^= 1;
  expect(foredraw_stream_read_header(bytes, count, &header) == -1, "a damaged header is read");
  return failures;
}
