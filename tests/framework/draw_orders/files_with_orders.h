#pragma once
// Scenes with orders and tables, and files that hold them.

#include "framework/io/gltf/edits.h"
#include "support/compressed_gltf.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace foredraw::testing {

inline constexpr const char* draw_orders_extension = "FOREDRAW_draw_orders";

/// A file to be changed; more bytes may be added to its buffer.
inline GltfBuilder opened(const Bytes& glb) {
  GltfBuilder builder = builder_of(glb);
  builder.json.erase("buffers");
  return builder;
}

/// The triangles in an order that is neither rising nor falling.
inline Indices stirred(std::size_t triangles, std::size_t step) {
  Indices order;
  for (std::size_t first = 0; first < step; ++first) {
    for (std::size_t t = first; t < triangles; t += step) order.push_back(static_cast<std::uint32_t>(t));
  }
  return order;
}

inline void add_orders(Draw& draw) {
  IndexStream& first = draw.levels[0].orders[0];
  const std::size_t triangles = first.triangle_count();
  Indices backwards = stirred(triangles, 1);
  std::ranges::reverse(backwards);
  const IndexStream alone = first;
  draw.levels[0].orders = {alone, with_triangle_order(alone, backwards),
                           with_triangle_order(alone, stirred(triangles, 2))};
}

inline std::vector<OrderTable> tables_of(const Scene& scene) {
  const auto tables = order_tables(scene);
  return {tables.begin(), tables.end()};
}

/// A puppet with three orders and a table of its clip.
inline Scene puppet_with_orders(const Bytes& file) {
  Scene scene = read(file);
  for (Draw& draw : scene.draws) add_orders(draw);
  OrderTable table;
  for (DrawId id = 0; id < scene.draws.size(); ++id) table.draws.push_back(id);
  table.clips = {{scene.animations[0].name.empty() ? "animation0" : scene.animations[0].name, {0, 0.1f, 2}}};
  table.theta_steps = 2;
  table.phi_steps = 3;
  table.order = {0, 1, 2, 0, 1, 2, 1, 1, 1, 1, 1, 0, 2, 2, 2, 0, 0, 1};
  scene.products.set(DrawOrders{{table}});
  return scene;
}

inline Scene puppet_with_orders() { return puppet_with_orders(puppet().glb()); }

inline void expect_same_orders(const Scene& again, const Scene& scene) {
  ASSERT_EQ(again.draws.size(), scene.draws.size());
  EXPECT_EQ(tables_of(again), tables_of(scene));
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    const auto& now = again.draws[d].levels[0].orders;
    const auto& wanted = scene.draws[d].levels[0].orders;
    ASSERT_EQ(now.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(now[i].indices, wanted[i].indices) << d << ' ' << i;
  }
}

/// Two draws in three orders, each with a sequence of its own.
inline Scene two_in_sequence() {
  Scene scene = scene_of({draw_of(torus(8, 6), "ring"), draw_of(soup(5, 1), "soup")});
  for (Draw& draw : scene.draws) add_orders(draw);
  OrderTable table{{0, 1}, {}, 1, 3, {0, 2, 1}};
  table.parts = {{0, 0}, {1, 1}};
  table.sequences = {0, 1, 1, 0, 0, 1};
  scene.products.set(DrawOrders{{table}});
  return scene;
}

}  // namespace foredraw::testing
