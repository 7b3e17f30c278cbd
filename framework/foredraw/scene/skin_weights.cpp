#include <foredraw/scene/encode_component.h>
#include <foredraw/scene/skin_weights.h>

#include <string>

namespace foredraw {

namespace {

/// Numbers of joints are whole, whatever holds them; what is none names the first one.
std::uint32_t joint_of(float value) {
  constexpr float end = 4294967296.0f;
  return value >= 0 && value < end ? static_cast<std::uint32_t>(value) : 0;
}

/// No number is no weight. Any weights add up to a number.
float weight_of(float value) {
  constexpr float most = 1e30f;
  return std::isfinite(value) ? std::clamp(value, -most, most) : 0;
}

}  // namespace

SkinWeights::SkinWeights(const VertexStreams& vertices) {
  const auto find = [&](const std::string& semantic) {
    const auto found = std::ranges::find(vertices.base, semantic, &VertexStream::semantic);
    return static_cast<std::size_t>(found - vertices.base.begin());
  };
  for (int set = 0;; ++set) {
    const std::size_t joints = find("JOINTS_" + std::to_string(set)), weights = find("WEIGHTS_" + std::to_string(set));
    if (joints == vertices.base.size() || weights == vertices.base.size()) break;
    sets_.push_back({joints, weights});
  }
  slots_ = 4 * sets_.size();
  rows_.resize(slots_ * vertices.count);
  for (std::uint32_t v = 0; v < vertices.count; ++v) {
    Slot* row = row_of(v);
    for (const Set& set : sets_) {
      for (std::size_t c = 0; c < 4; ++c, ++row) {
        *row = {joint_of(decode_component(vertices.base[set.joints], v, c)),
                weight_of(decode_component(vertices.base[set.weights], v, c))};
      }
    }
  }
}

void SkinWeights::blend(std::uint32_t vertex, std::span<const Slot> other, float t) {
  if (empty()) return;
  std::vector<Slot> sum;
  const auto add = [&](std::span<const Slot> row, float share) {
    for (const Slot& slot : row) {
      if (!(slot.weight * share > 0)) continue;
      const auto known = std::ranges::find(sum, slot.joint, &Slot::joint);
      if (known == sum.end()) {
        sum.push_back({slot.joint, slot.weight * share});
      } else {
        known->weight += slot.weight * share;
      }
    }
  };
  add(of(vertex), 1 - t);
  add(other, t);
  std::ranges::sort(
      sum, [](const Slot& a, const Slot& b) { return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint; });
  sum.resize(slots_);
  float whole = 0;
  for (const Slot& slot : sum) whole += slot.weight;
  for (Slot& slot : sum) slot.weight = whole > 0 ? slot.weight / whole : 0;
  std::ranges::copy(sum, row_of(vertex));
}

void SkinWeights::write(std::span<const Slot> slots, std::size_t vertex, const std::vector<VertexStream>& base,
                        std::vector<std::vector<std::byte>>& bytes) const {
  const Slot* row = slots.data();
  double left = 0;  // of the sum, that rounding took: the next set has it
  for (const Set& set : sets_) {
    const Format joints = base[set.joints].format, weights = base[set.weights].format;
    const double unit = weights.component == Component::uint8    ? 255
                        : weights.component == Component::uint16 ? 65535
                                                                 : 0;
    const auto rounded = [unit](float weight) { return unit > 0 ? std::round(weight * unit) / unit : weight; };
    for (std::size_t c = 0; c < 4; ++c) left += row[c].weight - rounded(row[c].weight);
    // It is given to the largest one of the set, as a sum below 1 shrinks the vertex towards the origin.
    const double given = unit > 0 ? std::round(left * unit) / unit : 0;
    left -= given;
    for (std::size_t c = 0; c < 4; ++c, ++row) {
      const std::size_t joint = vertex * joints.bytes + c * bytes_of(joints.component);
      const std::size_t weight = vertex * weights.bytes + c * bytes_of(weights.component);
      encode_component(bytes[set.joints].data() + joint, joints, static_cast<float>(row->joint));
      encode_component(bytes[set.weights].data() + weight, weights,
                       static_cast<float>(rounded(row->weight) + (c == 0 ? given : 0)));
    }
  }
}

}  // namespace foredraw
