/* A mesh that becomes finer and coarser triangle by triangle while it is drawn. C99, no allocation;
 * foredraw::progressive_records() makes the arrays.
 *
 *   foredraw_progressive_mesh mesh = {splits, split_count, patches, indices, vertex_count, triangle_count,
 * split_count};
 *   ...
 *   foredraw_progressive_go(&mesh, foredraw_progressive_splits_for(&mesh, error));
 *   draw(indices, 3 * foredraw_progressive_triangles(&mesh));   // of the first foredraw_progressive_vertices()
 * vertices
 *
 * Vertices and triangles come in the sequence in which they appear, so that each state is the front of both arrays, and
 * what a split or a collapse changes of the front is a few corners. Hoppe: Progressive Meshes, SIGGRAPH 1996,
 * section 3.
 */
#ifndef FOREDRAW_RUNTIME_PROGRESSIVE_MESH_H
#define FOREDRAW_RUNTIME_PROGRESSIVE_MESH_H

#include <stddef.h>
#include <stdint.h>

/* One vertex becomes two. */
typedef struct foredraw_split {
  uint32_t vertices;    /* in front of what it adds */
  uint32_t triangles;   /* in front of what it adds */
  uint32_t first_patch; /* its patches; those of the next split begin where they end */
  float error;          /* how far the mesh without it and those behind lies from full detail, in units; estimated */
} foredraw_split;

/* A corner of a triangle that was there before. */
typedef struct foredraw_patch {
  uint32_t corner; /* number in the indices */
  uint32_t fine;   /* the vertex with the split */
  uint32_t coarse; /* and without */
} foredraw_patch;

typedef struct foredraw_progressive_mesh {
  const foredraw_split* splits; /* from coarse to fine; one more than split_count, which says where patches end */
  size_t split_count;
  const foredraw_patch* patches;
  uint32_t* indices;  /* three for each triangle; in the state after `done` splits */
  uint32_t vertices;  /* of full detail */
  uint32_t triangles; /* of full detail */
  size_t done;        /* splits */
} foredraw_progressive_mesh;

/* What is to be drawn now. */
static inline uint32_t foredraw_progressive_triangles(const foredraw_progressive_mesh* mesh) {
  return mesh->done < mesh->split_count ? mesh->splits[mesh->done].triangles : mesh->triangles;
}
static inline uint32_t foredraw_progressive_vertices(const foredraw_progressive_mesh* mesh) {
  return mesh->done < mesh->split_count ? mesh->splits[mesh->done].vertices : mesh->vertices;
}

/* Runs splits or collapses until so many splits are done; more than there are is all. */
static inline void foredraw_progressive_go(foredraw_progressive_mesh* mesh, size_t splits) {
  const size_t wanted = splits < mesh->split_count ? splits : mesh->split_count;
  uint32_t i, end;
  if (wanted > mesh->done) {
    end = mesh->splits[wanted].first_patch;
    for (i = mesh->splits[mesh->done].first_patch; i < end; ++i)
      mesh->indices[mesh->patches[i].corner] = mesh->patches[i].fine;
  } else {
    end = mesh->splits[wanted].first_patch;
    for (i = mesh->splits[mesh->done].first_patch; i > end; --i)
      mesh->indices[mesh->patches[i - 1].corner] = mesh->patches[i - 1].coarse;
  }
  mesh->done = wanted;
}

/* The fewest splits after which the mesh lies no farther from full detail than that, by the splits' estimates. */
static inline size_t foredraw_progressive_splits_for(const foredraw_progressive_mesh* mesh, float error) {
  size_t few = 0, many = mesh->split_count;
  while (few < many) {
    const size_t middle = few + (many - few) / 2;
    if (mesh->splits[middle].error <= error) {
      many = middle;
    } else {
      few = middle + 1;
    }
  }
  return few;
}

/* The most splits with at most so many triangles; 0 where the coarsest state has more. */
static inline size_t foredraw_progressive_splits_within(const foredraw_progressive_mesh* mesh, uint32_t triangles) {
  size_t few = 0, many = mesh->split_count;
  if (triangles >= mesh->triangles) return mesh->split_count;
  while (few < many) {
    const size_t middle = few + (many - few + 1) / 2;
    if (mesh->splits[middle].triangles <= triangles) {
      few = middle;
    } else {
      many = middle - 1;
    }
  }
  return few;
}

#endif
