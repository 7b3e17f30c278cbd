#include <foredraw/report/draw_orders.h>

#include <foredraw/scene/reorder.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

/// "432 KB", "6.5 MB": thousands, as disks and papers count.
std::string size_text(std::uint64_t bytes) {
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  double size = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  for (; size >= 999.5 && unit < 2; ++unit) size /= 1000;
  constexpr const char* units[] = {"KB", "MB", "GB"};
  return fmt::format("{:.{}f} {}", size, size < 9.95 ? 1 : 0, units[unit]);
}

/// Where the scene's meshes hold the draw.
struct Primitive {
  std::size_t mesh = 0;
  std::size_t primitive = 0;
};
Primitive primitive_of(const Scene& scene, DrawId id) {
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const auto& draws = scene.meshes[m].draws;
    const auto found = std::ranges::find(draws, id);
    if (found != draws.end()) return {m, static_cast<std::size_t>(found - draws.begin())};
  }
  throw std::invalid_argument(fmt::format("draw {} is in no mesh", id));
}

Json json_of(const Scene& scene, DrawId id) {
  const Draw& draw = scene.draws[id];
  const std::vector<IndexStream>& streams = draw.levels[0].orders;
  Json orders = Json::array();
  for (const IndexStream& stream : streams) {
    const auto order = order_between(streams[0].indices.view(), stream.indices.view());
    if (!order) throw std::invalid_argument(fmt::format("the orders of {} draw different triangles", draw.name));
    orders.push_back(*order);
  }
  const Primitive place = primitive_of(scene, id);
  return {{"name", draw.name}, {"mesh", place.mesh}, {"primitive", place.primitive}, {"orders", std::move(orders)}};
}

}  // namespace

OrderMemory memory_of(const Scene& scene, const OrderTable& table) {
  OrderMemory memory;
  std::uint64_t one = 0;
  for (const DrawId id : table.draws) {
    const Level& level = scene.draws[id].levels[0];
    memory.orders = std::max(memory.orders, level.orders.size());
    memory.triangles += level.orders[0].triangle_count();
    const std::size_t width = level.vertices->count <= 0xffff ? 2 : 4;
    one += level.orders[0].indices.size() * width;
    memory.bytes += level.orders.size() * level.orders[0].indices.size() * width;
  }
  memory.bytes_for_each_keyframe = table.keyframes() * one;
  return memory;
}

std::string memory_text(const Scene& scene, const OrderTable& table) {
  const OrderMemory memory = memory_of(scene, table);
  std::string text = fmt::format("{} {} of {} triangles: {}", memory.orders,
                                 memory.orders == 1 ? "order" : "orders", memory.triangles, size_text(memory.bytes));
  if (table.keyframes() > 1) {
    text += fmt::format("; one for each of {} keyframes would take {}", table.keyframes(),
                        size_text(memory.bytes_for_each_keyframe));
  }
  return text;
}

std::string draws_text(const Scene& scene, const OrderTable& table) {
  std::string text;
  for (const DrawId id : table.draws) text += (text.empty() ? "" : ", ") + scene.draws[id].name;
  return text;
}

std::string draw_orders_json(const Scene& scene) {
  Json json{{"draw-orders", 1}, {"file", scene.name}, {"tables", Json::array()}};
  for (const OrderTable& table : scene.order_tables) {
    Json draws = Json::array();
    for (const DrawId id : table.draws) draws.push_back(json_of(scene, id));
    Json clips = Json::array();
    for (const OrderTable::Clip& clip : table.clips) clips.push_back({{"name", clip.name}, {"times", clip.times}});
    json["tables"].push_back({{"clips", std::move(clips)},
                              {"theta-steps", table.theta_steps},
                              {"phi-steps", table.phi_steps},
                              {"order", table.order},
                              {"draws", std::move(draws)}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foredraw
