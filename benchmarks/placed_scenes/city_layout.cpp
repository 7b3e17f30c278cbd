#include "layout.h"

namespace foredraw::bench {

namespace {

constexpr double tile = city_tile;
constexpr std::uint64_t period = city_period;
constexpr double road_height = 0.073;  // of the surface that cars stand on
constexpr double car_height = 0.134;   // of a car's origin, its wheels on the road
constexpr double lane = 0.38;          // from the middle of the street to the middle of a lane
constexpr double kerb = 0.95;          // from there to lamps and traffic lights

constexpr double whole_turn = 6.283185307179586;
constexpr std::uint64_t dressing_seed = 0x6472657373;

/// Quarter turns that bring +Z to these directions.
enum Facing : std::uint64_t { south = 0, east = 1, north = 2, west = 3 };  // +Z, +X, -Z, -X

class City {
 public:
  City(const Kit& kit, const LayoutOptions& options, const CityDressing& dressing)
      : layout_(kit, options),
        dressing_(dressing),
        road_(kit.model("road_junction")),
        low_(kit.model("building_A")),
        middle_(kit.model("building_D")),
        high_(kit.model("building_H")),
        taxi_(kit.model("car_taxi")),
        police_(kit.model("car_police")),
        bench_(kit.model("bench")),
        lamp_(kit.model("streetlight")),
        signal_(kit.model("trafficlight_A")),
        tower_(kit.model("watertower")) {}

  std::vector<Placement> placements() {
    fill_square(layout_, [&](std::uint64_t x, std::uint64_t z) {
      Random random = layout_.random_of(x, z);
      dresser_ = layout_.random_of(x ^ dressing_seed, z);
      add_block({static_cast<double>(x * period) * tile, static_cast<double>(z * period) * tile}, random);
    });
    return layout_.take();
  }

 private:
  /// A crossing, the streets to the right of it and below it as seen from above, and the lots between these.
  void add_block(const glm::dvec2& corner, Random& random) {
    add_crossing(corner, random);
    for (const std::size_t ground : dressing_.grounds) {
      layout_.add(ground, corner + 0.5 * tile * static_cast<double>(period), 0, quarter_turn(0), glm::vec3(1),
                  dresser_);
    }
    for (std::uint64_t i = 1; i < period; ++i) {
      const double along = static_cast<double>(i) * tile;
      add_street({corner.x + along, corner.y}, true, i % 2 == 0, random);
      add_street({corner.x, corner.y + along}, false, i % 2 == 0, random);
    }
    for (std::uint64_t i = 1; i < period; ++i) {
      for (std::uint64_t j = 1; j < period; ++j) {
        add_lot(corner + tile * glm::dvec2(static_cast<double>(i), static_cast<double>(j)), i, j, random);
      }
    }
  }

  void add(std::size_t model, const glm::dvec2& place, double height, std::uint64_t quarters, Random& random,
           glm::vec3 scale = glm::vec3(1)) {
    layout_.add(model, place, height, quarter_turn(quarters), scale, random);
  }

  void add_crossing(const glm::dvec2& place, Random& random) {
    add(road_, place, 0, random.below(4), random);
    // Their arms reach over the road, to -X where they are not turned.
    add(signal_, place + glm::dvec2(kerb, kerb), road_height, 0, random);
    add(signal_, place + glm::dvec2(kerb, -kerb), road_height, 1, random);
    add(signal_, place + glm::dvec2(-kerb, -kerb), road_height, 2, random);
    add(signal_, place + glm::dvec2(-kerb, kerb), road_height, 3, random);
  }

  /// A tile of a street along x or along z: a lamp on one side, and what drives there, on the right.
  void add_street(const glm::dvec2& place, bool along_x, bool lamp_is_left, Random& random) {
    add(road_, place, 0, random.below(4), random);
    dress_street(place, along_x);
    const double side = lamp_is_left ? -kerb : kerb;
    if (along_x) {
      add(lamp_, place + glm::dvec2(0, side), road_height, lamp_is_left ? 1 : 3, random);
    } else {
      add(lamp_, place + glm::dvec2(side, 0), road_height, lamp_is_left ? 2 : 0, random);
    }
    for (const double way : {1.0, -1.0}) {
      const bool is_there = random.unit() < 0.35;
      const std::size_t car = random.unit() < 0.7 ? taxi_ : police_;
      const double ahead = way * (random.unit() - 0.5);
      if (!is_there) continue;
      if (along_x) {
        add(car, place + glm::dvec2(ahead, way * lane), car_height, way > 0 ? east : west, random);
      } else {
        add(car, place + glm::dvec2(-way * lane, ahead), car_height, way > 0 ? south : north, random);
      }
    }
  }

  /// Lots at a street hold buildings, now and then a square with benches; those behind them, yards.
  void add_lot(const glm::dvec2& place, std::uint64_t i, std::uint64_t j, Random& random) {
    std::vector<std::uint64_t> streets;
    if (i == 1) streets.push_back(west);
    if (i == period - 1) streets.push_back(east);
    if (j == 1) streets.push_back(north);
    if (j == period - 1) streets.push_back(south);
    const double kind = random.unit();
    if (streets.empty()) {
      add_yard(place, kind, random);
    } else if (kind < 0.1) {
      add_square(place, random);
    } else {
      const std::uint64_t facing = streets[random.below(streets.size())];
      const std::size_t building = kind < 0.5 ? low_ : kind < 0.8 ? middle_ : high_;
      const auto storeys = static_cast<float>(54 + random.below(28)) / 64;
      add(building, place, 0, facing, random, {1, storeys, 1});
    }
  }

  void add_yard(const glm::dvec2& place, double kind, Random& random) {
    if (kind < 0.3) add(tower_, place, 0, random.below(4), random);
    if (kind > 0.8) add(bench_, place, 0, random.below(4), random);
    dress_yard(place);
  }

  void add_square(const glm::dvec2& place, Random& random) {
    for (std::uint64_t quarters = 0; quarters < 4; ++quarters) {
      const glm::dvec2 sides[] = {{0, -0.5}, {-0.5, 0}, {0, 0.5}, {0.5, 0}};
      add(bench_, place + sides[quarters], 0, quarters, random);
    }
    add(lamp_, place, 0, random.below(4), random);
    dress_square(place);
  }

  /// One of the models, turned and larger or smaller, a little or not aside of the place; nothing where there are none.
  void dress(const std::vector<std::size_t>& models, const glm::dvec2& place, double height, double aside = 0) {
    if (models.empty()) return;
    const std::size_t model = models[dresser_.below(models.size())];
    const double angle = whole_turn * dresser_.unit();
    const auto size = static_cast<float>(54 + dresser_.below(20)) / 64;
    const double x = dresser_.unit() - 0.5, z = dresser_.unit() - 0.5;
    layout_.add(model, place + aside * glm::dvec2(x, z), height, turned(angle), glm::vec3(size), dresser_);
  }

  /// Trees and street furniture at both kerbs.
  void dress_street(const glm::dvec2& place, bool along_x) {
    for (const double side : {kerb, -kerb}) {
      for (int i = 0; i < 8; ++i) {
        const double along = (i - 3.5) * tile / 8;
        const glm::dvec2 there = along_x ? glm::dvec2(along, side) : glm::dvec2(side, along);
        dress(i % 4 == 1 ? dressing_.trees : dressing_.furniture, place + there, road_height);
      }
    }
  }

  void dress_yard(const glm::dvec2& place) {
    const glm::dvec2 corners[] = {{-0.55, -0.55}, {0.55, -0.55}, {0.55, 0.55}, {-0.55, 0.55}};
    for (const glm::dvec2& corner : corners) {
      dress(dressing_.trees, place + corner, 0, 0.3);
      dress(dressing_.shrubs, place + 1.45 * corner, 0, 0.2);
    }
    for (int i = 0; i < 3; ++i) dress(dressing_.rocks, place, 0, 1.2);
  }

  void dress_square(const glm::dvec2& place) {
    for (const double x : {-0.7, 0.7}) {
      dress(dressing_.statues, place + glm::dvec2(x, 0), 0);
      for (const double z : {-0.7, 0.7}) dress(dressing_.shrubs, place + glm::dvec2(x, z), 0, 0.1);
    }
  }

  Layout layout_;
  const CityDressing dressing_;
  Random dresser_{0};  ///< what there is beside the kit, so that the kit's own models stand as they do without it
  std::size_t road_, low_, middle_, high_, taxi_, police_, bench_, lamp_, signal_, tower_;
};

}  // namespace

std::vector<Placement> city_layout(const Kit& kit, const LayoutOptions& options, const CityDressing& dressing) {
  return City(kit, options, dressing).placements();
}

}  // namespace foredraw::bench
