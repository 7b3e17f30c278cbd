#include "vertex_precision.h"

#include <foredraw/measuring/pose_options.h>
#include <foredraw/technique/plugin.h>

#include <stdexcept>

namespace foredraw {

namespace {

struct VertexPrecisionOptions : PoseSet {
  VertexPrecisionOptions() { poses = "all"; }
};

class VertexPrecisionEvaluator final : public Evaluator {
 public:
  explicit VertexPrecisionEvaluator(VertexPrecisionOptions options) : options_(std::move(options)) {
    if (const auto mistake = mistake_in(options_)) throw std::invalid_argument(*mistake);
  }

  void evaluate(const Scene& scene, Run& run) const override {
    if (!scene.products.has(PackedVertices::product)) {
      return run.note("nothing-packed", "no vertices are packed; put vertex-pack before it");
    }
    for (const DrawPrecision& of : vertex_precision(scene, run.subjects, make_poses(scene, options_), run.executor)) {
      measure(of, scene, run);
    }
  }

 private:
  static void measure(const DrawPrecision& of, const Scene& scene, const Run& run) {
    const About about{.draw = of.draw};
    constexpr double texels = 4096;
    const auto pair = [&](const std::string& metric, double error, double bound, double whole) {
      if (!(bound > 0) || !(whole > 0)) return;
      run.measure_at(about, metric, error, whole);
      run.measure_at(about, metric + "-bound", bound, whole);
    };
    pair("position", of.errors.most.position, of.bounds.position, of.diagonal / 1e6);
    if (of.posed) {
      pair("posed-position", of.posed->position, of.posed->bound, of.posed->diagonal / 1e6);
      run.count_at(about, "posed-outside", static_cast<double>(of.posed->outside));
    }
    const VertexStreams& vertices = *scene.draws[of.draw].full().vertices;
    if (vertices.find("NORMAL") != nullptr) pair("normal", of.errors.most.normal, of.bounds.normal, 1);
    if (vertices.find("TANGENT") != nullptr) {
      pair("tangent", of.errors.most.tangent, of.bounds.tangent, 1);
      run.count_at(about, "handedness", static_cast<double>(of.errors.handedness));
    }
    if (vertices.find("TEXCOORD_0") != nullptr) {
      const double unit = packed_uv_widths(scene, of.draw) * texels;
      pair("uv", of.errors.most.uv() * unit, of.bounds.uv() * unit, 1);
    }
    if (of.plain_bytes > 0) {
      run.measure_at(about, "size", static_cast<double>(of.packed_bytes), static_cast<double>(of.plain_bytes));
    }
  }

  VertexPrecisionOptions options_;
};

}  // namespace

Plugin vertex_precision_plugin() {
  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "vertex-precision",
      .summary =
          "Measures how far packed vertices are from the plain streams, compared with what their layout promises",
      .reference = "own",
      .acts_on = {traits::triangles},
      .metrics =
          {
              {"position", "millionths of the diagonal", "Largest error of a stored position", true, true},
              {"position-bound", "millionths of the diagonal", "The bound that the layout promises for it", true, true},
              {"posed-position", "millionths of the diagonal",
               "Largest error of a position in all poses, packed as posed", true, true},
              {"posed-position-bound", "millionths of the diagonal", "The bound that the layout promises for it", true,
               true},
              {"posed-outside", "vertices", "Posed vertices that the lattice does not reach, over all poses"},
              {"normal", "degrees", "Largest error of a normal", true, true},
              {"normal-bound", "degrees", "The bound that the layout promises for it", true, true},
              {"tangent", "degrees", "Largest error of a tangent", true, true},
              {"tangent-bound", "degrees", "The bound that the layout promises for it", true, true},
              {"handedness", "tangents", "Tangents whose sign differs"},
              {"uv", "texels of 4096", "Largest error of a texture coordinate, along u or v", true, true},
              {"uv-bound", "texels of 4096", "The bound that the layout promises for it", true, true},
              {"size", "of the plain bytes", "Bytes of the rows against those of the streams that they stand for"},
          },
  };
  OptionTable<VertexPrecisionOptions> table;
  add_pose_rows(table);
  bind_options(plugin, std::move(table), [](const VertexPrecisionOptions& options) {
    return std::make_unique<VertexPrecisionEvaluator>(options);
  });
  return plugin;
}

}  // namespace foredraw
