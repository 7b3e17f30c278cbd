// Draws that are levels of others folded into these, and back.
#include <foredraw/io/gltf/private/levels.h>

#include <foredraw/scene/levels.h>

#include <algorithm>

namespace foredraw::gltf {

bool is_in_coarser_mesh(const Draw& draw, const Level& level) {
  return level.origin && draw.origin && level.origin->mesh != draw.origin->mesh;
}

void fold_levels(Scene& scene, const std::vector<Ladder>& ladders) {
  const auto id_of = [&](const DrawOrigin& origin) { return scene.meshes[origin.mesh].draws[origin.primitive]; };
  std::vector<bool> is_level(scene.draws.size(), false);
  for (const Ladder& ladder : ladders) {
    for (std::size_t i = 0; i < ladder.coarser.size(); ++i) {
      const DrawId id = id_of(ladder.coarser[i]);
      Level level = std::move(scene.draws[id].full());
      level.origin = ladder.coarser[i];
      if (i < ladder.errors.size()) level.error = ladder.errors[i];
      scene.draws[id_of(ladder.full)].levels.push_back(std::move(level));
      is_level[id] = true;
    }
  }
  if (ladders.empty()) return;
  std::vector<DrawId> number(scene.draws.size());
  std::vector<Draw> draws;
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    number[id] = static_cast<DrawId>(draws.size());
    if (!is_level[id]) draws.push_back(std::move(scene.draws[id]));
  }
  scene.draws = std::move(draws);
  for (Mesh& mesh : scene.meshes) {
    const bool had_several = mesh.draws.size() > 1;
    std::erase_if(mesh.draws, [&](DrawId id) { return is_level[id]; });
    for (DrawId& id : mesh.draws) id = number[id];
    if (!had_several || mesh.draws.size() != 1) continue;
    std::string& name = scene.draws[mesh.draws[0]].name;  // the only one is called as the mesh is, without a number
    name.resize(name.size() - 2);
  }
}

Scene unfolded(const Scene& scene) {
  Scene flat = scene;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    for (const DrawId id : scene.meshes[m].draws) {
      if (id >= scene.draws.size()) continue;
      const Draw& draw = scene.draws[id];
      for (std::size_t i = 1; i < draw.levels.size(); ++i) {
        Draw level = at_level(draw, i);
        level.name = name_of(draw, i);
        if (level.full().origin) level.origin = level.full().origin;
        const auto number = static_cast<DrawId>(flat.draws.size());
        std::vector<DrawId>& draws =
            flat.meshes[is_in_coarser_mesh(draw, draw.levels[i]) ? level.origin->mesh : m].draws;
        if (&draws != &flat.meshes[m].draws) {
          draws.resize(std::max<std::size_t>(draws.size(), level.origin->primitive + 1), ~DrawId{0});
          draws[level.origin->primitive] = number;
        } else {
          draws.push_back(number);
        }
        flat.draws.push_back(std::move(level));
      }
      if (draw.levels.size() > 1) flat.draws[id].levels.resize(1);
    }
  }
  return flat;
}

LevelScene::LevelScene(const Scene& scene, const Source& source, LevelsAs levels, Diagnostics& diagnostics)
    : scene_(scene), source_(source) {
  if (most_levels(scene) <= 1) return;
  if (levels == LevelsAs::lod_nodes) with_lods_ = with_lod_nodes(scene, source.document, lods_, diagnostics);
  flat_ = unfolded(with_lods_ ? *with_lods_ : scene);
}

bool LevelScene::same_errors() const {
  return !flat_ || std::ranges::equal(flat().draws, source_.as_read.draws,
                                      [](const Draw& a, const Draw& b) { return a.full().error == b.full().error; });
}

void LevelScene::put_lods(Json& json) const {
  if (lods_.empty()) return;
  for (const auto& [number, lods] : lods_) {
    Json& node = json["nodes"][number];
    node["extensions"][lod_extension]["ids"] = lods.ids;
    const bool has_room =
        !node.contains("extras") || (node["extras"].is_object() && !node["extras"].contains(coverage_key));
    if (!lods.coverage.empty() && has_room) node["extras"][coverage_key] = lods.coverage;
  }
  Json& names = json["extensionsUsed"];
  if (std::ranges::find(names, Json(lod_extension)) == names.end()) names.push_back(lod_extension);
}

}  // namespace foredraw::gltf
