#include <foredraw/report/remap.h>

#include <foredraw/report/private/json_values.h>

namespace foredraw {

namespace {

Json table(std::span<const std::uint32_t> numbers, const char* direction) {
  if (numbers.empty()) return nullptr;
  Json list = Json::array();
  for (std::uint32_t number : numbers) list.push_back(number == no_vertex ? Json(nullptr) : Json(number));
  return {{direction, std::move(list)}};
}

void add_tables(const Level& level, Json& json) {
  if (level.origin) {
    json["mesh"] = level.origin->mesh;
    json["primitive"] = level.origin->primitive;
  }
  json["triangles"] = table(level.stream().triangle_origin.view(), "new-to-old");
  json["vertices"] = table(level.vertex_destination.view(), "old-to-new");
}

}  // namespace

std::string remap_json(const Scene& scene) {
  Json json{{"remap", 1}, {"file", scene.name}, {"draws", Json::array()}};
  for (const Draw& draw : scene.draws) {
    if (!draw.origin) continue;
    Json one{{"name", draw.name}, {"mesh", draw.origin->mesh}, {"primitive", draw.origin->primitive}};
    add_tables(draw.full(), one);
    for (std::size_t i = 1; i < draw.levels.size(); ++i) add_tables(draw.levels[i], one["levels"].emplace_back());
    json["draws"].push_back(std::move(one));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foredraw
