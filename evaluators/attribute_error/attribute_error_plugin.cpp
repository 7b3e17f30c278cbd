#include "attribute_error.h"

#include <foredraw/scene/scaled_texcoords.h>
#include <foredraw/technique/plugin.h>

#include <string>
#include <vector>

namespace foredraw {

namespace {

/// A draw's surface and what its vertices carry, positions and texture coordinates in the units of the file.
struct DecodedSurface {
  std::vector<glm::vec3> positions, uvs, normals;
  Shared<std::uint32_t> indices;

  DecodedSurface(const Scene& scene, const Draw& draw)
      : positions(decoded(*draw.full().vertices, "POSITION")),
        uvs(decoded(*draw.full().vertices, "TEXCOORD_0")),
        normals(decoded(*draw.full().vertices, "NORMAL")),
        indices(draw.full().stream().indices) {
    for (glm::vec3& position : positions) position = position_in({}, draw.space, position);
    const ScaledTexcoords file = scaled_texcoords_of(scene.material_of(draw), 0);
    for (glm::vec3& uv : uvs) uv = glm::vec3(file.offset + file.scale * glm::dvec2(uv), 0);
  }

  AttributedSurface view() const { return {{positions, indices.view()}, uvs, normals}; }

 private:
  static std::vector<glm::vec3> decoded(const VertexStreams& vertices, std::string_view semantic) {
    const VertexStream* stream = vertices.find(semantic);
    return stream != nullptr ? decode_vec3(*stream) : std::vector<glm::vec3>();
  }
};

class AttributeErrorEvaluator final : public DrawEvaluator {
 public:
  explicit AttributeErrorEvaluator(const AttributeErrorOptions& options) : options_(options) {}

  void evaluate(const DrawView& draw, Run& run) const override {
    const Scene& original = run.original != nullptr ? *run.original : draw.scene;
    if (draw.id >= original.draws.size() || original.draws[draw.id].topology != Topology::triangles) {
      return run.note("no-original", "the scene that the run began with has no such draw to compare it with");
    }
    const DecodedSurface now(draw.scene, draw.draw());
    const DecodedSurface before(original, original.draws[draw.id]);
    // At nearest points of one surface on itself rounding alone is left, which is no error.
    const bool is_same = now.indices == before.indices &&
                         draw.draw().full().vertices->stamp() == original.draws[draw.id].full().vertices->stamp();
    const auto measure = [&](const std::string& metric, const std::optional<Sampled>& figure) {
      if (figure) run.measure(metric, is_same ? 0 : figure->value, 1, is_same ? 0 : figure->error);
    };
    const auto error = attribute_error(now.view(), before.view(), options_, run.seed, run.executor);
    if (!error)
      return run.note("nothing-left", "only one of the draw and its original has triangles with finite positions");
    measure("uv-rms", error->uv());
    measure("normal-rms", error->normal());
    measure("to-original.uv-rms", error->to_original.uv);
    measure("to-original.normal-rms", error->to_original.normal);
    measure("from-original.uv-rms", error->from_original.uv);
    measure("from-original.normal-rms", error->from_original.normal);
  }

 private:
  AttributeErrorOptions options_;
};

}  // namespace

Plugin attribute_error_plugin() {
  OptionTable<AttributeErrorOptions> table;
  table.row(&AttributeErrorOptions::samples, "samples", "Points on each surface", {1, 1'000'000, "points"});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "attribute-error",
      .summary = "Measures how far texture coordinates and normals are from those of the scene that the run began with",
      .reference = "own; nearest points as in Cignoni, Rocchini, Scopigno 1998 (Metro)",
      .acts_on = {traits::triangles},
      .metrics =
          {
              {"uv-rms", "of the texture", "Root mean square distance of texture coordinates at nearest points"},
              {"normal-rms", "degrees", "Root mean square angle between normals at nearest points"},
          },
  };
  bind_options(plugin, std::move(table),
               [](const AttributeErrorOptions& options) { return std::make_unique<AttributeErrorEvaluator>(options); });
  return plugin;
}

}  // namespace foredraw
