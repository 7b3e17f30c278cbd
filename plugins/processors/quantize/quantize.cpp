#include "quantize.h"

#include "rounded_streams.h"

#include <cmath>

namespace foredraw {

namespace {

/// Rounds the streams of one VertexStreams, and collects what came of it.
class Rounding {
 public:
  Rounding(const VertexStreams& from, const Tolerances& tolerances, const std::atomic<bool>* cancel)
      : from_(from), tolerances_(tolerances), cancel_(cancel) {}

  Quantized run() {
    auto to = std::make_shared<VertexStreams>(from_);
    for (VertexStream& stream : to->base) round(stream, false);
    for (std::vector<VertexStream>& target : to->morph_targets) {
      for (VertexStream& stream : target) round(stream, true);
    }
    skin(*to);
    result_.vertices = std::move(to);
    return std::move(result_);
  }

 private:
  void round(VertexStream& stream, bool is_change) {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return;
    const std::string_view name = stream.semantic;
    QuantizedErrors& largest = result_.largest;
    if (name == "POSITION")
      put(stream, on_lattice(stream, tolerances_.position), tolerances_.position, largest.position);
    if (name.starts_with("TEXCOORD_")) put(stream, on_lattice(stream, tolerances_.uv), tolerances_.uv, largest.uv);
    if (name == "NORMAL" || name == "TANGENT") {
      // What a morph target adds to a direction of length 1 turns it by that length, in radians, at most by a little
      // more.
      const double added = chord_of(tolerances_.direction);
      auto made = is_change ? on_lattice(stream, added) : as_directions(stream, tolerances_.direction, cancel_);
      if (is_change && made.error > 0) made.error *= tolerances_.direction / added;
      put(stream, std::move(made), tolerances_.direction, largest.direction);
    }
    if (name.starts_with("COLOR_") && !is_change)
      put(stream, as_parts(stream, tolerances_.color), tolerances_.color, largest.color);
  }

  void skin(VertexStreams& to) {
    if (tolerances_.weight <= 0) return;
    SkinStreams made = as_few_weights(to, tolerances_.weight);
    result_.largest.weight = made.error;
    if (!made.plain.empty()) result_.plain.push_back(std::move(made.plain));
    for (auto& [index, stream] : made.streams) to.base[index] = std::move(stream);
  }

  void put(VertexStream& stream, RoundedStream made, double tolerance, double& largest) {
    if (tolerance <= 0) return;
    if (!made.plain.empty()) result_.plain.push_back(stream.semantic + ", " + made.plain);
    if (!made.stream) return;
    largest = std::max(largest, made.error);
    stream = std::move(*made.stream);
  }

  const VertexStreams& from_;
  const Tolerances& tolerances_;
  const std::atomic<bool>* cancel_;
  Quantized result_;
};

}  // namespace

std::vector<int> lattice_exponents(double distance, std::size_t components) {
  // The middle of a cell is the farthest: half of its diagonal. In cells of the least size, whose square is 1:
  const double least = std::ldexp(1.0, std::ilogb(2 * distance / std::sqrt(static_cast<double>(components))));
  const double squares = 4 * (distance / least) * (distance / least);
  std::vector<int> exponents(components, std::ilogb(least));
  if (components == 3 && 4 + 1 + 4 <= squares) {
    ++exponents[0];
    ++exponents[2];
  } else if (components > 1 && static_cast<double>(components - 1) + 4 <= squares) {
    ++exponents[1];
  }
  return exponents;
}

Quantized quantize(const VertexStreams& vertices, const Tolerances& tolerances, const std::atomic<bool>* cancel) {
  return Rounding(vertices, tolerances, cancel).run();
}

}  // namespace foredraw
