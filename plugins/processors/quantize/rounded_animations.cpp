#include "rounded_animations.h"

#include "quantize.h"
#include "rounded_streams.h"

#include <foredraw/scene/coded_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace foredraw {

namespace {

using Value = std::array<double, 4>;

double dot(const Value& a, const Value& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

Value mixed(const Value& a, double of_a, const Value& b, double of_b) {
  Value result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = of_a * a[i] + of_b * b[i];
  return result;
}

Value unit(const Value& value) {
  const double length = std::sqrt(dot(value, value));
  return length > 0 ? mixed(value, 1 / length, value, 0) : Value{0, 0, 0, 1};
}

/// Along the shortest arc between unit quaternions. By halves: the system's sine may differ from machine to machine.
Value on_arc(Value from, Value to, double t) {
  if (dot(from, to) < 0) to = mixed(to, -1, to, 0);
  for (int i = 0; i < 24; ++i) {
    const Value middle = unit(mixed(from, 1, to, 1));
    t *= 2;
    if (t < 1) {
      to = middle;
    } else {
      from = middle;
      t -= 1;
    }
  }
  return unit(mixed(from, 1 - t, to, t));
}

/// One channel, before and after its values were rounded.
class Track {
 public:
  Track(const AnimationChannel& channel, double tolerance)
      : is_rotation_(channel.path == AnimatedPath::rotation),
        steps_(channel.interpolation == Interpolation::step),
        parts_(is_rotation_ ? 4 : 3),
        times_(channel.times.view()),
        was_(channel.values.view()),
        // Unit quaternions lie apart by the sine of a quarter of the angle, twice.
        most_(is_rotation_ ? chord_of(tolerance / 2) : tolerance) {}

  std::size_t keys() const { return times_.size(); }

  /// To half of the tolerance, so that keys can be left out too. False where there is no such rounding.
  bool round() {
    now_.resize(was_.size());
    return is_rotation_ ? round_rotations() : round_on_lattice();
  }

  bool stands_still() const {
    for (std::size_t k = 0; k < keys(); ++k) {
      if (off(k, now(0)) > most_) return false;
    }
    return true;
  }

  /// Whether all keys between the two are near enough to what those two make of them.
  bool spans(std::size_t from, std::size_t to) const {
    for (std::size_t k = from + 1; k < to; ++k) {
      if (off(k, between(from, to, k)) > most_) return false;
    }
    return true;
  }

  /// Of the keys that there were, with `kept` (rising, key 0 among them) alone left; in the tolerance's unit.
  double error(const std::vector<std::size_t>& kept) const {
    double largest = 0;
    for (std::size_t k = 0, i = 0; k < keys(); ++k) {
      if (i + 1 < kept.size() && kept[i + 1] <= k) ++i;
      const bool is_last = i + 1 == kept.size();
      largest = std::max(largest, off(k, is_last ? now(kept[i]) : between(kept[i], kept[i + 1], k)));
    }
    return is_rotation_ ? 4 * std::asin(std::min(largest / 2, 1.0)) / 0.017453292519943295 : largest;
  }

  std::vector<float> values(const std::vector<std::size_t>& kept) const {
    std::vector<float> result;
    for (const std::size_t k : kept) {
      result.insert(result.end(), now_.begin() + static_cast<std::ptrdiff_t>(k * parts_),
                    now_.begin() + static_cast<std::ptrdiff_t>((k + 1) * parts_));
    }
    return result;
  }

 private:
  Value at(std::span<const float> values, std::size_t key) const {
    Value value{};
    for (std::size_t i = 0; i < parts_; ++i) value[i] = values[key * parts_ + i];
    return is_rotation_ ? unit(value) : value;
  }
  Value now(std::size_t key) const { return at(now_, key); }

  /// How far a value is from that of a key as it was.
  double off(std::size_t key, const Value& value) const {
    const Value wanted = at(was_, key);
    const double sign = is_rotation_ && dot(wanted, value) < 0 ? -1 : 1;
    const Value difference = mixed(wanted, 1, value, -sign);
    return std::sqrt(dot(difference, difference));
  }

  Value between(std::size_t from, std::size_t to, std::size_t key) const {
    if (steps_ || key == from) return now(from);
    const double length = double(times_[to]) - times_[from];
    const double t = length > 0 ? (double(times_[key]) - times_[from]) / length : 0;
    return is_rotation_ ? on_arc(now(from), now(to), t) : mixed(now(from), 1 - t, now(to), t);
  }

  /// With as few bits as will do for all keys. Where they will not, a key near the begin mostly says so.
  bool round_rotations() {
    for (int bits = 4; bits <= 16; ++bits) {
      if (round_rotations_to(bits)) return true;
    }
    return false;
  }

  bool round_rotations_to(int bits) {
    for (std::size_t k = 0; k < keys(); ++k) {
      const auto whole = rotation_of(nearest_rotation(at(was_, k), bits));
      for (std::size_t i = 0; i < 4; ++i) now_[4 * k + i] = static_cast<float>(whole[i]) / 32767.0f;
      if (off(k, now(k)) > most_ / 2) return false;
    }
    return true;
  }

  bool round_on_lattice() {
    const std::vector<int> exponents = lattice_exponents(most_ / 2, parts_);
    for (std::size_t i = 0; i < was_.size(); ++i) {
      const int exponent = exponents[i % parts_];
      const double number = std::round(std::ldexp(double(was_[i]), -exponent));
      if (!(std::abs(number) < (1 << 23))) return false;
      now_[i] = static_cast<float>(std::ldexp(number, exponent)) + 0.0f;  // no -0
    }
    return true;
  }

  bool is_rotation_, steps_;
  std::size_t parts_;
  std::span<const float> times_, was_;
  double most_;
  std::vector<float> now_;
};

double tolerance_of(const AnimationChannel& channel, const KeyTolerances& tolerances, double unit) {
  switch (channel.path) {
    case AnimatedPath::translation: return unit > 0 ? tolerances.translation / unit : 0;
    case AnimatedPath::rotation: return tolerances.rotation;
    case AnimatedPath::scale: return tolerances.scale;
    case AnimatedPath::weights: break;
  }
  return 0;
}

bool can_be_rounded(const AnimationChannel& channel, double tolerance) {
  const auto is_finite = [](float value) { return std::isfinite(value); };
  const std::size_t parts = channel.path == AnimatedPath::rotation ? 4 : 3;
  return tolerance > 0 && channel.interpolation != Interpolation::cubic_spline && !channel.times.empty() &&
         channel.values.size() == channel.times.size() * parts &&
         std::ranges::all_of(channel.values.view(), is_finite) && std::ranges::all_of(channel.times.view(), is_finite);
}

/// As few keys as will do for all of the tracks, which have the same times: each as far from the one before as may be.
std::vector<std::size_t> kept_keys(std::span<const Track> tracks, std::span<const std::size_t> members) {
  constexpr std::size_t longest = 256;  // so that the time stays in proportion to the keys
  const std::size_t count = tracks[members.front()].keys();
  const auto all_span = [&](std::size_t from, std::size_t to) {
    return std::ranges::all_of(members, [&](std::size_t m) { return tracks[m].spans(from, to); });
  };
  std::vector<std::size_t> kept{0};
  while (kept.back() + 1 < count) {
    const std::size_t from = kept.back();
    std::size_t to = from + 1;
    while (to + 1 < count && to + 1 - from <= longest && all_span(from, to + 1)) ++to;
    kept.push_back(to);
  }
  return kept;
}

/// The tracks of an animation, and which keys of each are kept.
class KeyRounding {
 public:
  KeyRounding(const Animation& animation, const KeyTolerances& tolerances, std::span<const double> units)
      : animation_(animation), units_(units) {
    for (std::size_t c = 0; c < animation.channels.size(); ++c) {
      const AnimationChannel& channel = animation.channels[c];
      const double tolerance = tolerance_of(channel, tolerances, units[channel.node]);
      if (!can_be_rounded(channel, tolerance)) continue;
      Track track(channel, tolerance);
      if (!track.round()) continue;
      channels_.push_back(c);
      tracks_.push_back(std::move(track));
    }
  }

  RoundedAnimation run() {
    choose_keys();
    keep_the_end();
    RoundedAnimation result{animation_, {}, 0, 0};
    for (std::size_t t = 0; t < tracks_.size(); ++t) put(t, result);
    for (const AnimationChannel& channel : animation_.channels) result.keys_before += channel.times.size();
    for (const AnimationChannel& channel : result.animation.channels) result.keys_after += channel.times.size();
    return result;
  }

 private:
  const AnimationChannel& channel(std::size_t track) const { return animation_.channels[channels_[track]]; }

  void choose_keys() {
    kept_.assign(tracks_.size(), {0});
    std::map<Stamp, std::vector<std::size_t>> moving;  // by their times
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      if (!tracks_[t].stands_still()) moving[channel(t).times.stamp()].push_back(t);
    }
    for (const auto& [times, members] : moving) {
      const std::vector<std::size_t> keys = kept_keys(tracks_, members);
      for (const std::size_t t : members) kept_[t] = keys;
    }
  }

  /// The animation ends with its last key, which one track that stands still may have to keep.
  void keep_the_end() {
    float end = -std::numeric_limits<float>::infinity();
    for (const AnimationChannel& one : animation_.channels) {
      if (!one.times.empty()) end = std::max(end, one.times.view().back());
    }
    std::optional<std::size_t> last;
    std::size_t track = 0;
    for (std::size_t c = 0; c < animation_.channels.size(); ++c) {
      const auto times = animation_.channels[c].times.view();
      const bool is_rounded = track < channels_.size() && channels_[track] == c;
      const std::size_t t = is_rounded ? track++ : tracks_.size();
      if (times.empty() || times.back() != end) continue;
      if (!is_rounded || times[kept_[t].back()] == end) return;
      if (!last) last = t;
    }
    if (last) kept_[*last].push_back(tracks_[*last].keys() - 1);
  }

  void put(std::size_t t, RoundedAnimation& result) const {
    AnimationChannel& to = result.animation.channels[channels_[t]];
    double& largest = to.path == AnimatedPath::rotation ? result.largest.rotation
                      : to.path == AnimatedPath::scale  ? result.largest.scale
                                                        : result.largest.translation;
    const double unit = to.path == AnimatedPath::translation ? units_[to.node] : 1;
    largest = std::max(largest, tracks_[t].error(kept_[t]) * unit);
    if (kept_[t].size() < tracks_[t].keys()) {
      std::vector<float> times;
      for (const std::size_t k : kept_[t]) times.push_back(channel(t).times.view()[k]);
      to.times = Shared<float>(std::move(times));
    }
    to.values = Shared<float>(tracks_[t].values(kept_[t]));
  }

  const Animation& animation_;
  std::span<const double> units_;
  std::vector<Track> tracks_;
  std::vector<std::size_t> channels_;           ///< [track] its channel
  std::vector<std::vector<std::size_t>> kept_;  ///< [track] keys
};

}  // namespace

RoundedAnimation rounded(const Animation& animation, const KeyTolerances& tolerances, std::span<const double> units) {
  return KeyRounding(animation, tolerances, units).run();
}

}  // namespace foredraw
