#include <foredraw/collapses/collapse_product.h>

#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/collapses/named_primitives.h>
#include <foredraw/collapses/replay.h>
#include <foredraw/scene/moves.h>

#include "schemas.h"

#include <algorithm>

namespace foredraw {

namespace {

using Members = ExtensionValue::Members;

template <class T>
bool read_rows(ExtensionReader& from, const ExtensionValue& of, const char* name, Component component,
               std::vector<T>& to) {
  const auto rows = rows_of<T>(from, of.member(name), component);
  if (rows) to.assign(rows->view().begin(), rows->view().end());
  return rows.has_value();
}

/// As the rest of a sentence; empty: its sequence runs on what the draws are.
std::string why_not(const DrawsCollapse& mesh, const Scene& scene) {
  Analyses analyses;
  const auto joined = joined_mesh(scene, mesh.draws, analyses);
  if (!joined) return "a draw of theirs is gone";
  const Replay run = replay(*mesh.sequence, joined->positions, joined->indices, joined->part);
  return run.mistake.empty() ? std::string() : scene.draws[mesh.draws.front()].name + ": " + run.mistake;
}

class CollapseRow final : public ProductRow {
 public:
  CollapseRow()
      : ProductRow({.name = std::string(CollapseSequences::product),
                    .title = "sequences of collapses",
                    .extension = "FOREDRAW_progressive_mesh",
                    .remedy = "simplify the file again",
                    .accessors_of_file = {"meshes/*/collapses", "meshes/*/amounts", "meshes/*/pairs",
                                          "meshes/*/firstPairs", "meshes/*/places"},
                    .schemas = schemas()}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    const ExtensionValue* file = from.of_file();
    const ExtensionValue* meshes = file == nullptr ? nullptr : file->member("meshes");
    if (meshes == nullptr || meshes->list() == nullptr || meshes->list()->empty()) {
      return "it has no array 'meshes' with a mesh";
    }
    CollapseSequences all;
    for (const ExtensionValue& one : *meshes->list()) {
      auto draws = named_primitives(one.member("primitives"), scene);
      if (!draws) return "it names a primitive that is not there";
      CollapseSequence sequence;
      std::vector<std::array<std::uint32_t, 2>> points;
      std::vector<std::array<float, 2>> amounts;
      const bool reads = read_rows(from, one, "collapses", Component::uint32, points) &&
                         read_rows(from, one, "amounts", Component::float32, amounts) &&
                         read_rows(from, one, "pairs", Component::uint32, sequence.pairs) &&
                         read_rows(from, one, "firstPairs", Component::uint32, sequence.first_pair);
      if (!reads || points.size() != amounts.size()) {
        return "meshes[" + std::to_string(all.meshes.size()) + "] lacks an accessor, or has one of another type";
      }
      std::vector<std::array<float, 3>> places;
      if (one.member("places") != nullptr && !read_rows(from, one, "places", Component::float32, places)) {
        return "its places are not floats";
      }
      for (const auto& place : places) sequence.places.insert(sequence.places.end(), place.begin(), place.end());
      if (const ExtensionValue* solved = one.member("solved"); solved != nullptr) {
        const bool* const is_solved = std::get_if<bool>(&solved->any());
        if (is_solved == nullptr) return "its member 'solved' is neither true nor false";
        sequence.solves = *is_solved;
      }
      for (std::size_t i = 0; i < points.size(); ++i) {
        sequence.collapses.push_back({points[i][0], points[i][1], amounts[i][0], amounts[i][1]});
      }
      for (const DrawId id : *draws) scene.draws[id].traits.add(traits::progressive);
      all.meshes.push_back({std::move(*draws), std::make_shared<const CollapseSequence>(std::move(sequence))});
    }
    scene.products.set(std::move(all));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    to.put_on_file(Members{{"meshes", listed(scene.products.find<CollapseSequences>()->meshes,
                                             [&](const DrawsCollapse& mesh) { return written(mesh, scene, to); })}});
  }

  std::string difference(const Scene& scene) const override {
    return first_difference(scene.products.find<CollapseSequences>()->meshes, scene,
                            [&](const auto& mesh) { return why_not(mesh, scene); });
  }

  /// Triangles may be in any sequence. Vertices are named by number, so that those of a draw that were renumbered are
  /// looked up; what made others of them ends the sequence.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    CollapseSequences left;
    std::vector<std::string> told;
    for (const DrawsCollapse& mesh : after.products.find<CollapseSequences>()->meshes) {
      const auto is_changed = [&](DrawId id) {
        return id >= before.draws.size() || id >= after.draws.size() ||
               before.draws[id].full().vertices != after.draws[id].full().vertices;
      };
      if (std::ranges::none_of(mesh.draws, is_changed)) {
        left.meshes.push_back(mesh);
        continue;
      }
      told.push_back("the sequence of collapses of " + before.draws[mesh.draws.front()].name +
                     " is left out: its vertices were changed");
    }
    if (told.empty()) return told;
    const bool is_empty = left.meshes.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  void leave_out(Scene& scene) const override {
    scene.products.erase(CollapseSequences::product);
    for (Draw& draw : scene.draws) {
      draw.traits.remove(traits::progressive);
      for (Level& level : draw.levels) level.made.remove(traits::progressive);
    }
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "sequences of collapses (from full detail to the coarsest level)",
                     .value = ExtensionValue::List()};
    for (const DrawsCollapse& mesh : scene.products.find<CollapseSequences>()->meshes) {
      std::vector<std::string> names;
      for (const DrawId id : mesh.draws) names.push_back(scene.draws[id].name);
      std::string line;
      for (const std::string& name : names) line += (line.empty() ? "" : ", ") + name;
      text.lines.push_back(line + ": edges that collapse: " + std::to_string(mesh.sequence->collapses.size()));
      text.value.push(Members{{"draws", ExtensionValue::List(names.begin(), names.end())},
                              {"collapses", mesh.sequence->collapses.size()}});
    }
    return text;
  }

 private:
  static ExtensionValue written(const DrawsCollapse& mesh, const Scene& scene, ExtensionWriter& to) {
    const CollapseSequence& sequence = *mesh.sequence;
    std::vector<std::uint32_t> points, pairs;
    std::vector<float> amounts;
    for (const Collapse& collapse : sequence.collapses) {
      points.insert(points.end(), {collapse.removed, collapse.kept});
      amounts.insert(amounts.end(), {collapse.blend, collapse.error});
    }
    for (const VertexPair& pair : sequence.pairs) pairs.insert(pairs.end(), {pair.removed, pair.kept});
    const auto whole = [&](const std::vector<std::uint32_t>& values, std::uint8_t components) {
      return to.accessor(accessor_data(std::span(values), Component::uint32, components));
    };
    const auto real = [&](const std::vector<float>& values, std::uint8_t components) {
      return to.accessor(accessor_data(std::span(values), Component::float32, components));
    };
    Members members{{"primitives", names_of_primitives(mesh.draws, scene)},
                    {"collapses", whole(points, 2)},
                    {"amounts", real(amounts, 2)},
                    {"pairs", whole(pairs, 2)},
                    {"firstPairs", whole(sequence.first_pair, 1)}};
    if (!sequence.places.empty()) members.emplace_back("places", real(sequence.places, 3));
    if (sequence.solves) members.emplace_back("solved", true);
    return members;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> collapse_product() { return std::make_shared<const CollapseRow>(); }

}  // namespace foredraw
