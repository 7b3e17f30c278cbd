#include <foredraw/analysis/diagonal.h>
#include <foredraw/base/random.h>
#include <foredraw/collapses/alike_vertices.h>
#include <foredraw/collapses/attribute_rows.h>
#include <foredraw/scene/skin_weights.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace foredraw {

namespace {

constexpr std::size_t joint_numbers = 6, target_directions = 2;

/// 1 or -1, drawn for each pair.
float sign(std::uint64_t of, std::uint64_t number) { return derive_seed(of, number, 0) >> 63 == 0 ? 1.0f : -1.0f; }

std::vector<std::string> semantics_of(const JoinedMesh& mesh, std::string_view word) {
  std::vector<std::string> found;
  for (const auto& stream : mesh.streams) {
    for (const VertexStream& one : stream->base) {
      if (one.semantic.starts_with(word) && !std::ranges::count(found, one.semantic)) found.push_back(one.semantic);
    }
  }
  return found;
}

class RowMaking {
 public:
  RowMaking(const JoinedMesh& mesh, const AttributeWeights& weights)
      : mesh_(mesh), weights_(weights), diagonal_(diagonal_of(mesh.positions)) {}

  AttributeRows run() {
    add_all("NORMAL", 3, weights_.normals * diagonal_);
    const std::size_t normals = columns_.size();
    add_texcoords();
    add_all("COLOR_", 4, weights_.colors * diagonal_);
    const std::size_t solved = columns_.size();
    add_joints();
    add_targets();
    AttributeRows made = rows();
    made.blended = columns_.size() - solved;
    if (normals > 0) made.directions.push_back({0, weights_.normals * diagonal_});
    made.alike = alike_vertices(mesh_);
    return made;
  }

 private:
  using Column = std::vector<float>;  // [vertex]

  Column& add_column() { return columns_.emplace_back(mesh_.positions.size(), 0.0f); }

  /// Up to `most` components of each stream whose semantic begins so.
  void add_all(std::string_view word, std::size_t most, double scale) {
    if (!(scale > 0)) return;
    for (const std::string& semantic : semantics_of(mesh_, word)) add(semantic, most, scale);
  }

  void add(const std::string& semantic, std::size_t most, double scale) {
    const std::size_t first = add_unscaled(semantic, most);
    scale_columns(first, scale);
  }

  /// Answers with the first column.
  std::size_t add_unscaled(const std::string& semantic, std::size_t most) {
    const std::size_t first = columns_.size();
    for (std::size_t c = 0; c < most; ++c) add_column();
    for (std::size_t s = 0; s < mesh_.streams.size(); ++s) {
      const VertexStream* stream = mesh_.streams[s]->find(semantic);
      if (stream == nullptr) continue;
      const std::size_t components = std::min<std::size_t>(most, stream->format.components);
      for (std::size_t v = 0; v < stream->count(); ++v) {
        for (std::size_t c = 0; c < components; ++c) {
          columns_[first + c][mesh_.first_vertex[s] + v] = decode_component(*stream, v, c);
        }
      }
    }
    return first;
  }

  void scale_columns(std::size_t first, double scale) {
    for (std::size_t c = first; c < columns_.size(); ++c) {
      for (float& value : columns_[c]) value = scaled(value, scale);
    }
  }

  /// Units of a texture are as long as they are on the surface, in the mean.
  void add_texcoords() {
    if (!(weights_.texcoords > 0)) return;
    for (const std::string& semantic : semantics_of(mesh_, "TEXCOORD_")) {
      const std::size_t first = add_unscaled(semantic, 2);
      double surface = 0, texture = 0;
      for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) {
        const std::uint32_t a = mesh_.indices[i], b = mesh_.indices[i + 1], c = mesh_.indices[i + 2];
        const Column &u = columns_[first], &v = columns_[first + 1];
        const double area = twice_area(a, b, c);
        if (!std::isfinite(area)) continue;
        surface += area;
        const double covered =
            std::abs((double{u[b]} - u[a]) * (double{v[c]} - v[a]) - (double{u[c]} - u[a]) * (double{v[b]} - v[a]));
        if (std::isfinite(covered)) texture += covered;
      }
      scale_columns(first, texture > 0 ? weights_.texcoords * std::sqrt(surface / texture) : 0);
    }
  }

  double twice_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const glm::dvec3 p(mesh_.positions[a]), q = glm::dvec3(mesh_.positions[b]) - p,
                                            r = glm::dvec3(mesh_.positions[c]) - p;
    const double x = q.y * r.z - q.z * r.y, y = q.z * r.x - q.x * r.z, z = q.x * r.y - q.y * r.x;
    return std::sqrt(x * x + y * y + z * z);
  }

  void add_joints() {
    const double scale = weights_.joints * diagonal_ / std::sqrt(double{joint_numbers});
    if (!(scale > 0) || semantics_of(mesh_, "JOINTS_0").empty()) return;
    const std::size_t first = columns_.size();
    for (std::size_t c = 0; c < joint_numbers; ++c) add_column();
    for (std::size_t s = 0; s < mesh_.streams.size(); ++s) {
      const SkinWeights skin(*mesh_.streams[s]);
      for (std::uint32_t v = 0; v < mesh_.streams[s]->count; ++v) {
        for (const SkinWeights::Slot& slot : skin.of(v)) {
          for (std::size_t c = 0; c < joint_numbers; ++c) {
            columns_[first + c][mesh_.first_vertex[s] + v] += scaled(slot.weight * sign(slot.joint, c), scale);
          }
        }
      }
    }
  }

  void add_targets() {
    const double scale = weights_.targets / std::sqrt(double{target_directions});
    const bool has_any =
        std::ranges::any_of(mesh_.streams, [](const auto& one) { return !one->morph_targets.empty(); });
    if (!(scale > 0) || !has_any) return;
    const std::size_t first = columns_.size();
    for (std::size_t c = 0; c < 3 * target_directions; ++c) add_column();
    for (std::size_t s = 0; s < mesh_.streams.size(); ++s) {
      const auto& targets = mesh_.streams[s]->morph_targets;
      for (std::size_t t = 0; t < targets.size(); ++t) {
        const auto moves = std::ranges::find(targets[t], "POSITION", &VertexStream::semantic);
        if (moves == targets[t].end()) continue;
        for (std::size_t v = 0; v < moves->count(); ++v) {
          for (std::size_t c = 0; c < 3 * target_directions; ++c) {
            columns_[first + c][mesh_.first_vertex[s] + v] +=
                scaled(decode_component(*moves, v, c % 3) * sign(t, c / 3), scale);
          }
        }
      }
    }
  }

  /// What is no number counts as 0; what is too large, as much as many diagonals. Differences are finite, too.
  float scaled(float value, double scale) const {
    const double most = std::min(1e6 * diagonal_, 0x1p126), length = double{value} * scale;
    return std::isfinite(length) ? static_cast<float>(std::clamp(length, -most, most)) : 0.0f;
  }

  AttributeRows rows() const {
    AttributeRows rows{.width = columns_.size(), .values = {}};
    rows.values.resize(columns_.size() * mesh_.positions.size());
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      for (std::size_t v = 0; v < columns_[c].size(); ++v) rows.values[v * columns_.size() + c] = columns_[c][v];
    }
    return rows;
  }

  const JoinedMesh& mesh_;
  AttributeWeights weights_;
  double diagonal_;
  std::vector<Column> columns_;
};

}  // namespace

AttributeRows attribute_rows(const JoinedMesh& mesh, const AttributeWeights& weights) {
  return RowMaking(mesh, weights).run();
}

}  // namespace foredraw
