// FOREDRAW_levels: a primitive's coarser levels, each with the members of a primitive that say what is drawn.
#include <foredraw/io/gltf/private/levels.h>

#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/gltf/private/member.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw::gltf {

namespace {

constexpr std::size_t most_levels = 255;

/// Points, lines or triangles, as lists or not; nothing where it is no such number.
std::optional<int> kind_of(const Json& primitive) {
  const Json* mode = member(primitive, "mode");
  if (mode == nullptr) return 2;
  if (!mode->is_number_unsigned() || mode->get<std::uint64_t>() > 6) return std::nullopt;
  const auto number = mode->get<int>();
  return number == 0 ? 0 : number < 4 ? 1 : 2;
}

std::optional<std::string> mistake_in_level(const Json& level, const Json& primitive) {
  if (!level.is_object()) return "is not an object";
  const Json* attributes = member(level, "attributes");
  if (attributes == nullptr || member(*attributes, "POSITION") == nullptr) return "has no positions";
  if (kind_of(level) != kind_of(primitive)) return "draws another kind of primitive than full detail does";
  const Json* error = member(level, "error");
  const bool is_distance = error == nullptr || (error->is_number() && error->get<double>() >= 0 &&
                                                error->get<double>() <= std::numeric_limits<float>::max());
  return is_distance ? std::nullopt : std::optional<std::string>("has an error that is not a distance");
}

Json json_of(const Json& primitive, float error) {
  Json level = Json::object();
  for (const char* key : {"attributes", "indices", "mode", "targets"}) {
    if (const auto found = primitive.find(key); found != primitive.end()) level[key] = *found;
  }
  // As any primitive it may be compressed; its other extensions are those of full detail.
  if (const Json* coded = extension_of(primitive, draco_extension)) level["extensions"][draco_extension] = *coded;
  // Digits that read back as this number, and no more.
  if (std::isfinite(error)) level["error"] = Json::parse(fmt::format("{}", error));
  return level;
}

}  // namespace

ProductCard levels_card() {
  return {.name = "levels",
          .title = "levels of detail",
          .extension = levels_extension,
          .remedy = "make them again as the last step, after all other changes of the file",
          .accessors_of_draw = {"levels/*/indices", "levels/*/attributes/*", "levels/*/targets/*/*"}};
}

std::optional<std::string> expose_levels(Json& json, std::vector<Ladder>& ladders) {
  std::optional<std::string> mistake;
  Json::array_t behind(json.at("meshes").size());
  each_primitive(json, [&](Json& primitive, std::size_t m, std::size_t p) {
    if (mistake || extension_of(primitive, levels_extension) == nullptr) return;
    const Json value = take_extension(primitive, levels_extension);
    const std::string place = at(in(at("meshes", m), "primitives"), p);
    const Json* list = member(value, "levels");
    if (list == nullptr || !list->is_array() || list->empty() || list->size() > most_levels) {
      mistake = fmt::format("{} must have 1 to {} levels", place, most_levels);
      return;
    }
    Ladder ladder{{static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(p)}, {}, {}};
    for (const Json& level : *list) {
      if (const auto why = mistake_in_level(level, primitive)) {
        mistake = fmt::format("{}: a level {}", place, *why);
        return;
      }
      const std::size_t number = json["meshes"][m]["primitives"].size() + behind[m].size();
      ladder.coarser.push_back({static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(number)});
      ladder.errors.push_back(level.contains("error") ? level["error"].get<float>() : 0.0f);
      behind[m].push_back(json_of(level, INFINITY));
    }
    ladders.push_back(std::move(ladder));
  });
  for (std::size_t m = 0; m < behind.size(); ++m) {
    for (Json& level : behind[m]) json["meshes"][m]["primitives"].push_back(std::move(level));
  }
  return mistake;
}

std::string place_of_level(const std::vector<Ladder>& ladders, const std::string& place) {
  const auto place_of = [](const DrawOrigin& of) { return at(in(at("meshes", of.mesh), "primitives"), of.primitive); };
  for (const Ladder& ladder : ladders) {
    for (std::size_t i = 0; i < ladder.coarser.size(); ++i) {
      const std::string exposed = place_of(ladder.coarser[i]);
      if (!place.starts_with(exposed)) continue;
      const std::string levels = in(in(in(place_of(ladder.full), "extensions"), levels_extension), "levels");
      return at(levels, i) + place.substr(exposed.size());
    }
  }
  return place;
}

void enclose_levels(const Scene& scene, Json& json) {
  bool any = false;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const std::vector<DrawId>& draws = scene.meshes[m].draws;
    if (draws.empty()) continue;  // its primitives are levels of another mesh
    Json& primitives = json["meshes"][m]["primitives"];
    std::size_t behind = draws.size();
    for (std::size_t p = 0; p < draws.size(); ++p) {
      const Draw& draw = scene.draws[draws[p]];
      Json levels = Json::array();
      for (std::size_t i = 1; i < draw.levels.size(); ++i) {
        if (is_in_coarser_mesh(draw, draw.levels[i])) continue;
        levels.push_back(json_of(primitives[behind++], draw.levels[i].error));
      }
      if (levels.empty()) continue;
      primitives[p]["extensions"][levels_extension] = JsonObject{{"levels", std::move(levels)}};
      any = true;
    }
    while (primitives.size() > draws.size()) primitives.erase(primitives.size() - 1);
  }
  if (!any) return unlist_extension(json, levels_extension);
  Json& names = json["extensionsUsed"];
  if (std::ranges::find(names, Json(levels_extension)) == names.end()) names.push_back(levels_extension);
}

}  // namespace foredraw::gltf
