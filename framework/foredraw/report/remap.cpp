#include <foredraw/report/remap.h>

#include <nlohmann/json.hpp>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

Json table(std::span<const std::uint32_t> numbers, const char* direction) {
  if (numbers.empty()) return nullptr;
  Json list = Json::array();
  for (std::uint32_t number : numbers) list.push_back(number == no_vertex ? Json(nullptr) : Json(number));
  return {{direction, std::move(list)}};
}

}  // namespace

std::string remap_json(const Scene& scene) {
  Json json{{"remap", 1}, {"file", scene.name}, {"draws", Json::array()}};
  for (const Draw& draw : scene.draws) {
    if (!draw.origin) continue;
    const Level& level = draw.levels[0];
    json["draws"].push_back({{"name", draw.name},
                             {"mesh", draw.origin->mesh},
                             {"primitive", draw.origin->primitive},
                             {"triangles", table(level.orders[0].triangle_origin.view(), "new-to-old")},
                             {"vertices", table(level.vertex_destination.view(), "old-to-new")}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foredraw
