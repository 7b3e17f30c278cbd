/* Meshes with many instances drawn by few calls, for C. Part of functions.h. */
#ifndef FOREDRAW_C_INSTANCES_H
#define FOREDRAW_C_INSTANCES_H

#include <foredraw/c/mesh.h>
#include <foredraw/c/status.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A mesh whose vertices lie in one buffer with the others'. Its indices begin at its own first vertex. */
typedef struct foredraw_packed_mesh {
  foredraw_triangles triangles;
  foredraw_positions positions;
  uint32_t first_vertex; /* in the buffer */
  uint32_t reserved;     /* 0 */
} foredraw_packed_mesh;

typedef struct foredraw_placed_mesh {
  uint32_t mesh;
  float transform[12]; /* three rows of four: what (x, y, z, 1) is multiplied with from the left */
} foredraw_placed_mesh;

typedef struct foredraw_merged_slot {
  uint32_t index_offset, instance;
} foredraw_merged_slot;

/* slot_count * frequency vertices are drawn, without an index buffer bound. */
typedef struct foredraw_merged_draw {
  uint32_t group, frequency, first_slot, slot_count;
} foredraw_merged_draw;

/* Instances that lie together, to be culled together. */
typedef struct foredraw_merged_group {
  float least[3], most[3];
  uint32_t first_instance, instance_count;
} foredraw_merged_group;

/* Buffers that foredraw/runtime/merge_instances.h reads, and the draws. The library's memory: foredraw_merged_free().
 */
typedef struct foredraw_merged {
  const uint32_t* indices; /* into the buffer of vertices */
  const foredraw_merged_slot* slots;
  const float* transforms; /* twelve an instance */
  const uint32_t* placed;  /* [instance] which of those that were given */
  const foredraw_merged_draw* draws;
  const foredraw_merged_group* groups;
  uint64_t index_count, slot_count;
  uint32_t instance_count, draw_count, group_count, reserved;
  void* owner;
} foredraw_merged;

/* Many meshes with many instances each, drawn by few calls without a vertex stored twice. `frequencies`: different
 * sizes of slots at most, 1 to 4 (2), each a draw of its own. `most_size`: of a group's box, its longest side; 0: any.
 * A transform that is flat or not finite is FOREDRAW_NO_TRANSFORM, as is a position that is not finite. Persson:
 * Graphics Gems for Games, SIGGRAPH 2012. */
int foredraw_merge_instances(foredraw_merged* merged, const foredraw_packed_mesh* meshes, uint32_t mesh_count,
                             const foredraw_placed_mesh* placed, uint32_t placed_count, uint32_t frequencies,
                             double most_size);
void foredraw_merged_free(foredraw_merged* merged);

#ifdef __cplusplus
}
#endif

#endif
