#include "displacement_bake.h"

#include "baked_heights_product.h"

#include <foredraw/analysis/diagonal.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/collapses/collapse_product.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/cut.h>
#include <foredraw/displaced/smooth_directions.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

struct Options {
  double rms = 0.00025;
  std::optional<double> cage;
  std::uint32_t finest = 16;
  std::optional<std::uint32_t> bits;
};

/// A mesh that becomes few triangles and heights, and what it is compared with.
struct Made {
  CutDraw cut;
  BakedCage baked;
  std::size_t bytes = 0;
  std::size_t simplified_triangles = 0, simplified_bytes = 0;  ///< of triangles alone that are as near
  std::string why_not;                                         ///< empty: it pays
};

class MeshBake {
 public:
  MeshBake(const DrawsCollapse& mesh, const Scene& scene, const Options& options, Run& run)
      : sequence_(*mesh.sequence),
        options_(options),
        run_(run),
        joined_(*joined_mesh(scene, mesh.draws, run.analyses)) {
    replay_ = replay(sequence_, joined_.positions, joined_.indices, joined_.part);
    if (!replay_.mistake.empty()) throw std::runtime_error(replay_.mistake);
  }

  Made made() {
    Made best;
    const processors::displacement_bake::Target target(full());
    const double wanted = options_.rms * diagonal_of(joined_.positions);
    const std::vector<double> ratios =
        options_.cage ? std::vector{*options_.cage} : std::vector{1.0 / 512, 1.0 / 256, 1.0 / 128, 1.0 / 90, 1.0 / 64,
                                                                  1.0 / 45,  1.0 / 32,  1.0 / 16,  1.0 / 8};
    for (const double ratio : ratios) {
      if (run_.cancelled()) return best;
      auto one = made_of(collapses_to(ratio), target, wanted);
      if (one && (best.baked.levels.empty() || one->bytes < best.bytes)) best = std::move(*one);
    }
    if (best.baked.levels.empty()) {
      best.why_not = "no cage comes within the rms; give a larger one, or finer levels";
      return best;
    }
    compare(best, wanted);
    return best;
  }

 private:
  Surface full() const { return {joined_.positions, joined_.indices}; }

  /// How many collapses leave at most this share of the triangles.
  std::size_t collapses_to(double ratio) const {
    const double most = ratio * replay_.triangles.front();
    const auto at = std::ranges::find_if(replay_.triangles, [&](std::uint32_t left) { return left <= most; });
    return std::min<std::size_t>(static_cast<std::size_t>(at - replay_.triangles.begin()),
                                 replay_.triangles.size() - 1);
  }

  std::optional<Made> made_of(std::size_t collapses, const processors::displacement_bake::Target& target,
                              double wanted) const {
    const Collapsed after = collapsed(sequence_, collapses, joined_);
    Made made{std::move(cut(sequence_, collapses, after, joined_).front()), {}};
    const auto indices = made.cut.indices.view();
    if (indices.empty()) return std::nullopt;
    const std::vector<glm::vec3> positions = decode_vec3(*made.cut.vertices->find("POSITION"));
    const VertexStream* stored = made.cut.vertices->find("NORMAL");
    const std::vector<glm::vec3> normals = stored == nullptr ? std::vector<glm::vec3>{} : decode_vec3(*stored);
    const DirectedPart parts[] = {{positions, normals, indices}};
    const std::vector<glm::vec3> directions = std::move(smooth_directions(parts).front());
    BakeOptions options{wanted, options_.finest, options_.bits};
    options.seed = run_.seed;
    // Finer than the surface itself is of no use.
    const double finer =
        2 * std::sqrt(static_cast<double>(joined_.indices.size()) / static_cast<double>(indices.size()));
    while (options.finest > 1 && options.finest > finer) options.finest /= 2;
    made.baked = bake_heights({positions, indices, directions}, target, full(), options, run_.executor);
    if (!(made.baked.rms <= 1.02 * wanted)) return std::nullopt;
    made.bytes = baked_bytes(positions.size(), made.baked);
    return made;
  }

  /// With the fewest triangles of the sequence that lie as near, in the mean and at most.
  void compare(Made& made, double wanted) const {
    std::size_t fine = 0, coarse = replay_.triangles.size() - 1;
    while (coarse - fine > std::max<std::size_t>(1, replay_.triangles.size() / 1000)) {
      const std::size_t middle = fine + (coarse - fine) / 2;
      (is_as_near(middle, made.baked, wanted) ? fine : coarse) = middle;
    }
    const Collapsed after = collapsed(sequence_, fine, joined_);
    const CutDraw simplified = std::move(cut(sequence_, fine, after, joined_).front());
    made.simplified_triangles = simplified.indices.size() / 3;
    made.simplified_bytes = mesh_bytes(simplified.vertices->count, made.simplified_triangles);
    if (made.bytes < made.simplified_bytes) return;
    made.why_not = fmt::format("{} triangles alone are as close in {} bytes; {} triangles with heights take {}",
                               made.simplified_triangles, made.simplified_bytes, made.baked.levels.size(), made.bytes);
  }

  /// What is far below what is wanted counts as nothing.
  bool is_as_near(std::size_t collapses, const BakedCage& baked, double wanted) const {
    const Collapsed after = collapsed(sequence_, collapses, joined_);
    const auto distance = surface_distance(full(), {after.places, after.indices},
                                           {.samples = BakeOptions{}.samples, .seed = run_.seed}, run_.executor);
    return distance && distance->rms <= std::max(baked.rms, wanted / 100) &&
           distance->largest <= std::max(baked.largest, wanted);
  }

  const CollapseSequence& sequence_;
  const Options& options_;
  Run& run_;
  JoinedMesh joined_;
  Replay replay_;
};

std::string why_not(const DrawsCollapse& mesh, const Scene& scene) {
  if (mesh.draws.size() > 1) return "its mesh has several draws, which would part at their borders";
  const Draw& draw = scene.draws[mesh.draws.front()];
  if (draw.levels.size() > 1) return "it has several levels of detail";
  if (!draw.full().vertices->morph_targets.empty()) return "it has morph targets";
  if (const Material* material = scene.material_of(draw); material != nullptr && material->displacement)
    return "a map of heights moves it already";
  return {};
}

class DisplacementBakeProcessor final : public Processor {
 public:
  explicit DisplacementBakeProcessor(Options options) : options_(options) {
    if ((options.finest & (options.finest - 1)) != 0) throw std::invalid_argument("'finest' must be a power of two");
  }

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawsCollapse> meshes = sequences_of(scene, draws);
    if (meshes.empty()) {
      run.keep("no mesh has a sequence of collapses, such as `quadric-collapse` finds before this stage");
      return {};
    }
    std::vector<DrawId> changed;
    std::vector<DrawsCollapse> used_up;
    const BakedHeights* before = scene.products.find<BakedHeights>();
    BakedHeights all = before == nullptr ? BakedHeights{} : *before;
    std::string reasons;
    for (const DrawsCollapse& mesh : meshes) {
      const About about{.draw = mesh.draws.front()};
      std::string why = why_not(mesh, scene);
      Made made;
      if (why.empty()) made = MeshBake(mesh, scene, options_, run).made();
      if (why.empty()) why = made.why_not;
      if (made.bytes > 0) tell(about, made, run);
      if (!why.empty()) {
        run.note_at(about, "not-baked", "not baked: " + why);
        reasons = why;
        continue;
      }
      put(made, scene.draws[*about.draw]);
      all.draws.push_back({*about.draw, Shared(std::move(made.baked.levels)), Shared(std::move(made.baked.heights)),
                           made.baked.bits, made.baked.factor, made.baked.offset});
      changed.push_back(*about.draw);
      used_up.push_back(mesh);
    }
    if (changed.empty()) {
      run.keep(meshes.size() == 1 ? reasons : "no mesh takes fewer bytes as a cage with heights");
      return {};
    }
    std::ranges::sort(all.draws, {}, &DrawHeights::draw);
    scene.products.set(std::move(all));
    remove_sequences(scene, used_up);
    std::ranges::sort(changed);
    return changed;
  }

 private:
  void tell(const About& about, const Made& made, Run& run) const {
    run.count_at(about, "triangles", static_cast<double>(made.baked.levels.size()));
    run.count_at(about, "drawn", static_cast<double>(made.baked.indices.size() / 3));
    run.count_at(about, "bytes", static_cast<double>(made.bytes));
    run.count_at(about, "simplified-bytes", static_cast<double>(made.simplified_bytes));
    run.measure_at(about, "rms", made.baked.rms, 1);
    run.measure_at(about, "largest", made.baked.largest, 1);
  }

  static void put(const Made& made, Draw& draw) {
    Level& level = draw.full();
    level.vertices = made.cut.vertices;
    level.orders = {IndexStream{.indices = made.cut.indices}};
    level.vertex_destination = {};
  }

  Options options_;
};

}  // namespace

Plugin displacement_bake_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "displacement-bake",
      .summary =
          "Turns many triangles into few with heights, for a tessellator, where simplification alone takes more bytes",
      .reference = "Tatarchuk, Barczak, Purnomo 2008",
      .acts_on = {traits::triangles},
      .needs = {traits::progressive},
      .provides = {traits::displaced},
      .breaks = {traits::progressive, traits::clustered, traits::cache_ordered, traits::overdraw_ordered,
                 traits::fetch_ordered},
      .pays_if = "the surface is smooth and has much small detail, and the engine tessellates",
      .measured_by = {"surface-error"},
      .metrics = {{"triangles", "triangles", "Triangles of the cage"},
                  {"drawn", "triangles", "Triangles that a tessellator makes of them", false},
                  {"bytes", "bytes", "Positions, indices, levels and heights as a GPU holds them"},
                  {"simplified-bytes", "bytes",
                   "Positions and indices of a simplified mesh that is as close, without heights", false},
                  {"rms", "units", "Distance from the surface before, root of the mean square"},
                  {"largest", "units", "Largest distance found from the surface before"}},
  };
  plugin.products = {baked_heights_product(), collapse_product()};
  OptionTable<Options> table;
  table.row(&Options::rms, "rms",
            "Distance from the surface to aim at, root of the mean square, as a share of the box's diagonal",
            {.least = 1e-7, .most = 0.1});
  table.row(&Options::cage, "cage", "Share of the triangles that the cage keeps; without it, several are tried",
            {.least = 0, .most = 0.5});
  table.row(&Options::finest, "finest", "Most parts of an edge, a power of two", {.least = 1, .most = 64});
  table.row(&Options::bits, "bits", "Bits of a height; without it, as many as the error needs",
            {.least = 4, .most = 16, .unit = "bits"});
  bind_options(plugin, table,
               [](const Options& options) { return std::make_unique<DisplacementBakeProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
