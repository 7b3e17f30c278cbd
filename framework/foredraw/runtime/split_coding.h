/* How a vertex split is written and read. C99, no allocation; progressive_stream.h reads whole streams with it.
 *
 * Hoppe: Progressive Meshes, SIGGRAPH 1996, section 3. Of a split is written: which triangles of the point go to the
 * new one; where new triangles close the gap; how far the new point lies from where its neighbours would have it; and
 * what its vertices have. All is reckoned in whole numbers, so that readers and writers agree on every machine.
 */
#ifndef FOREDRAW_RUNTIME_SPLIT_CODING_H
#define FOREDRAW_RUNTIME_SPLIT_CODING_H

#include <foredraw/runtime/triangle_coding.h>

/* How far the new point lies along the way to neighbours, of 64, by how many triangles it takes: the mean of those that
 * keep triangles of both, of those that are all its own, and of those that stay with the old point. Least squares on
 * camelhead, cheburashka, face, fertility, homer, lion, ogre and rocker-arm. */
static const int32_t foredraw_split_weights[7][3] = {{0, 0, 0},   {37, 0, -7},  {22, 16, -7}, {17, 21, -10},
                                                     {3, 29, -6}, {-5, 25, -7}, {-5, 25, -5}};

/* A split while it is worked on. */
typedef struct foredraw_split_state {
  uint32_t old_point, new_point;
  foredraw_star star;
  uint8_t moved[FOREDRAW_STAR];
  uint32_t moved_count;
  uint32_t old_vertex[FOREDRAW_STAR], new_vertex[FOREDRAW_STAR], pairs; /* of the two points */
} foredraw_split_state;

static inline uint32_t foredraw_partner(const foredraw_split_state* split, uint32_t old_vertex) {
  uint32_t i;
  for (i = 0; i < split->pairs; ++i)
    if (split->old_vertex[i] == old_vertex) return split->new_vertex[i];
  return FOREDRAW_NONE;
}

/* The corner goes to the new point. */
static inline void foredraw_move_corner(foredraw_split_coding* s, foredraw_split_state* split, uint32_t corner) {
  foredraw_split_mesh* mesh = &s->mesh;
  const uint32_t old = mesh->indices[corner], expected = foredraw_partner(split, old);
  const uint32_t vertex = foredraw_code_vertex(s, split->new_point, mesh->draw_part[mesh->draw[corner / 3]], expected,
                                               0, s->wanted ? s->wanted->corner_names[corner] : 0);
  if (expected == FOREDRAW_NONE && split->pairs < FOREDRAW_STAR) {
    split->old_vertex[split->pairs] = old;
    split->new_vertex[split->pairs++] = vertex;
  }
  foredraw_put_corner(mesh, corner, split->new_point, vertex);
  ++split->moved_count;
}

static inline uint64_t foredraw_squared_length(const foredraw_split_mesh* mesh, uint32_t a, uint32_t b) {
  uint64_t sum = 0;
  uint32_t k;
  for (k = 0; k < 3; ++k) {
    const int64_t apart = (int64_t)mesh->point[a].place[k] - mesh->point[b].place[k];
    sum += (uint64_t)(apart * apart);
  }
  return sum;
}

/* Which triangles go to the new point. They lie side by side, mostly, and are the larger ones, as they reach over what
 * the point took in. So it begins at the smallest one, and expects by size, by whether they have begun or ended, and by
 * how many there still are. */
static inline void foredraw_code_star(foredraw_split_coding* s, foredraw_split_state* split) {
  const foredraw_star* star = &split->star;
  uint64_t size[FOREDRAW_STAR], total = 0, mean;
  uint32_t i, k, begin = 0, state = 0, run = 0;
  for (i = 0; i < star->count; ++i) size[i] = foredraw_squared_length(&s->mesh, split->old_point, star->from[i]);
  {
    const uint64_t first = star->count > 0 ? size[0] : 0;
    for (i = 0; i < star->count; ++i) {
      if (i + 1 < star->count && star->from[i + 1] == star->to[i]) {
        size[i] += size[i + 1];
      } else {
        size[i] += star->is_ring ? first : foredraw_squared_length(&s->mesh, split->old_point, star->to[i]);
      }
      total += size[i];
    }
  }
  mean = star->count > 0 ? total / star->count : 0;
  for (i = 1; i < star->count && star->is_ring; ++i)
    if (size[i] < size[begin]) begin = i;
  for (k = 0; k < star->count; ++k) {
    uint32_t of_size, bit;
    i = begin + k < star->count ? begin + k : begin + k - star->count;
    of_size = (uint32_t)((8 * size[i] > 3 * mean) + (8 * size[i] > 5 * mean) + (8 * size[i] > 6 * mean) +
                         (8 * size[i] > 8 * mean) + (8 * size[i] > 10 * mean) + (8 * size[i] > 13 * mean) +
                         (8 * size[i] > 17 * mean));
    bit = foredraw_code_bit(&s->coder,
                            &s->models->moves[state][foredraw_least_of(star->count - 1 - k, 7)][of_size]
                                             [state == 1 ? foredraw_least_of(run, 7) : (uint32_t)star->is_ring],
                            s->wanted ? s->wanted->moves[star->corner[i] / 3] : 0);
    split->moved[i] = (uint8_t)bit;
    if (bit) {
      state = 1;
      ++run;
    } else if (state == 1) {
      state = 2;
    }
  }
  s->mesh.point[split->old_point].size = s->mesh.point[split->new_point].size = foredraw_bit_count(mean);
}

/* A point of the link, and the star's triangles before and behind it; none at a border. */
typedef struct foredraw_link_point {
  uint32_t point, before, behind;
} foredraw_link_point;

static inline uint32_t foredraw_link_of(const foredraw_star* star, foredraw_link_point* link) {
  uint32_t i, count = 0;
  for (i = 0; i < star->count; ++i) {
    const int joins = i > 0 && star->from[i] == star->to[i - 1];
    const foredraw_link_point at = {star->from[i], joins ? i - 1 : (star->is_ring ? star->count - 1 : FOREDRAW_NONE),
                                    i};
    link[count++] = at;
    if (!star->is_ring && (i + 1 == star->count || star->from[i + 1] != star->to[i])) {
      const foredraw_link_point last = {star->to[i], i, FOREDRAW_NONE};
      link[count++] = last;
    }
  }
  return count;
}

/* The wanted triangle of these points in that sequence, and at which of them it begins. */
static inline foredraw_wanted_triangle* foredraw_find_wanted(const foredraw_wanted* wanted, const uint32_t* points,
                                                             uint32_t* turn) {
  uint32_t i;
  for (i = 0; i < wanted->added_count; ++i) {
    const uint32_t* other = wanted->added[i].points;
    if (wanted->added[i].number != FOREDRAW_NONE) continue;
    for (*turn = 0; *turn < 3; ++*turn)
      if (other[*turn] == points[0] && other[(*turn + 1) % 3] == points[1] && other[(*turn + 2) % 3] == points[2])
        return &wanted->added[i];
  }
  return NULL;
}

/* Where triangles of both points meet, and at borders, a new triangle may close the gap. */
static inline void foredraw_close_gap(foredraw_split_coding* s, const foredraw_split_state* split,
                                      const uint32_t* old_vertices, const foredraw_link_point* at) {
  const foredraw_star* star = &split->star;
  const int before = at->before != FOREDRAW_NONE ? split->moved[at->before] : !split->moved[at->behind];
  const int behind = at->behind != FOREDRAW_NONE ? split->moved[at->behind] : !before;
  const uint32_t stays = behind ? at->before : at->behind, moves = behind ? at->behind : at->before;
  const uint32_t is_border = at->before == FOREDRAW_NONE || at->behind == FOREDRAW_NONE;
  const uint32_t near = stays != FOREDRAW_NONE ? stays : moves;
  const uint32_t points[3] = {behind ? split->old_point : split->new_point, at->point,
                              behind ? split->new_point : split->old_point};
  uint32_t expected[3], turn = 0;
  foredraw_wanted_triangle* wanted = NULL;
  if (before == behind) return;
  if (s->wanted) wanted = foredraw_find_wanted(s->wanted, points, &turn);
  if (!foredraw_code_bit(&s->coder, &s->models->closes[is_border], wanted != NULL)) return;
  expected[behind ? 0 : 2] = old_vertices[near];
  expected[1] = s->mesh.indices[near == at->behind ? foredraw_next_in_triangle(star->corner[near])
                                                   : foredraw_last_in_triangle(star->corner[near])];
  expected[behind ? 2 : 0] =
      moves != FOREDRAW_NONE ? s->mesh.indices[star->corner[moves]] : foredraw_partner(split, old_vertices[near]);
  foredraw_add_triangle(s, points, expected, s->mesh.draw[star->corner[near] / 3], wanted, turn);
}

/* Triangles of both points and of one that is no neighbour on such a border: where more than two meet at an edge, at
 * points with very many, and where the point had none. */
static inline void foredraw_code_more(foredraw_split_coding* s, const foredraw_split_state* split) {
  uint32_t i = 0, turn = 0, third = 0, old_first = 0;
  for (;;) {
    uint32_t points[3], expected[3], k;
    foredraw_wanted_triangle* wanted = NULL;
    for (; s->wanted && i < s->wanted->added_count && wanted == NULL; ++i)
      if (s->wanted->added[i].number == FOREDRAW_NONE) wanted = &s->wanted->added[i];
    if (!foredraw_code_bit(&s->coder, &s->models->has_more, wanted != NULL)) return;
    if (wanted) {
      for (turn = 0; wanted->points[turn] == split->old_point || wanted->points[turn] == split->new_point;) ++turn;
      third = wanted->points[turn];
      old_first = wanted->points[(turn + 1) % 3] == split->old_point;
    }
    third = (uint32_t)foredraw_code_number(&s->coder, &s->models->which, (int32_t)third);
    old_first = foredraw_code_bit(&s->coder, &s->models->turns, old_first);
    if (third >= s->mesh.points || third == split->old_point || third == split->new_point) s->damaged = 1;
    if (s->damaged || s->coder.failed) return;
    points[0] = third;
    points[1] = old_first ? split->old_point : split->new_point;
    points[2] = old_first ? split->new_point : split->old_point;
    for (k = 0; k < 3; ++k) expected[k] = s->mesh.point[points[k]].first_vertex;
    foredraw_add_triangle(s, points, expected, 0, wanted, turn);
    if (s->damaged) return;
  }
}

/* Where the new point is expected: a mean of its neighbours. Two of its coordinates are written beside that; the third,
 * along which the surface rises least, beside the plane of the new point's triangles. */
static inline void foredraw_code_place(foredraw_split_coding* s, const foredraw_split_state* split,
                                       const foredraw_link_point* link, uint32_t link_count) {
  foredraw_split_mesh* mesh = &s->mesh;
  const foredraw_star* star = &split->star;
  const int32_t* old = mesh->point[split->old_point].place;
  int32_t* place = mesh->point[split->new_point].place;
  const int32_t* weights = foredraw_split_weights[foredraw_least_of(split->moved_count, 6)];
  int64_t sums[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, normal[3] = {0, 0, 0}, shares[3], slope = 0, height = 0, most;
  int32_t counts[3] = {0, 0, 0};
  uint32_t i, k, steep = 0, of_height = 0;
  const uint32_t of_size = foredraw_least_of(mesh->point[split->old_point].size, 63);
  for (i = 0; i < link_count; ++i) {
    const int before = link[i].before == FOREDRAW_NONE ? -1 : split->moved[link[i].before];
    const int behind = link[i].behind == FOREDRAW_NONE ? before : split->moved[link[i].behind];
    const int whose = before >= 0 && before != behind ? 0 : behind ? 1 : 2;
    ++counts[whose];
    for (k = 0; k < 3; ++k) sums[whose][k] += mesh->point[link[i].point].place[k] - old[k];
  }
  for (i = 0; i < star->count; ++i) {
    int64_t a[3], b[3];
    if (!split->moved[i]) continue;
    for (k = 0; k < 3; ++k) {
      a[k] = mesh->point[star->from[i]].place[k] - old[k];
      b[k] = mesh->point[star->to[i]].place[k] - old[k];
    }
    for (k = 0; k < 3; ++k) normal[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  }
  for (k = 1; k < 3; ++k)
    if ((normal[k] < 0 ? -normal[k] : normal[k]) > (normal[steep] < 0 ? -normal[steep] : normal[steep])) steep = k;
  for (most = normal[steep]; most > INT32_MAX || most < -INT32_MAX; most /= 2)
    for (k = 0; k < 3; ++k) normal[k] /= 2;
  if (normal[steep] != 0) {
    for (k = 0; k < 3; ++k)
      height += normal[k] * ((sums[0][k] + sums[1][k] + sums[2][k]) / (counts[0] + counts[1] + counts[2]));
    height /= normal[steep];
    of_height = foredraw_bit_count((uint64_t)(height < 0 ? -height : height));
  }
  for (k = 0; k < 3; ++k) shares[k] = counts[k] > 0 ? (int64_t)weights[k] * (65536 / counts[k]) : 0;
  for (i = 0; i < 3; ++i) {
    const uint32_t axis = (steep + 1 + i) % 3, kind = i < 2 ? of_size : foredraw_least_of(of_height, 63);
    int64_t expected = 0, value;
    int32_t beside;
    for (k = 0; k < 3; ++k) expected += shares[k] * sums[k][axis];
    expected = old[axis] + expected / (64 * 65536);
    if (i == 2 && normal[steep] != 0) expected -= slope / normal[steep];
    beside = foredraw_code_number(&s->coder, &s->models->place[i][kind],
                                  s->wanted ? (int32_t)(s->wanted->place[axis] - expected) : 0);
    value = expected + beside;
    if (value < 0 || value >= (int64_t)mesh->grid) {
      s->damaged = 1;
      return;
    }
    place[axis] = (int32_t)value;
    slope += normal[axis] * beside;
  }
}

/* Numbers of a new vertex beside the mean of its neighbours', of those that were there. */
static inline void foredraw_code_values(foredraw_split_coding* s, uint32_t vertex, uint32_t first_new) {
  foredraw_split_mesh* mesh = &s->mesh;
  const uint32_t part = mesh->vertex[vertex].part, width = mesh->width;
  uint32_t neighbours[2 * FOREDRAW_STAR], count = 0, corner, i, k;
  corner = mesh->part[part].count > 0 ? mesh->point[mesh->vertex[vertex].point].first_corner : FOREDRAW_NONE;
  for (; corner != FOREDRAW_NONE && count + 2 <= 2 * FOREDRAW_STAR; corner = mesh->corner[corner].next) {
    if (mesh->indices[corner] != vertex) continue;
    for (k = 1; k < 3; ++k) {
      const uint32_t other = mesh->indices[corner - corner % 3 + (corner + k) % 3];
      if (other < first_new && mesh->vertex[other].part == part) neighbours[count++] = other;
    }
  }
  for (i = 0; i < mesh->part[part].count; ++i) {
    int64_t sum = 0;
    for (k = 0; k < count; ++k) sum += mesh->values[(size_t)width * neighbours[k] + i];
    foredraw_code_value(s, vertex, i, (int32_t)(count > 0 ? sum / (int64_t)count : 0));
  }
}

/* The point becomes two. There must be room for a point. */
static inline void foredraw_code_split(foredraw_split_coding* s, uint32_t old_point) {
  foredraw_split_mesh* mesh = &s->mesh;
  foredraw_split_state split;
  foredraw_link_point link[2 * FOREDRAW_STAR];
  uint32_t old_vertices[FOREDRAW_STAR], i, corner = mesh->point[old_point].first_corner, link_count = 0, bit = 0;
  const uint32_t first_vertex = mesh->vertices;
  const int is_crowd = mesh->point[old_point].valence > FOREDRAW_STAR;
  if (mesh->point[old_point].valence >= s->budget) {
    s->damaged = 1;
    return;
  }
  s->budget -= mesh->point[old_point].valence;
  split.old_point = old_point;
  split.new_point = foredraw_add_point(mesh);
  split.moved_count = split.pairs = split.star.count = 0;
  for (; corner != FOREDRAW_NONE && !is_crowd; corner = mesh->corner[corner].next) {
    split.star.corner[split.star.count] = corner;
    split.star.from[split.star.count] = mesh->corner[foredraw_next_in_triangle(corner)].point;
    split.star.to[split.star.count++] = mesh->corner[foredraw_last_in_triangle(corner)].point;
  }
  foredraw_order_star(&split.star);
  foredraw_code_star(s, &split);
  mesh->point[old_point].first_corner = FOREDRAW_NONE;
  mesh->point[old_point].valence = 0;
  for (i = 0; i < split.star.count; ++i) {
    old_vertices[i] = mesh->indices[split.star.corner[i]];
    if (split.moved[i]) {
      foredraw_move_corner(s, &split, split.star.corner[i]);
    } else {
      foredraw_put_corner(mesh, split.star.corner[i], old_point, old_vertices[i]);
    }
  }
  while (corner != FOREDRAW_NONE) { /* of a crowd: in the sequence in which they are held */
    const uint32_t next = mesh->corner[corner].next;
    bit = foredraw_code_bit(&s->coder, &s->models->crowd[bit], s->wanted ? s->wanted->moves[corner / 3] : 0);
    if (bit) {
      foredraw_move_corner(s, &split, corner);
    } else {
      foredraw_put_corner(mesh, corner, old_point, mesh->indices[corner]);
    }
    corner = next;
  }
  link_count = foredraw_link_of(&split.star, link);
  for (i = 0; i < link_count && !s->damaged; ++i) foredraw_close_gap(s, &split, old_vertices, &link[i]);
  if (!s->damaged) foredraw_code_more(s, &split);
  if (!s->damaged) foredraw_code_place(s, &split, link, link_count);
  for (i = first_vertex; i < mesh->vertices && !s->damaged; ++i) foredraw_code_values(s, i, first_vertex);
}

#endif
