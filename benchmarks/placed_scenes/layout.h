#pragma once
// Where the models of a kit stand in a scene of many instances.

#include "kit.h"

#include <foredraw/base/random.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace foredraw::bench {

struct LayoutOptions {
  std::uint64_t instances = 10'000;  ///< placed primitives to reach; fewer than a model's are added beyond it
  std::uint64_t seed = 1;
  double mirrored = 0;  ///< the part of the models that is turned inside out (scaled by -1 along x), 0 to 1
};

/// What a city has beside the models of its kit, as numbers of models; empty ones are not placed. Trees and furniture
/// stand at the kerbs, trees, shrubs and rocks in yards, statues and shrubs in squares.
struct CityDressing {
  std::vector<std::size_t> trees, shrubs, rocks, furniture, statues;
  std::vector<std::size_t> grounds;  ///< all of these lie in the middle of each block
};

constexpr double city_tile = 2;           ///< the side of a road tile and of a lot
constexpr std::uint64_t city_period = 5;  ///< tiles from street to street: one of road, four of lots

/// Streets that part blocks of buildings, with traffic and street furniture; of the kit kaykit_city. A larger city of
/// the same seed holds the smaller one. Units as the kit has them: a tile has 2; the
/// middles of streets are multiples of city_period tiles from 0.
std::vector<Placement> city_layout(const Kit& kit, const LayoutOptions& options, const CityDressing& dressing = {});

/// Bases, ports and fields of rocks, scattered on a plain; of the kit kenney_space_kit. A larger plain of the same seed
/// holds the smaller one.
std::vector<Placement> space_layout(const Kit& kit, const LayoutOptions& options);

/// Placements as they are added, until there are enough.
class Layout {
 public:
  Layout(const Kit& kit, const LayoutOptions& options) : kit_(kit), options_(options) {}

  bool is_full() const { return instances_ >= options_.instances; }

  /// Adds a model unless there are enough; `random` says whether it is mirrored. Coordinates are rounded to 1/1024, so
  /// that they take few digits.
  void add(std::size_t model, glm::dvec2 place, double height, const glm::quat& rotation, glm::vec3 scale,
           Random& random);

  /// What happens in one cell of a plane, whatever happens in others.
  Random random_of(std::uint64_t x, std::uint64_t z) const { return Random(derive_seed(options_.seed, x, z)); }

  std::vector<Placement> take() { return std::move(placements_); }

 private:
  const Kit& kit_;
  LayoutOptions options_;
  std::vector<Placement> placements_;
  std::uint64_t instances_ = 0;
};

/// Turned about +Y, to the left as seen from above: by quarters of a circle, or by an angle in radians.
glm::quat quarter_turn(std::uint64_t quarters);
glm::quat turned(double angle);

/// Calls cell(x, z) for the cells of a square that grows from (0, 0), row by row round two of its sides, until the
/// layout is full.
template <class Cell>
void fill_square(const Layout& layout, const Cell& cell) {
  for (std::uint64_t side = 0; !layout.is_full(); ++side) {
    for (std::uint64_t i = 0; i <= side; ++i) cell(side, i);
    for (std::uint64_t i = 0; i < side; ++i) cell(i, side);
  }
}

}  // namespace foredraw::bench
