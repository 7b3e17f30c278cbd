// An engine in C++17: a mesh of its own goes in, a cheaper one comes out, and how often its vertices are shaded.
#include <foredraw/c/foredraw.h>
#include <foredraw/c/functions.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

struct Free {
  void operator()(foredraw_context* context) const { foredraw_context_free(context); }
  void operator()(foredraw_scene* scene) const { foredraw_scene_free(scene); }
};
using Context = std::unique_ptr<foredraw_context, Free>;
using Scene = std::unique_ptr<foredraw_scene, Free>;

double misses(const foredraw_draw& draw) {
  const foredraw_triangles triangles{draw.indices, 3 * draw.triangle_count, 4, draw.vertex_count};
  foredraw_vertex_cache_figures figures{};
  return foredraw_vertex_cache(&figures, &triangles, 16) == FOREDRAW_DONE ? figures.acmr : -1;
}

int main() {
  constexpr std::uint32_t side = 50;
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    positions.insert(positions.end(), {static_cast<float>(i % side), static_cast<float>(i / side), 0});
    if (i % side + 1 == side || i / side + 1 == side) continue;
    indices.insert(indices.end(), {i, i + 1, i + side, i + side, i + 1, i + side + 1});
  }
  foredraw_draw draw{};
  draw.size = sizeof draw;
  draw.name = "sheet";
  draw.indices = indices.data(), draw.triangle_count = indices.size() / 3;
  draw.positions = positions.data(), draw.vertex_count = side * side;

  const Context context(foredraw_context_new(nullptr));
  foredraw_scene *made = nullptr, *optimized = nullptr;
  foredraw_text text{};
  int status = foredraw_make_scene(context.get(), &draw, 1, &made, &text);
  const Scene scene(made);
  if (status == FOREDRAW_DONE) {
    foredraw_text_free(&text);
    status = foredraw_optimize(context.get(), scene.get(), "lookahead, vertex-fetch", &optimized, &text);
  }
  const Scene cheaper(optimized);
  foredraw_draw now{};
  now.size = sizeof now;
  if (status == FOREDRAW_DONE) {
    status = foredraw_scene_draw(cheaper.get(), 0, &now);
    std::printf("%.3f -> %.3f vertices shaded for each triangle\n", misses(draw), misses(now));
  } else if (text.data != nullptr) {
    std::puts(text.data);  // what is wrong, where, and what to do about it
  }
  foredraw_text_free(&text);
  return status;
}
