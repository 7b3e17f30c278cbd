#include "level_choosers.h"

#include <algorithm>
#include <cmath>

namespace foredraw::evaluators::lod_walk {

namespace {

/// Levels by the size of triangles; none: by a size below every triangle's.
class BySize : public LevelChooser {
 public:
  BySize(const FrameScene& scene, const std::vector<MeshWays>& meshes, double pixels)
      : scene_(scene), meshes_(meshes), pixels_(pixels) {}

  std::vector<std::uint32_t> choose(const FrameWays& frame, const std::vector<WayName>&) override {
    std::vector<std::uint32_t> chosen;
    for (std::size_t i = 0; i < frame.seen.size(); ++i) {
      const MeshWays& mesh = meshes_[scene_.objects()[frame.seen[i].object].mesh];
      chosen.push_back(way_of(frame, i, {level_by_size(mesh, frame.seen[i].pixels, pixels_), Rendering::full}));
    }
    return chosen;
  }

 protected:
  const FrameScene& scene_;
  const std::vector<MeshWays>& meshes_;
  double pixels_;
};

class FedBack final : public BySize {
 public:
  FedBack(const FrameScene& scene, const std::vector<MeshWays>& meshes, const ChooserOptions& options)
      : BySize(scene, meshes, options.pixels), budget_(options.budget) {}

  void took(double nanoseconds) override {
    const float next = foredraw_lod_fed_back(static_cast<float>(pixels_), static_cast<float>(nanoseconds),
                                             static_cast<float>(budget_));
    pixels_ = std::clamp(static_cast<double>(next), 1e-3, 1e6);  // so that it comes back from where nothing is seen
  }

 private:
  double budget_;
};

/// With hysteresis a two-hundredth of the budget is left, and the last choice is drawn again while it fits and loses
/// little more than the new one.
class Budget final : public LevelChooser {
 public:
  explicit Budget(const ChooserOptions& options) : options_(options) {}

  std::vector<std::uint32_t> choose(const FrameWays& frame, const std::vector<WayName>& last) override {
    constexpr double more_loss = 0.2;
    const std::vector<foredraw_lod_way> ways = with_hysteresis(frame, last, options_.hysteresis);
    const foredraw_lod_scene scene = frame.scene(ways);
    const auto budget = static_cast<std::uint64_t>(options_.budget);
    const bool may_keep = options_.hysteresis > 0;
    std::vector<std::uint32_t> chosen(frame.seen.size());
    memory_.resize(foredraw_lod_memory(&scene) / sizeof(std::uint64_t) + 1);
    foredraw_lod_select(&scene, may_keep ? budget - budget / 200 : budget, chosen.data(), memory_.data());
    if (!may_keep) return chosen;
    std::vector<std::uint32_t> kept = chosen;  // of objects that were not seen before
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const WayName& before = last[frame.seen[i].object];
      if (before.level != not_seen) kept[i] = way_of(frame, i, before);
    }
    const foredraw_lod_scene plain = frame.scene(frame.ways);
    return foredraw_lod_may_keep(&plain, budget, kept.data(), chosen.data(), more_loss) ? kept : chosen;
  }

 private:
  ChooserOptions options_;
  std::vector<std::uint64_t> memory_;
};

}  // namespace

std::unique_ptr<LevelChooser> level_chooser(Method method, const FrameScene& scene, const std::vector<MeshWays>& meshes,
                                            const ChooserOptions& options) {
  switch (method) {
    case Method::none: return std::make_unique<BySize>(scene, meshes, 0);
    case Method::by_size: return std::make_unique<BySize>(scene, meshes, options.pixels);
    case Method::fed_back: return std::make_unique<FedBack>(scene, meshes, options);
    case Method::budget: break;
  }
  return std::make_unique<Budget>(options);
}

std::uint32_t way_of(const FrameWays& frame, std::size_t seen, const WayName& name) {
  const auto begin = frame.names.begin() + frame.first[seen], end = frame.names.begin() + frame.first[seen + 1];
  return static_cast<std::uint32_t>(std::find(begin, end, name) - begin);
}

}  // namespace foredraw::evaluators::lod_walk
