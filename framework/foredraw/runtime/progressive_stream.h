/* Reads a mesh that arrives in chunks, each of which makes it finer. C99, no allocation; the stage `progressive-stream`
 * writes streams.
 *
 *   foredraw_stream_header header;
 *   if (foredraw_stream_read_header(bytes, count, &header) < 0) refuse();   // 0: more bytes are wanted
 *   void* memory = malloc(foredraw_stream_memory(&header, bytes));
 *   foredraw_stream stream;
 *   const foredraw_split_mesh* mesh = &stream.coding.mesh;
 *   foredraw_stream_begin(&stream, &header, bytes, memory);
 *   at = header.bytes;
 *   while ((used = foredraw_stream_take(&stream, bytes + at, count - at)) > 0) {
 *     at += used;
 *     draw(mesh->indices, 3 * mesh->triangles);    // of the first mesh->vertices vertices
 *   }
 *   if (stream.damaged) refuse();
 *
 * A chunk that is not there as a whole is left for the next call. One whose checksum is wrong is not looked at, so that
 * the mesh stays what it was. Whatever the bytes are, nothing outside of the memory is touched, and a stream asks for
 * no more than a thousand bytes of memory for each byte that it says it has.
 */
#ifndef FOREDRAW_RUNTIME_PROGRESSIVE_STREAM_H
#define FOREDRAW_RUNTIME_PROGRESSIVE_STREAM_H

#include <foredraw/runtime/base_coding.h>

#define FOREDRAW_STREAM_MAGIC 0x53504446u /* "FDPS" */
#define FOREDRAW_STREAM_FIXED 64u         /* bytes of the header in front of its tables */
#define FOREDRAW_STREAM_CHUNK 24u         /* bytes in front of what a chunk codes */
#define FOREDRAW_STREAM_GRID_BITS 20u     /* of places, at most */

/* What a stream says of itself. All numbers of 4 bytes, the lowest first. */
typedef struct foredraw_stream_header {
  uint32_t bytes; /* of the header */
  uint32_t total; /* bytes of the stream */
  uint32_t chunks;
  uint32_t points, vertices, triangles; /* of full detail */
  uint32_t grid_bits;
  float least[3], step; /* places are step * number + least */
  uint32_t parts, draws, components;
} foredraw_stream_header;

typedef struct foredraw_stream {
  foredraw_stream_header header;
  foredraw_split_coding coding; /* coding.mesh: what has arrived */
  uint32_t chunks;              /* that have arrived */
  float error; /* an estimate of how far what has arrived lies from full detail, in units, less what the grid takes */
  int damaged;
} foredraw_stream;

static inline uint32_t foredraw_stream_word(const uint8_t* bytes) {
  return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}
static inline float foredraw_stream_float(const uint8_t* bytes) {
  const uint32_t bits = foredraw_stream_word(bytes);
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/* FNV-1a; no change of a single byte goes unseen. */
static inline uint32_t foredraw_stream_checksum(uint32_t so_far, const uint8_t* bytes, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) so_far = (so_far ^ bytes[i]) * 16777619u;
  return so_far;
}
#define FOREDRAW_STREAM_NO_BYTES 2166136261u

/* Bytes for the arrays of such a mesh, of 4 bytes each but models. */
static inline uint64_t foredraw_stream_memory_of(const foredraw_stream_header* header, uint32_t width) {
  const uint64_t tables =
      (uint64_t)4 * (header->draws + 2 * (uint64_t)header->parts + 4 * (uint64_t)header->components);
  const uint64_t models = sizeof(foredraw_split_models) + (uint64_t)width * sizeof(foredraw_number_model);
  return tables + models + (uint64_t)4 * 10 * header->triangles + (uint64_t)4 * 7 * header->points +
         (uint64_t)4 * (3 + (uint64_t)width) * header->vertices;
}

static inline uint32_t foredraw_stream_width(const foredraw_stream_header* header, const uint8_t* bytes) {
  uint32_t width = 0, i;
  for (i = 0; i < header->parts; ++i) {
    const uint32_t count = foredraw_stream_word(bytes + FOREDRAW_STREAM_FIXED + 4 * (size_t)i);
    if (count > width) width = count;
  }
  return width;
}

/* 1: it is there and good; 0: more bytes are wanted; -1: it is none, or damaged, or claims too much. */
static inline int foredraw_stream_read_header(const uint8_t* bytes, size_t count, foredraw_stream_header* header) {
  uint64_t components = 0;
  uint32_t i, k;
  if (count < FOREDRAW_STREAM_FIXED) return 0;
  if (foredraw_stream_word(bytes) != FOREDRAW_STREAM_MAGIC || foredraw_stream_word(bytes + 4) != 1) return -1;
  header->bytes = foredraw_stream_word(bytes + 8);
  header->total = foredraw_stream_word(bytes + 12);
  header->chunks = foredraw_stream_word(bytes + 16);
  header->points = foredraw_stream_word(bytes + 20);
  header->vertices = foredraw_stream_word(bytes + 24);
  header->triangles = foredraw_stream_word(bytes + 28);
  header->grid_bits = foredraw_stream_word(bytes + 32);
  for (k = 0; k < 3; ++k) header->least[k] = foredraw_stream_float(bytes + 36 + 4 * k);
  header->step = foredraw_stream_float(bytes + 48);
  header->parts = foredraw_stream_word(bytes + 52);
  header->draws = foredraw_stream_word(bytes + 56);
  header->components = foredraw_stream_word(bytes + 60);
  if (header->parts == 0 || header->draws == 0 || header->parts > 65536 || header->draws > 65536 ||
      header->components > 65536 || header->grid_bits == 0 || header->grid_bits > FOREDRAW_STREAM_GRID_BITS ||
      header->bytes != FOREDRAW_STREAM_FIXED + 4 * (header->parts + header->draws + 4 * header->components) + 4 ||
      header->bytes > header->total || header->triangles > 0x2aaaaaaau) {
    return -1;
  }
  if (count < header->bytes) return 0;
  if (foredraw_stream_checksum(FOREDRAW_STREAM_NO_BYTES, bytes, header->bytes - 4) !=
      foredraw_stream_word(bytes + header->bytes - 4)) {
    return -1;
  }
  for (i = 0; i < header->parts; ++i) components += foredraw_stream_word(bytes + FOREDRAW_STREAM_FIXED + 4 * i);
  if (components != header->components) return -1;
  for (i = 0; i < header->draws; ++i)
    if (foredraw_stream_word(bytes + FOREDRAW_STREAM_FIXED + 4 * (header->parts + i)) >= header->parts) return -1;
  if (foredraw_stream_memory_of(header, foredraw_stream_width(header, bytes)) >
      (uint64_t)1000 * header->total + 1000000) {
    return -1;
  }
  return 1;
}

/* How much foredraw_stream_begin() needs, aligned for numbers of 4 bytes. Of a good header. */
static inline size_t foredraw_stream_memory(const foredraw_stream_header* header, const uint8_t* bytes) {
  return (size_t)foredraw_stream_memory_of(header, foredraw_stream_width(header, bytes));
}

/* The next so many numbers of the memory. */
static inline uint32_t* foredraw_stream_room(uint32_t** memory, size_t count) {
  uint32_t* room = *memory;
  *memory += count;
  return room;
}

/* A mesh of nothing, with room for all. Nothing of `bytes`, which begin with the header, is needed later. */
static inline void foredraw_stream_begin(foredraw_stream* stream, const foredraw_stream_header* header,
                                         const uint8_t* bytes, void* memory) {
  foredraw_split_mesh* mesh = &stream->coding.mesh;
  const size_t points = header->points, vertices = header->vertices, triangles = header->triangles;
  const uint8_t* table = bytes + FOREDRAW_STREAM_FIXED;
  uint32_t* room = (uint32_t*)memory;
  foredraw_part* parts;
  foredraw_component* components;
  uint32_t i, first = 0;
  memset(stream, 0, sizeof *stream);
  stream->header = *header;

  mesh->most_points = header->points;
  mesh->most_vertices = header->vertices;
  mesh->most_triangles = header->triangles;
  mesh->grid = 1u << header->grid_bits;
  memcpy(mesh->least, header->least, sizeof mesh->least);
  mesh->step = header->step;
  mesh->draws = header->draws;
  mesh->width = foredraw_stream_width(header, bytes);

  mesh->part = parts = (foredraw_part*)foredraw_stream_room(&room, 2 * (size_t)header->parts);
  for (i = 0; i < header->parts; ++i, table += 4) {
    parts[i].first = first;
    parts[i].count = foredraw_stream_word(table);
    first += parts[i].count;
  }
  mesh->draw_part = room;
  for (i = 0; i < header->draws; ++i, table += 4) *foredraw_stream_room(&room, 1) = foredraw_stream_word(table);
  mesh->component = components = (foredraw_component*)foredraw_stream_room(&room, 4 * (size_t)header->components);
  for (i = 0; i < header->components; ++i, table += 16) {
    components[i].form = foredraw_stream_word(table);
    components[i].axis = foredraw_stream_word(table + 4);
    components[i].least = foredraw_stream_float(table + 8);
    components[i].step = foredraw_stream_float(table + 12);
  }

  mesh->indices = foredraw_stream_room(&room, 3 * triangles);
  mesh->draw = foredraw_stream_room(&room, triangles);
  mesh->corner = (foredraw_corner*)foredraw_stream_room(&room, 6 * triangles);
  mesh->point = (foredraw_point*)foredraw_stream_room(&room, 7 * points);
  mesh->values = (int32_t*)foredraw_stream_room(&room, mesh->width * vertices);
  mesh->vertex = (foredraw_vertex*)foredraw_stream_room(&room, 3 * vertices);
  stream->coding.models = (foredraw_split_models*)room;
  stream->coding.value_models = (foredraw_number_model*)(stream->coding.models + 1);
  foredraw_models_begin(
      (foredraw_bit_model*)room,
      (sizeof(foredraw_split_models) + mesh->width * sizeof(foredraw_number_model)) / sizeof(foredraw_bit_model));
  stream->coding.budget = 64 * (3 * (uint64_t)triangles + points + 1024);
}

/* What a chunk says of itself. */
typedef struct foredraw_stream_chunk {
  uint32_t bytes;               /* that it codes in */
  uint32_t splits;              /* of it */
  uint32_t vertices, triangles; /* that are there when it is read */
  float error;
} foredraw_stream_chunk;

/* Brings the mesh up to the next chunk, and answers how many bytes that took; 0 where they are not all there, where it
 * is damaged, and where no chunk is left. */
static inline size_t foredraw_stream_take(foredraw_stream* stream, const uint8_t* bytes, size_t count) {
  foredraw_split_coding* coding = &stream->coding;
  foredraw_stream_chunk chunk;
  uint32_t splits, checksum;
  if (stream->damaged || stream->chunks == stream->header.chunks || count < FOREDRAW_STREAM_CHUNK) return 0;
  chunk.bytes = foredraw_stream_word(bytes);
  chunk.splits = foredraw_stream_word(bytes + 4);
  chunk.vertices = foredraw_stream_word(bytes + 8);
  chunk.triangles = foredraw_stream_word(bytes + 12);
  chunk.error = foredraw_stream_float(bytes + 16);
  if (chunk.bytes > stream->header.total) stream->damaged = 1;
  if (stream->damaged || count - FOREDRAW_STREAM_CHUNK < chunk.bytes) return 0;
  checksum = foredraw_stream_checksum(FOREDRAW_STREAM_NO_BYTES, bytes, FOREDRAW_STREAM_CHUNK - 4);
  bytes += FOREDRAW_STREAM_CHUNK;
  if (foredraw_stream_checksum(checksum, bytes, chunk.bytes) != foredraw_stream_word(bytes - 4)) stream->damaged = 1;
  if (stream->damaged) return 0;

  foredraw_reader_begin(&coding->coder, bytes, chunk.bytes);
  if (stream->chunks == 0) foredraw_code_base(coding, 0);
  for (splits = 0; splits < chunk.splits && !coding->damaged && !coding->coder.failed;) {
    if (!foredraw_code_is_split(coding, 0)) continue;
    foredraw_code_next_split(coding);
    ++splits;
  }
  ++stream->chunks;
  stream->error = chunk.error;
  if (coding->damaged || coding->coder.failed || coding->mesh.vertices != chunk.vertices ||
      coding->mesh.triangles != chunk.triangles ||
      (stream->chunks == stream->header.chunks &&
       (coding->mesh.points != stream->header.points || chunk.vertices != stream->header.vertices ||
        chunk.triangles != stream->header.triangles))) {
    stream->damaged = 1;
    return 0;
  }
  return FOREDRAW_STREAM_CHUNK + chunk.bytes;
}

/* The place of a vertex, and any other of its numbers. */
static inline float foredraw_stream_place(const foredraw_stream* stream, uint32_t vertex, uint32_t axis) {
  return foredraw_place(&stream->coding.mesh, stream->coding.mesh.vertex[vertex].point, axis);
}
static inline float foredraw_stream_value(const foredraw_stream* stream, uint32_t vertex, uint32_t number) {
  const foredraw_split_mesh* mesh = &stream->coding.mesh;
  const foredraw_component* component = mesh->component + mesh->part[mesh->vertex[vertex].part].first + number;
  const int32_t value = mesh->values[(size_t)mesh->width * vertex + number];
  if (component->form == 2) return foredraw_ordered_float(value);
  if (component->form == 1) return (float)((double)value * (double)component->step + (double)component->least);
  return (float)value;
}

#endif
