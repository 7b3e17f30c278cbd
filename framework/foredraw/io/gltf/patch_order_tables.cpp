// FOREDRAW_draw_orders, the file's part written: a table for each subject. Primitives have their orders already.
#include <foredraw/io/gltf/private/draw_orders.h>

#include <foredraw/viewing/pose_set.h>
#include <foredraw/io/gltf/private/write.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

Content scalars(Component component, std::size_t count, std::span<const std::byte> bytes) {
  const auto width = static_cast<std::uint16_t>(bytes_of(component));
  return {Content::Kind::other,
          {component, 1, false, width},
          count,
          Shared<std::byte>({bytes.begin(), bytes.end()}),
          false};
}

/// [mesh, primitive] of each of the draws.
Json primitives_of(const Scene& scene, const std::vector<DrawId>& draws) {
  Json list = Json::array();
  for (const DrawId id : draws) {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      const auto& held = scene.meshes[m].draws;
      const auto found = std::ranges::find(held, id);
      if (found != held.end()) list.push_back({m, found - held.begin()});
    }
  }
  return list;
}

/// Nothing where a clip is none of the scene's.
std::optional<Json> json_of(const Scene& scene, const OrderTable& table, AccessorStore& store) {
  const std::vector<std::string> names = clip_names(scene);
  Json json{{"primitives", primitives_of(scene, table.draws)}};
  for (const OrderTable::Clip& clip : table.clips) {
    const auto animation = std::ranges::find(names, clip.name);
    if (animation == names.end()) return std::nullopt;
    if (clip.times.empty()) continue;
    const auto bytes = std::as_bytes(std::span(clip.times));
    json["clips"].push_back({{"animation", animation - names.begin()},
                             {"times", store.append(scalars(Component::float32, clip.times.size(), bytes))}});
  }
  json["thetaSteps"] = table.theta_steps;
  json["phiSteps"] = table.phi_steps;
  json["order"] = store.append(scalars(Component::uint8, table.order.size(), std::as_bytes(std::span(table.order))));
  return json;
}

/// What the file says already of the same tables and the same primitives stays.
bool stays(const Scene& scene, const Source& source) {
  const Scene& was = source.as_read;
  return scene.order_tables == was.order_tables &&
         std::ranges::all_of(scene.order_tables, [&](const OrderTable& table) {
           return primitives_of(scene, table.draws) == primitives_of(was, table.draws);
         });
}

}  // namespace

void patch_order_tables(const Scene& scene, const Source& source, Json& json, AccessorStore& store,
                        Diagnostics& diagnostics) {
  if (!stays(scene, source)) {
    const Json& before = source.document.json;
    const std::set<std::size_t> elsewhere = used_elsewhere(before);
    const std::set<std::size_t> by_primitives = used_by_primitives(before);
    for (const std::size_t accessor : used_by_tables(before)) {
      if (!elsewhere.contains(accessor) && !by_primitives.contains(accessor)) store.release(accessor);
    }
    Json tables = Json::array();
    for (const OrderTable& table : scene.order_tables) {
      if (auto made = json_of(scene, table, store)) {
        tables.push_back(std::move(*made));
      } else {
        diagnostics.warning({.file = scene.name}, "table-left-out",
                            "an order table is of a clip that is no animation of the scene; it is not written");
      }
    }
    if (tables.empty()) {
      take_extension(json, draw_orders);
    } else {
      json["extensions"][draw_orders]["tables"] = std::move(tables);
    }
  }
  Json& names = json["extensionsUsed"];
  const auto listed = std::find(names.begin(), names.end(), Json(draw_orders));
  const bool is_used = has_draw_orders(json);
  if (is_used && listed == names.end()) names.push_back(draw_orders);
  if (!is_used && listed != names.end()) names.erase(listed);
  if (names.empty()) json.erase("extensionsUsed");
}

}  // namespace foredraw::gltf
