#pragma once
// Bytes that are given away as numbers of an odd mesh.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace foredraw::testing {

/// Gives the input away byte by byte, then zeros.
class OddInput {
 public:
  OddInput(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  std::size_t left() const { return size_; }
  std::uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  std::size_t below(std::size_t n) { return byte() % n; }
  float number() {
    static constexpr float odd[] = {0,
                                    -0.0f,
                                    1,
                                    0.5f,
                                    1e-40f,
                                    3e38f,
                                    -3e38f,
                                    std::numeric_limits<float>::infinity(),
                                    std::numeric_limits<float>::quiet_NaN()};
    const std::uint8_t b = byte();
    return b < std::size(odd) ? odd[b] : static_cast<float>(b % 16);  // few values: equal vertices, flat triangles
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

/// Three for each triangle: mostly neighbours, as in a mesh, else anywhere.
inline std::vector<std::uint32_t> odd_indices(OddInput& input, std::size_t vertices, std::size_t count) {
  std::vector<std::uint32_t> indices(count);
  std::uint32_t near = 0;
  for (std::uint32_t& index : indices) {
    const std::uint8_t b = input.byte();
    near = static_cast<std::uint32_t>(b < 200 ? near + b % 5 : b) % static_cast<std::uint32_t>(vertices);
    index = near;
  }
  return indices;
}

}  // namespace foredraw::testing
