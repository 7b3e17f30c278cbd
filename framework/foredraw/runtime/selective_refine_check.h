/* Whether arrays for selective_refine.h that come from elsewhere are what that header trusts. C99, no allocation; once,
 * when they are loaded.
 *
 *   const foredraw_refine_arrays arrays = {point, vertex_count, point_count, patch_count, need_count,
 *                                          border_count};
 *   uint32_t* memory = malloc(sizeof(uint32_t) * foredraw_refine_check_words(&mesh, &arrays));
 *   const char* mistake = foredraw_refine_check(&mesh, &arrays, memory);
 *   if (mistake) ...
 *
 * All splits are done from the base to full detail, and each is looked at where it is done; full detail has to have as
 * many borders as is told. Whatever is drawn is full detail with some points in the place of others, so that it has no
 * cracks then, whichever splits are done, and no number leads out of the arrays. Balls and normals are not looked at:
 * they only say what a view wants. Nor is which side of a triangle is its front.
 */
#ifndef FOREDRAW_RUNTIME_SELECTIVE_REFINE_CHECK_H
#define FOREDRAW_RUNTIME_SELECTIVE_REFINE_CHECK_H

#include <foredraw/runtime/selective_refine.h>

/* What is not in a foredraw_refine_mesh, and how many of each there are. */
typedef struct foredraw_refine_arrays {
  const uint32_t* point; /* [vertex] that it is of */
  uint32_t vertices;
  uint32_t points; /* above all their numbers */
  uint32_t patches;
  uint32_t needs;
  uint32_t borders; /* edges of full detail, from point to point, that an odd number of triangles has */
} foredraw_refine_arrays;

typedef struct foredraw_refine_checker {
  const foredraw_refine_mesh* mesh;
  const foredraw_refine_arrays* arrays;
  uint32_t* corners; /* [corner] its vertex, so far */
  uint32_t* next;    /* [corner] another one at its point, or `none` */
  uint32_t* first;   /* [point] */
  uint32_t* is_odd;  /* [point] */
  uint32_t none;
} foredraw_refine_checker;

static inline size_t foredraw_refine_check_words(const foredraw_refine_mesh* mesh,
                                                 const foredraw_refine_arrays* arrays) {
  return 6 * (size_t)mesh->triangles + 2 * (size_t)arrays->points;
}

static inline uint32_t foredraw_refine_point(const foredraw_refine_checker* check, uint32_t corner) {
  return check->arrays->point[check->corners[corner]];
}

/* The split that adds the triangle; split_count: it is of the base. */
static inline uint32_t foredraw_refine_adds(const foredraw_refine_mesh* mesh, uint32_t triangle) {
  uint32_t few = 0, many = mesh->split_count;
  if (triangle < mesh->splits[0].triangles) return many;
  while (many - few > 1) {
    const uint32_t middle = few + (many - few) / 2;
    if (mesh->splits[middle].triangles <= triangle) {
      few = middle;
    } else {
      many = middle;
    }
  }
  return few;
}

static inline int foredraw_refine_needs(const foredraw_refine_mesh* mesh, uint32_t split, uint32_t other) {
  uint32_t few = mesh->nodes[split].first_need, many = mesh->nodes[split + 1].first_need;
  const uint32_t end = many;
  if (other >= mesh->split_count) return 1; /* the base is always there */
  while (few < many) {
    const uint32_t middle = few + (many - few) / 2;
    if (mesh->needs[middle] < other) {
      few = middle + 1;
    } else {
      many = middle;
    }
  }
  return few < end && mesh->needs[few] == other;
}

static inline const char* foredraw_refine_check_counts(const foredraw_refine_checker* check) {
  const foredraw_refine_mesh* mesh = check->mesh;
  const uint32_t splits = mesh->split_count;
  uint32_t i;
  if (mesh->triangles > UINT32_MAX / 3 || splits == UINT32_MAX) return "there are too many";
  if (check->arrays->points < splits) return "there are fewer points than splits";
  if (mesh->splits[0].first_patch != 0 || mesh->nodes[0].first_need != 0) return "the first split does not begin at 0";
  for (i = 0; i < splits; ++i) {
    if (mesh->splits[i].triangles > mesh->splits[i + 1].triangles ||
        mesh->splits[i].first_patch > mesh->splits[i + 1].first_patch ||
        mesh->nodes[i].first_need > mesh->nodes[i + 1].first_need)
      return "counts fall from a split to the next one";
  }
  if (mesh->splits[splits].triangles != mesh->triangles || mesh->splits[splits].first_patch != check->arrays->patches ||
      mesh->nodes[splits].first_need != check->arrays->needs)
    return "counts do not end at those of the arrays";
  for (i = 0; i < check->arrays->vertices; ++i) {
    if (check->arrays->point[i] >= check->arrays->points) return "a vertex belongs to no point";
  }
  for (i = 0; i < 3 * mesh->triangles; ++i) {
    if (mesh->corners[i] >= check->arrays->vertices) return "a corner names no vertex";
  }
  return NULL;
}

/* Which list the split is in. */
static inline uint32_t foredraw_refine_parent(const foredraw_refine_mesh* mesh, uint32_t split) {
  const uint32_t point = split < mesh->split_count ? mesh->nodes[split].point : mesh->split_count;
  return point < mesh->split_count ? point : mesh->split_count;
}

/* Each split is in the list of its parent, once: links lead to later splits of the same parent, and one to each. */
static inline const char* foredraw_refine_check_tree(const foredraw_refine_checker* check) {
  const foredraw_refine_mesh* mesh = check->mesh;
  const uint32_t splits = mesh->split_count;
  uint32_t* linked = check->first; /* not used yet */
  uint32_t i, k, links = 0;
  for (i = 0; i < splits; ++i) {
    linked[i] = 0;
    if (mesh->nodes[i].point >= check->arrays->points) return "a split splits no point";
    if (mesh->nodes[i].point < splits && mesh->nodes[i].point >= i) return "a parent does not come before its child";
  }
  for (i = 0; i <= splits; ++i) {
    const foredraw_refine_node* node = mesh->nodes + i;
    const uint32_t to[2] = {node->first_child, i < splits ? node->next_sibling : splits};
    const uint32_t parent[2] = {i, foredraw_refine_parent(mesh, i)};
    for (k = 0; k < 2; ++k) {
      if (to[k] == splits) continue;
      if (to[k] > splits || (i < splits && to[k] <= i) || foredraw_refine_parent(mesh, to[k]) != parent[k] ||
          linked[to[k]]++)
        return "children are not in the list of their parent";
      ++links;
    }
  }
  if (links != splits) return "children are not in the list of their parent";
  for (i = 0; i < splits; ++i) {
    for (k = mesh->nodes[i].first_need; k < mesh->nodes[i + 1].first_need; ++k) {
      if (mesh->needs[k] >= i) return "a split needs one that does not come before it";
      if (k > mesh->nodes[i].first_need && mesh->needs[k] <= mesh->needs[k - 1])
        return "the needs of a split do not rise";
    }
    if (!foredraw_refine_needs(mesh, i, mesh->nodes[i].point)) return "a split does not need its parent";
  }
  return NULL;
}

/* How many corners of the triangle are at the point. */
static inline uint32_t foredraw_refine_count_at(const foredraw_refine_checker* check, uint32_t triangle,
                                                uint32_t point) {
  uint32_t k, count = 0;
  for (k = 3 * triangle; k < 3 * triangle + 3; ++k) count += foredraw_refine_point(check, k) == point;
  return count;
}

/* A triangle that the split adds has its point, the point that is split, and a wing, which is there. */
static inline const char* foredraw_refine_check_triangle(const foredraw_refine_checker* check, uint32_t split,
                                                         uint32_t triangle) {
  const uint32_t point = check->mesh->nodes[split].point;
  uint32_t k;
  if (foredraw_refine_count_at(check, triangle, split) != 1 || foredraw_refine_count_at(check, triangle, point) != 1)
    return "a triangle is added that does not lie at the split edge";
  for (k = 3 * triangle; k < 3 * triangle + 3; ++k) {
    const uint32_t wing = foredraw_refine_point(check, k);
    if (wing != split && !foredraw_refine_needs(check->mesh, split, wing)) return "a split does not need its wing";
  }
  return NULL;
}

static inline const char* foredraw_refine_check_patch(foredraw_refine_checker* check, uint32_t split,
                                                      const foredraw_patch* patch) {
  const foredraw_refine_mesh* mesh = check->mesh;
  const uint32_t* point = check->arrays->point;
  if (patch->corner / 3 >= mesh->splits[split].triangles) return "a patch names a triangle that is not there";
  if (patch->fine >= check->arrays->vertices || check->corners[patch->corner] != patch->coarse)
    return "a patch changes a vertex that is not there";
  if (point[patch->fine] != split || point[patch->coarse] != mesh->nodes[split].point)
    return "a patch changes another point";
  if (!foredraw_refine_needs(mesh, split, foredraw_refine_adds(mesh, patch->corner / 3)))
    return "a split does not need a triangle that it changes";
  return NULL;
}

/* How many edges an odd number of triangles has, as the corners are now. */
static inline uint32_t foredraw_refine_borders(foredraw_refine_checker* check) {
  uint32_t i, k, pass, point, count = 0;
  for (i = 0; i < check->arrays->points; ++i) {
    check->first[i] = check->none;
    check->is_odd[i] = 0;
  }
  for (i = 0; i < 3 * check->mesh->triangles; ++i) {
    const uint32_t at = foredraw_refine_point(check, i);
    check->next[i] = check->first[at];
    check->first[at] = i;
  }
  for (point = 0; point < check->arrays->points; ++point) {
    for (pass = 0; pass < 2; ++pass) { /* counts the triangles of each edge, then looks which counts are odd */
      for (i = check->first[point]; i != check->none; i = check->next[i]) {
        for (k = i / 3 * 3; k < i / 3 * 3 + 3; ++k) {
          const uint32_t other = foredraw_refine_point(check, k);
          if (other <= point) continue;
          count += pass & check->is_odd[other];
          check->is_odd[other] = pass ? 0 : !check->is_odd[other];
        }
      }
    }
  }
  return count;
}

static inline const char* foredraw_refine_check_split(foredraw_refine_checker* check, uint32_t split) {
  const foredraw_split* record = check->mesh->splits + split;
  const char* mistake;
  uint32_t i;
  for (i = record[0].triangles; i < record[1].triangles; ++i) {
    mistake = foredraw_refine_check_triangle(check, split, i);
    if (mistake) return mistake;
  }
  for (i = record[0].first_patch; i < record[1].first_patch; ++i) {
    const foredraw_patch* patch = check->mesh->patches + i;
    mistake = foredraw_refine_check_patch(check, split, patch);
    if (mistake) return mistake;
    check->corners[patch->corner] = patch->fine;
  }
  return NULL;
}

/* NULL, or what is wrong. `memory` holds foredraw_refine_check_words() numbers, and is not needed afterwards. */
static inline const char* foredraw_refine_check(const foredraw_refine_mesh* mesh, const foredraw_refine_arrays* arrays,
                                                uint32_t* memory) {
  const uint32_t none = UINT32_MAX;
  foredraw_refine_checker check;
  const char* mistake;
  uint32_t i;
  check.mesh = mesh;
  check.arrays = arrays;
  check.corners = memory;
  check.next = check.corners + 3 * (size_t)mesh->triangles;
  check.first = check.next + 3 * (size_t)mesh->triangles;
  check.is_odd = check.first + arrays->points;
  check.none = none;
  mistake = foredraw_refine_check_counts(&check);
  if (!mistake) mistake = foredraw_refine_check_tree(&check);
  if (mistake) return mistake;
  for (i = 0; i < 3 * mesh->triangles; ++i) check.corners[i] = mesh->corners[i];
  for (i = 0; i < 3 * mesh->splits[0].triangles; ++i) {
    if (foredraw_refine_point(&check, i) < mesh->split_count) return "the base has a point that a split adds";
  }
  for (i = 0; i < mesh->split_count && !mistake; ++i) mistake = foredraw_refine_check_split(&check, i);
  if (mistake) return mistake;
  return foredraw_refine_borders(&check) == arrays->borders ? NULL : "full detail has other borders: a wing is wrong";
}

#endif
