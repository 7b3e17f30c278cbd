#include <foredraw/frames/cost_fit.h>

#include <foredraw/frames/non_negative_least_squares.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace foredraw {

namespace {

constexpr std::size_t renderings = all_renderings.size();
constexpr std::size_t unknowns = 3 + 3 * renderings;  // frame, draw, posed; of each rendering pixel, vertex, triangle

std::size_t number_of(Rendering rendering) { return static_cast<std::size_t>(rendering); }
std::size_t pixel_of(Rendering rendering) { return 3 + 3 * number_of(rendering); }

bool is_amount(double value) { return value >= 0 && value <= std::numeric_limits<float>::max(); }

bool is_usable(const FrameSample& sample) {
  const bool has_time = sample.nanoseconds > 0 && std::isfinite(sample.nanoseconds);
  return has_time && std::ranges::all_of(sample.drawn, [](const ObjectWork& work) {
           return is_amount(work.triangles) && is_amount(work.vertices) && is_amount(work.pixels) &&
                  is_amount(work.draws) && work.posed >= 0 && work.posed <= work.vertices;
         });
}

/// Which of an object's stages count.
enum class Slower : std::uint8_t { geometry, pixels, both };

class Fit {
 public:
  explicit Fit(std::span<const FrameSample> samples) {
    for (const FrameSample& sample : samples) {
      if (!is_usable(sample)) continue;
      used_.push_back(&sample);
      for (const ObjectWork& work : sample.drawn) is_drawn_[number_of(work.rendering)] = true;
    }
  }

  RenderingCosts of_sum() const {
    RenderingCosts costs = solved({});
    costs.stages = Stages::sum;
    return with_others(costs);
  }

  RenderingCosts of_max() const {
    constexpr int most_rounds = 32;
    RenderingCosts best;
    double least = std::numeric_limits<double>::infinity();
    for (const double share : beginnings()) {
      std::vector<Slower> slower = split_at(share);
      for (int round = 0; round < most_rounds; ++round) {
        const RenderingCosts costs = solved(slower);
        if (const double squares = squares_of(costs); squares < least) least = squares, best = costs;
        std::vector<Slower> next = slower_in(costs);
        if (next == slower) break;
        slower = std::move(next);
      }
    }
    return with_others(best);
  }

 private:
  /// What fits best where it is known which stage counts, object after object; none: both do.
  RenderingCosts solved(const std::vector<Slower>& slower) const {
    std::vector<double> rows, wanted(used_.size(), 1.0);
    std::size_t object = 0;
    for (const FrameSample* sample : used_) {
      double row[unknowns] = {1};
      for (const ObjectWork& work : sample->drawn) {
        const Slower counts = slower.empty() ? Slower::both : slower[object++];
        double* of = row + pixel_of(work.rendering);
        row[1] += work.draws;
        if (counts != Slower::geometry) of[0] += work.pixels;
        if (counts != Slower::pixels) of[1] += work.vertices, of[2] += work.triangles, row[2] += work.posed;
      }
      for (const double amount : row) rows.push_back(amount / sample->nanoseconds);
    }
    const std::vector<double> x = non_negative_least_squares(rows, wanted, unknowns);
    RenderingCosts costs;
    costs.frame = x[0];
    costs.draw = x[1];
    costs.posed = x[2];
    for (const Rendering rendering : all_renderings) {
      const double* of = x.data() + pixel_of(rendering);
      costs.of(rendering) = {.triangle = of[2], .vertex = of[1], .pixel = of[0]};
    }
    return costs;
  }

  template <class See>
  void each_object(See see) const {
    for (const FrameSample* sample : used_) {
      for (const ObjectWork& work : sample->drawn) see(work);
    }
  }

  static double pixels_for_geometry(const ObjectWork& work) {
    const double geometry = work.triangles + work.vertices;
    return geometry > 0 ? work.pixels / geometry : std::numeric_limits<double>::infinity();
  }

  /// Where to split objects at first: below all that they have, and evenly among these.
  std::vector<double> beginnings() const {
    constexpr std::size_t parts = 8;
    std::vector<double> shares, places{-1};
    each_object([&](const ObjectWork& work) { shares.push_back(pixels_for_geometry(work)); });
    std::ranges::sort(shares);
    for (std::size_t i = 0; i <= parts && !shares.empty(); ++i)
      places.push_back(shares[i * (shares.size() - 1) / parts]);
    return places;
  }

  std::vector<Slower> split_at(double share) const {
    std::vector<Slower> slower;
    each_object([&](const ObjectWork& work) {
      slower.push_back(pixels_for_geometry(work) > share ? Slower::pixels : Slower::geometry);
    });
    return slower;
  }

  std::vector<Slower> slower_in(const RenderingCosts& costs) const {
    std::vector<Slower> slower;
    each_object([&](const ObjectWork& work) {
      const RenderingCost& of = costs.of(work.rendering);
      const double geometry = of.triangle * work.triangles + of.vertex * work.vertices + costs.posed * work.posed;
      slower.push_back(geometry >= of.pixel * work.pixels ? Slower::geometry : Slower::pixels);
    });
    return slower;
  }

  double squares_of(const RenderingCosts& costs) const {
    double squares = 0;
    for (const FrameSample* sample : used_) {
      const double off = frame_cost(costs, sample->drawn) / sample->nanoseconds - 1;
      squares += off * off;
    }
    return squares;
  }

  /// Renderings that were never drawn cost what others do.
  RenderingCosts with_others(RenderingCosts costs) const {
    std::optional<RenderingCost> before;
    for (std::size_t i = 0; i < renderings; ++i) {
      for (std::size_t j = i; !before && j < renderings; ++j) {
        if (is_drawn_[j]) before = costs.renderings[j];
      }
      if (is_drawn_[i]) before = costs.renderings[i];
      if (before) costs.renderings[i] = *before;
    }
    return costs;
  }

  std::vector<const FrameSample*> used_;
  std::array<bool, renderings> is_drawn_ = {};
};

}  // namespace

RenderingCosts fit_costs(std::span<const FrameSample> samples, Stages stages) {
  return stages == Stages::sum ? Fit(samples).of_sum() : Fit(samples).of_max();
}

FitError fit_error(const RenderingCosts& costs, std::span<const FrameSample> samples) {
  FitError error;
  for (const FrameSample& sample : samples) {
    if (!is_usable(sample)) continue;
    const double off = std::abs(frame_cost(costs, sample.drawn) / sample.nanoseconds - 1);
    error.mean += off;
    error.most = std::max(error.most, off);
    ++error.samples;
  }
  if (error.samples > 0) error.mean /= static_cast<double>(error.samples);
  return error;
}

}  // namespace foredraw
