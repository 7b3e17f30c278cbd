#pragma once
// Which joints move a vertex, and how much, between two vertices.

#include <foredraw/scene/vertex_streams.h>

#include <span>
#include <vector>

namespace foredraw {

/// The joints and weights of all vertices of one VertexStreams (JOINTS_0, WEIGHTS_0, JOINTS_1, ...).
class SkinWeights {
 public:
  struct Slot {
    std::uint32_t joint = 0;
    float weight = 0;
  };

  explicit SkinWeights(const VertexStreams& vertices);

  bool empty() const { return slots_ == 0; }
  std::size_t slots() const { return slots_; }  ///< of each vertex
  std::span<const Slot> of(std::uint32_t vertex) const { return {rows_.data() + vertex * slots_, slots_}; }
  /// The vertex gets (1 - t) of its own weights and t of the other ones: the largest of them, as many as there are
  /// slots, that sum up to 1. Equal weights go by the joint's number.
  void blend(std::uint32_t vertex, std::span<const Slot> other, float t);
  /// The vertex's bytes into those of the streams, which are in the sequence of the base.
  void write(std::uint32_t vertex, const std::vector<VertexStream>& base,
             std::vector<std::vector<std::byte>>& bytes) const {
    write(of(vertex), vertex, base, bytes);
  }
  /// The same with a row of as many slots, largest weights first, for a vertex that may be a new one.
  void write(std::span<const Slot> row, std::size_t vertex, const std::vector<VertexStream>& base,
             std::vector<std::vector<std::byte>>& bytes) const;

 private:
  struct Set {
    std::size_t joints = 0, weights = 0;  ///< which streams of the base
  };
  Slot* row_of(std::uint32_t vertex) { return rows_.data() + vertex * slots_; }

  std::vector<Set> sets_;
  std::size_t slots_ = 0;
  std::vector<Slot> rows_;
};

}  // namespace foredraw
