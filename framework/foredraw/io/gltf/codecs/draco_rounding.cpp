#include <foredraw/io/gltf/codecs/private/draco.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw::gltf {

namespace {

constexpr float rounding = 0.01f;  // of as few as 7 bits
constexpr float exact = 1e-5f;     // what is nearer stays as it came

/// Elements of so many floats each.
class Floats {
 public:
  Floats(std::vector<std::byte>& bytes, std::size_t components) : bytes_(&bytes), components_(components) {}

  std::size_t components() const { return components_; }
  float at(std::size_t element, std::size_t component) const {
    float value;
    std::memcpy(&value, place(element, component), sizeof value);
    return value;
  }
  void set(std::size_t element, std::size_t component, float value) {
    std::memcpy(place(element, component), &value, sizeof value);
  }

 private:
  std::byte* place(std::size_t element, std::size_t component) const {
    return bytes_->data() + (element * components_ + component) * sizeof(float);
  }

  std::vector<std::byte>* bytes_;
  std::size_t components_;
};

void keep_in_range(Floats colours, std::size_t points) {
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t c = 0; c < colours.components(); ++c) {
      const float value = colours.at(i, c);
      if (value >= -rounding && value <= 1 + rounding) colours.set(i, c, std::clamp(value, 0.0f, 1.0f));
    }
  }
}

void keep_unit(Floats directions, std::size_t points) {
  for (std::size_t i = 0; i < points; ++i) {
    const float x = directions.at(i, 0), y = directions.at(i, 1), z = directions.at(i, 2);
    const float length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0) || !std::isfinite(length) || std::abs(length - 1) < exact) continue;
    directions.set(i, 0, x / length);
    directions.set(i, 1, y / length);
    directions.set(i, 2, z / length);
  }
}

void keep_sum(std::vector<Floats>& weights, std::size_t points) {
  for (std::size_t i = 0; i < points; ++i) {
    float sum = 0;
    for (const Floats& set : weights) {
      for (std::size_t c = 0; c < set.components(); ++c) sum += set.at(i, c);
    }
    if (!(std::abs(sum - 1) <= rounding) || std::abs(sum - 1) < exact) continue;
    for (Floats& set : weights) {
      for (std::size_t c = 0; c < set.components(); ++c) set.set(i, c, set.at(i, c) / sum);
    }
  }
}

}  // namespace

void undo_rounding(const DracoClaim& claim, const std::vector<bool>& rounded, DracoMesh& mesh) {
  std::vector<Floats> weights;
  for (std::size_t a = 0; a < claim.attributes.size(); ++a) {
    const auto& [id, format, semantic] = claim.attributes[a];
    if (format.component != Component::float32 || !rounded[a]) continue;
    const Floats values(mesh.attributes[a], format.components);
    if (semantic.starts_with("COLOR_")) keep_in_range(values, mesh.points);
    if ((semantic == "NORMAL" || semantic == "TANGENT") && format.components >= 3) keep_unit(values, mesh.points);
    if (semantic.starts_with("WEIGHTS_")) weights.push_back(values);
  }
  if (!weights.empty()) keep_sum(weights, mesh.points);
}

}  // namespace foredraw::gltf
