/* Foredraw's plain functions for C, and for what calls C: orders of triangles and vertices, clusters, figures. C99;
 * link libforedraw_functions, which needs the C++ runtime and nothing else.
 *
 *   const foredraw_triangles mesh = {indices, index_count, sizeof *indices, vertex_count};
 *   uint32_t* order = malloc(index_count / 3 * sizeof *order);
 *   int status = foredraw_lookahead(order, &mesh, FOREDRAW_LOOKAHEAD_BALANCED, FOREDRAW_LOOKAHEAD_ROBUST, 0);
 *   if (status == FOREDRAW_DONE) status = foredraw_reorder_triangles(ordered, &mesh, order);
 *   if (status != FOREDRAW_DONE) puts(foredraw_status_text(status));
 *
 * - All input is checked; status.h has what may be wrong. What is refused leaves the output as it was, unless a
 * function says otherwise.
 * - The functions keep no state: several threads may call them at once on memory of their own. No exception leaves
 * them.
 * - An order is order[new] = old. Corners of a triangle are never rotated.
 * - The same input gives the same output on every machine.
 * - Outputs are the caller's arrays, aligned as their types are, and apart from the inputs. */
#ifndef FOREDRAW_C_FUNCTIONS_H
#define FOREDRAW_C_FUNCTIONS_H

#include <foredraw/c/instances.h>
#include <foredraw/c/mesh.h>
#include <foredraw/c/simplification.h>
#include <foredraw/c/sprites.h>
#include <foredraw/c/status.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Orders of triangles; each writes index_count / 3 numbers. An option of 0 means the default. */

/* For a FIFO vertex cache of `cache_size` entries, 3 or more (16). The fastest.
 * Sander, Nehab and Barczak: Fast Triangle Reordering for Vertex Locality and Reduced Overdraw, SIGGRAPH 2007,
 * section 3. */
int foredraw_tipsify(uint32_t* order, const foredraw_triangles* triangles, uint32_t cache_size);

/* For caches of any kind up to about `cache_size` entries, 3 to 64 (32).
 * Forsyth: Linear-Speed Vertex Cache Optimisation, 2006. */
int foredraw_forsyth(uint32_t* order, const foredraw_triangles* triangles, uint32_t cache_size);

enum { FOREDRAW_LOOKAHEAD_FAST = 1, FOREDRAW_LOOKAHEAD_BALANCED, FOREDRAW_LOOKAHEAD_HIGH };
enum {
  FOREDRAW_LOOKAHEAD_ROBUST = 1, /* a FIFO of `cache_size`, and no worse than tipsify in others */
  FOREDRAW_LOOKAHEAD_FIFO,       /* a FIFO of `cache_size` alone */
  FOREDRAW_LOOKAHEAD_NVIDIA,     /* batches as these GPUs shade them */
  FOREDRAW_LOOKAHEAD_AMD,
  FOREDRAW_LOOKAHEAD_INTEL
};
/* The fewest misses: fans are drawn on trial. `quality` and `target`: of the enums above (BALANCED, ROBUST);
 * `cache_size`: 3 to 256 (16). */
int foredraw_lookahead(uint32_t* order, const foredraw_triangles* triangles, int quality, int target,
                       uint32_t cache_size);

enum { FOREDRAW_OCCLUSION_FAST = 1, FOREDRAW_OCCLUSION_BALANCED, FOREDRAW_OCCLUSION_HIGH };
/* Draws first what hides most, as seen from 80 sides: least is then shaded that something nearer hides later. The
 * triangles as they stand should suit the vertex cache (foredraw_lookahead): they are moved in small groups, and the
 * misses of a FIFO cache of `cache_size` entries, 3 to 65535 (16), become at most `acmr_budget` times as many, at least
 * 1 (1.05). Where nothing can be gained the order is the one there is. `quality`: of the enum above (BALANCED).
 * `shows_back_faces`: 0 or 1. What would take more than 256 MB of layers is FOREDRAW_TOO_LARGE. */
int foredraw_occlusion_order(uint32_t* order, const foredraw_triangles* triangles, const foredraw_positions* positions,
                             int quality, double acmr_budget, uint32_t cache_size, int shows_back_faces);

/* Clusters: ranges of the triangles as they stand, which overdraw orders move as wholes. */

/* Cuts the triangles where that costs few misses in a FIFO cache of `cache_size` entries, 3 or more (16). Cluster c
 * holds the triangles offsets[c] to offsets[c + 1] - 1. `offsets` has room for index_count / 3 + 1 numbers, of which
 * *cluster_count + 1 are written. `growth`: how many times a patch's own misses per triangle a cluster may have, at
 * least 1 (1.05). Sander, Nehab and Barczak 2007, section 4. */
int foredraw_linear_clusters(uint32_t* offsets, uint32_t* cluster_count, const foredraw_triangles* triangles,
                             uint32_t cache_size, double growth);

/* The sequence of the clusters, sequence[new] = old, that draws outward faces first, so that what they hide is not
 * shaded. Sander, Nehab and Barczak 2007, section 5. */
int foredraw_dot_rule(uint32_t* sequence, const foredraw_triangles* triangles, const foredraw_positions* positions,
                      const uint32_t* offsets, uint32_t cluster_count);

/* The order of the triangles in which the clusters are drawn in that sequence; offsets[cluster_count] numbers. */
int foredraw_order_of_clusters(uint32_t* order, const uint32_t* offsets, uint32_t cluster_count,
                               const uint32_t* sequence);

/* The order of the vertices by first use. Those that no triangle uses come last; *used_count, if not NULL, is how many
 * others there are. `order` has room for vertex_count numbers. */
int foredraw_vertex_fetch(uint32_t* order, uint32_t* used_count, const foredraw_triangles* triangles);

/* Shells, for passes that draw back faces alone. */

enum {
  FOREDRAW_SHELL_CLOSED = 0, /* and right side out: who stands outside sees no back face before a front one */
  FOREDRAW_SHELL_OPEN,       /* an edge stands more often one way than the other */
  FOREDRAW_SHELL_FLAT,       /* its walls lie on each other */
  FOREDRAW_SHELL_INSIDE_OUT, /* it shows its backs */
  FOREDRAW_SHELL_TURNED      /* a part of it shows its back: it passes through itself, or is partly inside out */
};

/* Of each triangle what its shell is: index_count / 3 numbers of the enum above. Triangles of closed ones, put first in
 * their draw, are what a second depth pass draws. Vertices at one position are one. Triangles with a position that is
 * not finite are open. */
int foredraw_shell_kinds(uint8_t* kinds, const foredraw_triangles* triangles, const foredraw_positions* positions);

/* Orders applied. */

/* The indices in that order of their triangles, with as many bytes each as they have. */
int foredraw_reorder_triangles(void* reordered, const foredraw_triangles* triangles, const uint32_t* order);

/* The indices after their vertices took that order, with as many bytes each as they have. */
int foredraw_renumber_vertices(void* renumbered, const foredraw_triangles* triangles, const uint32_t* order);

/* `count` elements of `bytes` bytes each, one behind the other, in that order: vertices of a buffer, say. `order` may
 * name fewer than there are, and each once at most: the first `count` of *used_count. */
int foredraw_reorder_elements(void* reordered, const void* elements, uint64_t element_count, uint32_t bytes,
                              const uint32_t* order, uint64_t count);

/* The indices after their vertices went there, as foredraw_weld() says it, with as many bytes each as they have. */
int foredraw_move_vertices(void* moved, const foredraw_triangles* triangles, const uint32_t* destination);

/* Meshes made smaller. */

/* Makes one of vertices that are equal in every byte of all `attribute_count` attributes, 1 or more. The first of
 * equals stays; those that no triangle uses go, unless `keep_unused` is 1. destination[old] = new, or 0xffffffff where
 * one goes: vertex_count numbers. kept[new] = old, as foredraw_reorder_elements() takes it: room for vertex_count,
 * *kept_count are written; may be NULL. */
int foredraw_weld(uint32_t* destination, uint32_t* kept, uint32_t* kept_count, const foredraw_triangles* triangles,
                  const foredraw_attribute* attributes, uint32_t attribute_count, int keep_unused);

/* Figures. */

typedef struct foredraw_overdraw_figures {
  uint64_t shaded;   /* fragments that pass the depth test, over all views */
  uint64_t visible;  /* fragments that stay */
  uint64_t ties;     /* fragments equally near as what was there before them */
  double ratio;      /* shaded / visible: 1 at best; 0 where nothing is seen */
  double error;      /* its standard error, which the choice of views leaves */
  double worst_view; /* the highest ratio of a view */
} foredraw_overdraw_figures;

/* What is drawn of the triangles as they stand and does not stay, by drawing them from `view_count` sides all round, 1
 * to 100000 (100), into pictures of `size` x `size` pixels, 16 to 4096 (256). `shows_back_faces`: 0 or 1. */
int foredraw_overdraw(foredraw_overdraw_figures* figures, const foredraw_triangles* triangles,
                      const foredraw_positions* positions, uint32_t view_count, uint32_t size, int shows_back_faces);

typedef struct foredraw_surface_error_figures {
  double largest;        /* proved: no point of either surface is farther from the other, a float's precision aside */
  double found;          /* a point is so far away */
  double rms, rms_error; /* root of the mean square, both ways, by area; its standard error */
  double mean, mean_error;
  double p99, p99_error; /* 99 of 100 points are no farther */
} foredraw_surface_error_figures;

/* How far a surface lies from the one that it stands for, in units of the positions. `samples`: points on each of them,
 * 1 to 100000000 (10000); `seed`: of these. FOREDRAW_NO_TRANSFORM where one of them, and not the other, has no triangle
 * with finite positions. */
int foredraw_surface_error(foredraw_surface_error_figures* figures, const foredraw_triangles* changed,
                           const foredraw_positions* changed_positions, const foredraw_triangles* original,
                           const foredraw_positions* original_positions, uint32_t samples, uint64_t seed);

typedef struct foredraw_vertex_cache_figures {
  uint64_t misses;   /* vertices shaded */
  uint64_t vertices; /* different ones that the triangles use */
  double acmr;       /* misses a triangle: .5 at best on large closed meshes, 3 at worst; 0 where there are none */
  double atvr;       /* misses a vertex that is used: 1 at best; 0 where there are none */
} foredraw_vertex_cache_figures;

/* What a FIFO cache of `cache_size` entries, 1 to 65535 (16), makes of the triangles as they stand. */
int foredraw_vertex_cache(foredraw_vertex_cache_figures* figures, const foredraw_triangles* triangles,
                          uint32_t cache_size);

#ifdef __cplusplus
}
#endif

#endif
