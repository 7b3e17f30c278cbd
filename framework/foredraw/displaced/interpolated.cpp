#include <foredraw/displaced/interpolated.h>
#include <foredraw/scene/encode_component.h>
#include <foredraw/scene/skin_weights.h>
#include <foredraw/scene/stream_meaning.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw {

namespace {

/// The corners that have a share in a sample.
class Shares {
 public:
  Shares(std::span<const std::uint32_t> indices, const SurfaceSample& sample) {
    const auto weights = sample.at.weights();
    for (std::size_t c = 0; c < 3; ++c) {
      if (weights[c] == 0) continue;
      const std::uint32_t vertex = indices[std::size_t{3} * sample.triangle + c];
      vertex_[count_] = vertex;
      weight_[count_] = weights[c];
      ++count_;
      if (weights[c] > most_ || (weights[c] == most_ && vertex < heaviest_)) {
        heaviest_ = vertex;
        most_ = weights[c];
      }
    }
  }

  std::uint32_t heaviest() const { return heaviest_; }

  /// `value`: of a vertex, a float.
  template <class Value>
  float mixed(const Value& value) const {
    float sum = part(0) * value(vertex_[0]);
    for (std::size_t i = 1; i < count_; ++i) sum += part(i) * value(vertex_[i]);
    return std::isfinite(sum) ? sum : value(heaviest_);
  }

  /// The same for whole numbers.
  template <class Value>
  std::int64_t mixed_whole(const Value& value) const {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += std::int64_t{weight_[i]} * value(vertex_[i]);
    constexpr std::int64_t half = weight_one / 2;
    return (sum < 0 ? sum - half : sum + half) / weight_one;
  }

  /// Calls visit(vertex, share).
  template <class Visit>
  void each(const Visit& visit) const {
    for (std::size_t i = 0; i < count_; ++i) visit(vertex_[i], part(i));
  }

 private:
  float part(std::size_t i) const { return static_cast<float>(weight_[i]) / weight_one; }

  std::array<std::uint32_t, 3> vertex_{}, weight_{};
  std::size_t count_ = 0;
  std::uint32_t heaviest_ = 0, most_ = 0;
};

struct Source {
  std::span<const std::uint32_t> indices;
  std::span<const SurfaceSample> samples;
  std::uint32_t vertices = 0;

  /// Calls visit(number of the new vertex, shares).
  template <class Visit>
  void each(const Visit& visit) const {
    for (std::size_t i = 0; i < samples.size(); ++i) visit(vertices + i, Shares(indices, samples[i]));
  }
};

/// Components of type T, the others as they are in `bytes`.
template <class T>
void mix_amounts(const VertexStream& stream, const Source& source, std::span<std::byte> bytes) {
  const std::byte* from = stream.bytes.view().data();
  const std::size_t element = stream.format.bytes, components = stream.format.components;
  source.each([&](std::size_t vertex, const Shares& shares) {
    for (std::size_t c = 0; c < components; ++c) {
      const auto value = [&](std::uint32_t of) {
        T stored;
        std::memcpy(&stored, from + of * element + c * sizeof(T), sizeof(T));
        // Two codes mean -1.
        if constexpr (std::is_signed_v<T> && std::is_integral_v<T>) {
          if (stream.format.normalized) stored = std::max<T>(stored, -std::numeric_limits<T>::max());
        }
        return stored;
      };
      T mixed;
      if constexpr (std::is_integral_v<T>) {
        mixed = static_cast<T>(shares.mixed_whole(value));
      } else {
        mixed = shares.mixed(value);
      }
      std::memcpy(bytes.data() + vertex * element + c * sizeof(T), &mixed, sizeof(T));
    }
  });
}

void mix_amounts(const VertexStream& stream, const Source& source, std::span<std::byte> bytes) {
  switch (stream.format.component) {
    case Component::int8: return mix_amounts<std::int8_t>(stream, source, bytes);
    case Component::uint8: return mix_amounts<std::uint8_t>(stream, source, bytes);
    case Component::int16: return mix_amounts<std::int16_t>(stream, source, bytes);
    case Component::uint16: return mix_amounts<std::uint16_t>(stream, source, bytes);
    case Component::uint32: return mix_amounts<std::uint32_t>(stream, source, bytes);
    case Component::float32: return mix_amounts<float>(stream, source, bytes);
  }
}

/// The first three components; the others stay as they are in `bytes`.
void mix_directions(const VertexStream& stream, const Source& source, std::span<std::byte> bytes) {
  source.each([&](std::size_t vertex, const Shares& shares) {
    std::array<double, 3> mixed{};
    double squared = 0, largest = 0;  // of what was mixed
    for (std::size_t c = 0; c < 3; ++c) {
      mixed[c] = shares.mixed([&](std::uint32_t of) { return decode_component(stream, of, c); });
      squared += mixed[c] * mixed[c];
      shares.each([&](std::uint32_t of, float) {
        largest = std::max(largest, std::abs(double{decode_component(stream, of, c)}));
      });
    }
    constexpr double rounding = 1e-10;  // between opposite ones there is nothing but what rounding leaves
    if (!(squared > rounding * largest * largest)) return;
    const double length = std::sqrt(squared);
    const std::size_t size = bytes_of(stream.format.component);
    for (std::size_t c = 0; c < 3; ++c) {
      encode_component(bytes.data() + vertex * stream.format.bytes + c * size, stream.format,
                       static_cast<float>(mixed[c] / length));
    }
  });
}

/// Vertices and samples, with all bytes of those that have the most of them.
std::vector<std::byte> extended(const VertexStream& stream, const Source& source) {
  const std::span<const std::byte> from = stream.bytes.view();
  const std::size_t element = stream.format.bytes;
  std::vector<std::byte> bytes;
  bytes.reserve((source.vertices + source.samples.size()) * element);
  bytes.assign(from.begin(), from.end());
  source.each([&](std::size_t, const Shares& shares) {
    const auto row = from.subspan(shares.heaviest() * element, element);
    bytes.insert(bytes.end(), row.begin(), row.end());
  });
  return bytes;
}

std::vector<std::byte> mixed(const VertexStream& stream, bool is_base, const Source& source) {
  std::vector<std::byte> bytes = extended(stream, source);
  const bool holds_fractions = stream.format.component == Component::float32 || stream.format.normalized;
  if (is_base && is_direction(stream) && holds_fractions) {
    mix_directions(stream, source, bytes);
  } else if (is_amount(stream)) {
    mix_amounts(stream, source, bytes);
  }
  return bytes;
}

/// Influences of the corners on one sample.
class Influences {
 public:
  using Slot = SkinWeights::Slot;

  explicit Influences(const SkinWeights& weights) : weights_(weights) {}

  /// As many as the vertices have.
  std::span<const Slot> of(const Shares& shares) {
    slots_.clear();
    shares.each([&](std::uint32_t vertex, float share) {
      for (const Slot& slot : weights_.of(vertex)) {
        if (slot.weight * share > 0) slots_.push_back({slot.joint, slot.weight * share});
      }
    });
    // In one sequence, whichever corner comes first, so that sums are the same.
    std::ranges::sort(slots_, [](const Slot& a, const Slot& b) {
      return a.joint != b.joint ? a.joint < b.joint : a.weight < b.weight;
    });
    std::size_t joints = 0;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (joints > 0 && slots_[joints - 1].joint == slots_[i].joint) {
        slots_[joints - 1].weight += slots_[i].weight;
      } else {
        slots_[joints++] = slots_[i];
      }
    }
    slots_.resize(joints);
    std::ranges::sort(slots_, [](const Slot& a, const Slot& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
    });
    slots_.resize(weights_.slots());
    float whole = 0;
    for (const Slot& slot : slots_) whole += slot.weight;
    for (Slot& slot : slots_) slot.weight = whole > 0 ? slot.weight / whole : 0;
    return slots_;
  }

 private:
  const SkinWeights& weights_;
  std::vector<Slot> slots_;
};

}  // namespace

VertexStreams interpolated(const VertexStreams& vertices, std::span<const std::uint32_t> indices,
                           std::span<const SurfaceSample> samples) {
  const Source source{indices, samples, vertices.count};
  VertexStreams result = vertices;
  result.count = static_cast<std::uint32_t>(vertices.count + samples.size());
  std::vector<std::vector<std::byte>> base;
  for (const VertexStream& stream : vertices.base) base.push_back(mixed(stream, true, source));
  const SkinWeights weights(vertices);
  if (!weights.empty()) {
    Influences influences(weights);
    source.each([&](std::size_t vertex, const Shares& shares) {
      weights.write(influences.of(shares), vertex, vertices.base, base);
    });
  }
  for (std::size_t s = 0; s < base.size(); ++s) result.base[s].bytes = Shared<std::byte>(std::move(base[s]));
  for (auto& target : result.morph_targets) {
    for (VertexStream& stream : target) stream.bytes = Shared<std::byte>(mixed(stream, false, source));
  }
  return result;
}

}  // namespace foredraw
