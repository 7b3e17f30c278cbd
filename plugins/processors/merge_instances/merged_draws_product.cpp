#include "merged_draws_product.h"

#include "merged_proof.h"
#include "schemas.h"

#include <foredraw/base/counted.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

/// Index entries of the slots of each size.
std::map<std::uint32_t, std::uint64_t> slots_by_frequency(const MergedInstances& merged) {
  std::map<std::uint32_t, std::uint64_t> slots;
  for (const MergedDraw& draw : merged.draws) slots[draw.frequency] += draw.slot_count;
  return slots;
}

std::string material_text(const Scene& scene, const MergedInstances& merged) {
  if (!merged.materials.empty()) return "a material per instance";
  if (!merged.material) return "no material";
  const std::string& name = scene.materials[*merged.material].name;
  return name.empty() ? fmt::format("material {}", *merged.material) : name;
}

class MergedDrawsRow final : public ProductRow {
 public:
  MergedDrawsRow()
      : ProductRow({.name = std::string(MergedDraws::product),
                    .title = "merged draws",
                    .extension = "FOREDRAW_merge_instances",
                    .remedy = "run merge-instances again; the nodes still show the same",
                    .accessors_of_file = {"sets/*/attributes/*", "sets/*/indices", "sets/*/slots", "sets/*/transforms",
                                          "sets/*/places", "sets/*/materials"},
                    .schemas = schemas(),
                    .side_files = {{".json", ".bin"}, {".glsl"}, {".hlsl"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    auto read = processors::merge_instances::read_merged_draws(from, scene);
    if (auto* wrong = std::get_if<std::string>(&read)) return std::move(*wrong);
    scene.products.set(std::get<MergedDraws>(std::move(read)));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    processors::merge_instances::write_merged_draws(scene, to);
  }

  std::string difference(const Scene& scene) const override {
    processors::merge_instances::MergedProof proof(scene);
    const auto sets = merged_sets(scene);
    for (std::size_t s = 0; s < sets.size(); ++s) {
      const std::string found = proof.difference(sets[s]);
      if (!found.empty()) return fmt::format("sets[{}] {}", s, found);
    }
    return {};
  }

  /// A stage that changed a draw's triangles would have to merge anew.
  std::vector<DrawId> held(const Scene& scene) const override {
    std::vector<DrawId> draws;
    for (const MergedInstances& set : merged_sets(scene)) {
      for (const MergedMesh& mesh : set.meshes) draws.push_back(mesh.draw);
    }
    std::ranges::sort(draws);
    draws.erase(std::unique(draws.begin(), draws.end()), draws.end());
    return draws;
  }

  SideFile side_file(const Scene& scene, std::string_view extension, const std::string& beside) const override {
    return processors::merge_instances::merged_side_file(scene, extension, beside);
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "merged draws (the nodes show the same)", .value = ExtensionValue::List()};
    for (const MergedInstances& merged : merged_sets(scene)) {
      std::vector<std::string> words;
      ExtensionValue::List slots;
      for (const auto& [frequency, count] : slots_by_frequency(merged)) {
        words.push_back(
            fmt::format("{} of {}", counted(count, "slot"), counted(frequency, "index entry", "index entries")));
        slots.push_back(ExtensionValue::Members{{"frequency", frequency}, {"slots", count}});
      }
      const std::string material = material_text(scene, merged);
      text.lines.push_back(fmt::format("{}: {} of {} in {}, drawn by {}; {}", material,
                                       counted(merged.places.size(), "instance"), counted(merged.meshes.size(), "draw"),
                                       counted(merged.groups.size(), "group"),
                                       counted(merged.draws.size(), "draw call"), fmt::join(words, ", ")));
      text.value.push(ExtensionValue::Members{
          {"material", material},
          {"draws",
           listed(merged.meshes, [&](const MergedMesh& mesh) { return ExtensionValue(scene.draws[mesh.draw].name); })},
          {"instances", merged.places.size()},
          {"groups", merged.groups.size()},
          {"calls", merged.draws.size()},
          {"slots", std::move(slots)}});
    }
    return text;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> merged_draws_product() { return std::make_shared<const MergedDrawsRow>(); }

}  // namespace foredraw
