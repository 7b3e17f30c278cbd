#include "layout.h"

#include <foredraw/scene/turn.h>

#include <cmath>
#include <string_view>

namespace foredraw::bench {

namespace {

constexpr double pitch = 48;      // from cluster to cluster
constexpr double distance = 2.8;  // between neighbours in a cluster
constexpr double golden_angle = 2.399963229728653;
constexpr double circle = 6.283185307179586;

/// What a cluster is made of; what is named twice is there twice as often.
const std::vector<std::vector<std::string_view>> mixes = {
    {"hangar_largeA", "machine_generator", "machine_generator", "satelliteDish_detailed", "gate_complex", "rover",
     "astronautA", "astronautA", "monorail_trainCargo"},
    {"rocket_baseA", "craft_cargoA", "craft_miner", "machine_generator", "rover", "astronautA", "monorail_trainCargo"},
    {"rock_crystalsLargeA", "rock_crystalsLargeA", "rock_crystalsLargeA", "alien", "craft_miner"},
};

class Plain {
 public:
  Plain(const Kit& kit, const LayoutOptions& options) : layout_(kit, options) {
    for (const auto& mix : mixes) {
      auto& models = mixes_.emplace_back();
      for (const std::string_view name : mix) models.push_back(kit.model(name));
    }
    rock_ = kit.model("rock_crystalsLargeA");
  }

  std::vector<Placement> placements() {
    fill_square(layout_, [&](std::uint64_t x, std::uint64_t z) {
      Random random = layout_.random_of(x, z);
      const glm::dvec2 corner(static_cast<double>(x) * pitch, static_cast<double>(z) * pitch);
      add_cluster(corner + some_place(random), random);
      for (int i = 0; i < 6; ++i) add(rock_, corner + some_place(random), random);
    });
    return layout_.take();
  }

 private:
  static glm::dvec2 some_place(Random& random) {
    const double x = random.unit(), z = random.unit();
    return pitch * glm::dvec2(x, z);
  }

  /// Along a spiral that fills a disc evenly, so that models stand apart.
  void add_cluster(const glm::dvec2& middle, Random& random) {
    const std::vector<std::size_t>& mix = mixes_[random.below(mixes_.size())];
    const std::uint64_t count = 12 + random.below(40);
    for (std::uint64_t i = 0; i < count; ++i) {
      const double radius = distance * 0.6 * std::sqrt(static_cast<double>(i));
      const Turn turn = turn_by(golden_angle * static_cast<double>(i));
      const std::size_t model = mix[random.below(mix.size())];
      add(model, middle + radius * glm::dvec2(turn.cosine, turn.sine), random);
    }
  }

  void add(std::size_t model, const glm::dvec2& place, Random& random) {
    const double angle = circle * random.unit();
    const auto size = static_cast<float>(48 + random.below(36)) / 64;
    const float height = model == rock_ ? static_cast<float>(48 + random.below(64)) / 64 : size;
    layout_.add(model, place, 0, turned(angle), {size, height, size}, random);
  }

  Layout layout_;
  std::vector<std::vector<std::size_t>> mixes_;
  std::size_t rock_ = 0;
};

}  // namespace

std::vector<Placement> space_layout(const Kit& kit, const LayoutOptions& options) {
  return Plain(kit, options).placements();
}

}  // namespace foredraw::bench
