// Weights of a skin, rounded so that those of a vertex still sum up to 1.
#include "rounded_streams.h"

#include <foredraw/scene/skin_weights.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foredraw {

namespace {

/// Whole numbers that sum up to what the weights do, which is `one` as a rule: rounded down, and what is missing goes
/// to those that lost the most. Some files have vertices whose weights sum up to less; viewers differ in what they do
/// then.
std::vector<std::uint32_t> shares(std::span<const SkinWeights::Slot> row, std::uint32_t one) {
  double sum = 0;
  for (const auto& slot : row) sum += slot.weight;
  std::vector<std::uint32_t> whole(row.size());
  std::vector<double> lost(row.size());
  auto left = static_cast<std::uint32_t>(std::lround(sum * one));
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double exact = std::min(double(row[i].weight), 1.0) * one;
    whole[i] = static_cast<std::uint32_t>(exact);
    lost[i] = exact - whole[i];
    left -= std::min(left, whole[i]);
  }
  std::vector<std::size_t> by_loss(row.size());
  std::iota(by_loss.begin(), by_loss.end(), 0u);
  std::ranges::stable_sort(by_loss, [&](std::size_t a, std::size_t b) { return lost[a] > lost[b]; });
  for (std::size_t i = 0; left > 0 && i < by_loss.size(); ++i) {
    if (whole[by_loss[i]] == one) continue;
    ++whole[by_loss[i]];
    --left;
  }
  return whole;
}

struct Rounded {
  std::vector<std::uint32_t> weights, joints;  ///< [vertex * slots + slot]
  double error = 0;
  std::uint32_t last_joint = 0;
};

Rounded rounded(const SkinWeights& skin, std::uint32_t vertices, std::uint32_t one) {
  Rounded result;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto row = skin.of(v);
    const std::vector<std::uint32_t> whole = shares(row, one);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::uint32_t joint = whole[i] == 0 ? 0 : row[i].joint;
      result.weights.push_back(whole[i]);
      result.joints.push_back(joint);
      result.last_joint = std::max(result.last_joint, joint);
      result.error = std::max(result.error, std::abs(whole[i] / double(one) - double(row[i].weight)));
    }
  }
  return result;
}

/// Every slots-th row of four, as T.
template <class T>
VertexStream part(const std::string& semantic, const std::vector<std::uint32_t>& values, std::size_t slots,
                  std::size_t first, bool normalized) {
  std::vector<T> made;
  for (std::size_t row = first; row < values.size(); row += slots) {
    for (std::size_t i = 0; i < 4; ++i) made.push_back(static_cast<T>(values[row + i]));
  }
  const auto bytes = std::as_bytes(std::span(made));
  const Component component = sizeof(T) == 1 ? Component::uint8 : Component::uint16;
  return {semantic, {component, 4, normalized, 4 * sizeof(T)}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

VertexStream part(const std::string& semantic, const std::vector<std::uint32_t>& values, std::size_t slots,
                  std::size_t first, bool normalized, bool is_wide) {
  return is_wide ? part<std::uint16_t>(semantic, values, slots, first, normalized)
                 : part<std::uint8_t>(semantic, values, slots, first, normalized);
}

/// But for what floats round.
bool are_parts(const SkinWeights& skin, std::uint32_t vertices) {
  for (std::uint32_t v = 0; v < vertices; ++v) {
    for (const auto& slot : skin.of(v)) {
      if (!(slot.weight >= 0 && slot.weight <= 1.001f)) return false;
    }
  }
  return true;
}

}  // namespace

SkinStreams as_few_weights(const VertexStreams& vertices, double error) {
  SkinStreams result;
  const SkinWeights skin(vertices);
  if (skin.empty() || vertices.count == 0) return result;
  if (!are_parts(skin, vertices.count)) {
    result.plain = "WEIGHTS_0, some of which are not from 0 to 1";
    return result;
  }
  Rounded made = rounded(skin, vertices.count, 255);
  const bool is_wide = made.error > error;
  if (is_wide) made = rounded(skin, vertices.count, 65535);
  result.error = made.error;
  for (std::size_t set = 0; 4 * set < skin.slots(); ++set) {
    for (const bool is_weights : {false, true}) {
      const std::string semantic = (is_weights ? "WEIGHTS_" : "JOINTS_") + std::to_string(set);
      const auto at = std::ranges::find(vertices.base, semantic, &VertexStream::semantic);
      if (at == vertices.base.end()) continue;
      const auto index = static_cast<std::size_t>(at - vertices.base.begin());
      result.streams.emplace_back(
          index, is_weights ? part(semantic, made.weights, skin.slots(), 4 * set, true, is_wide)
                            : part(semantic, made.joints, skin.slots(), 4 * set, false, made.last_joint > 255));
    }
  }
  return result;
}

}  // namespace foredraw
