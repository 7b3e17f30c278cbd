#include <foredraw/analysis/welded_positions.h>
#include <foredraw/collapses/attribute_walk.h>
#include <foredraw/collapses/level_vertices.h>
#include <foredraw/scene/encode_component.h>
#include <foredraw/scene/skin_weights.h>
#include <foredraw/scene/stream_meaning.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace foredraw {

namespace {

double squared_length(const float* v) { return double{v[0]} * v[0] + double{v[1]} * v[1] + double{v[2]} * v[2]; }

/// One stream's values while vertices are blended.
class BlendedStream {
 public:
  /// `is_base`: directions are of length 1; those of morph targets are differences.
  BlendedStream(const VertexStream& stream, bool is_base)
      : stream_(stream), is_amount_(is_amount(stream)), is_unit_(is_base && is_direction(stream)) {
    const std::size_t count = stream.count();
    if (is_amount_) {
      values_.resize(count * width());
      for (std::size_t v = 0; v < count; ++v) {
        for (std::size_t c = 0; c < width(); ++c) values_[v * width() + c] = decode_component(stream, v, c);
      }
    } else {
      source_.resize(count);
      for (std::uint32_t v = 0; v < count; ++v) source_[v] = v;
    }
  }

  void blend(std::uint32_t vertex, std::uint32_t other, float t) {
    if (is_amount_) return blend_amount(vertex, *this, other, t);
    if (t > 0.5f) source_[vertex] = source_[other];
  }

  /// Whether shares of several vertices make sense. Weights of joints are none less than 0, and few.
  bool is_solvable() const {
    return is_amount_ && width() <= most_components && stream_.semantic != "POSITION" &&
           !stream_.semantic.starts_with("WEIGHTS_");
  }

  /// False: nothing is known, and the vertex is as it was. `first`: what is taken off to get numbers of this stream.
  bool solve(std::uint32_t vertex, std::span<const WedgeShare> shares, std::uint32_t first) {
    std::array<float, most_components> solved{};
    for (std::size_t c = 0; c < width(); ++c) {
      const auto value = [&](std::uint32_t v) { return double{values_[(v - first) * width() + c]}; };
      solved[c] = static_cast<float>(is_unit_ && c < 3 ? shared_sum(shares, value) : shared_number(shares, value));
      if (!std::isfinite(solved[c])) return false;
    }
    if (is_unit_) {
      const double length = std::sqrt(squared_length(solved.data()));
      if (!(length > shortest)) return false;
      for (std::size_t c = 0; c < 3; ++c) solved[c] = static_cast<float>(solved[c] / length);
    }
    std::copy_n(solved.data(), width(), values_.data() + vertex * width());
    return true;
  }

  /// Of numbers between which nothing lies, the nearer vertex's stands.
  void blend_amount(std::uint32_t vertex, const BlendedStream& of, std::uint32_t other, float t) {
    float* to = values_.data() + vertex * width();
    const float* from = of.values_.data() + other * of.width();
    if (is_unit_) return blend_direction(to, from, t);
    for (std::size_t c = 0; c < width(); ++c) to[c] = blended(to[c], from[c], t);
  }

  void write(std::uint32_t vertex, std::vector<std::byte>& bytes) const {
    const Format& format = stream_.format;
    std::byte* to = bytes.data() + std::size_t{vertex} * format.bytes;
    if (!is_amount_) {
      std::copy_n(stream_.bytes.view().data() + std::size_t{source_[vertex]} * format.bytes, format.bytes, to);
      return;
    }
    const float* value = values_.data() + vertex * width();
    const double length = is_unit_ ? std::sqrt(squared_length(value)) : 1;
    for (std::size_t c = 0; c < width(); ++c) {
      const bool is_scaled = c < 3 && length > 0;
      const float turned = c == 3 && is_unit_ ? (value[c] < 0 ? -1.0f : 1.0f) : value[c];
      encode_component(to + c * bytes_of(format.component), format,
                       is_scaled ? static_cast<float>(value[c] / length) : turned);
    }
  }

 private:
  static constexpr std::size_t most_components = 16;
  static constexpr double shortest = 0.1;  // a direction that is left of opposite ones says nothing

  std::size_t width() const { return stream_.format.components; }

  static float blended(float to, float from, float t) {
    const float between = to + (from - to) * t;
    return std::isfinite(between) ? between : t > 0.5f ? from : to;
  }

  /// Between opposite ones there is nothing but what rounding leaves. What points nowhere is not nearer than any.
  void blend_direction(float* to, const float* from, float t) const {
    constexpr double rounding = 1e-10;  // squared
    const std::array was{to[0], to[1], to[2]};
    for (std::size_t c = 0; c < width(); ++c) to[c] = blended(to[c], from[c], t);
    const double length = squared_length(was.data()), length_from = squared_length(from);
    if (squared_length(to) > rounding * (length + length_from)) return;
    const auto points = [](double squared) { return squared > 0 && std::isfinite(squared); };
    const bool is_other = points(length_from) && (t > 0.5f || !points(length));
    std::copy_n(is_other ? from : was.data(), 3, to);
  }

  const VertexStream& stream_;
  bool is_amount_, is_unit_;
  std::vector<float> values_;
  std::vector<std::uint32_t> source_;  ///< [vertex] = whose value it has
};

class Blender {
 public:
  explicit Blender(const VertexStreams& vertices) : vertices_(vertices), skin_(vertices) {
    for (const VertexStream* stream : vertices.all()) {
      streams_.emplace_back(*stream, streams_.size() < vertices.base.size());
      bytes_.emplace_back(stream->bytes.view().begin(), stream->bytes.view().end());
    }
    std::size_t first = vertices.base.size();
    for (const auto& target : vertices.morph_targets) {
      const auto found = std::ranges::find(target, "POSITION", &VertexStream::semantic);
      moves_.push_back(found == target.end() ? no_stream : first + static_cast<std::size_t>(found - target.begin()));
      first += target.size();
    }
    change_.resize(vertices.count, nothing);
  }

  /// Numbers of vertices are those of the joined mesh, from `first` on.
  void join(const JoinedVertex& joined, std::uint32_t first, float t) {
    const std::uint32_t vertex = joined.vertex - first;
    const bool is_blended = joined.stands_for_another();
    if (joined.shares.empty() && (!is_blended || t == 0)) return;  // as it is, to the byte
    change_[vertex] |= is_blended ? everything : attributes;
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      const bool is_solved =
          is_solvable(s) && !joined.shares.empty() && streams_[s].solve(vertex, joined.shares, first);
      if (!is_solved && is_blended) streams_[s].blend(vertex, joined.removed - first, t);
    }
    if (is_blended) skin_.blend(vertex, skin_.of(joined.removed - first), t);
  }

  /// Whether joints or morph targets move vertices.
  bool moves() const {
    return !skin_.empty() || std::ranges::any_of(moves_, [](std::size_t s) { return s != no_stream; });
  }

  bool is_solvable(std::size_t s) const { return s < vertices_.base.size() && streams_[s].is_solvable(); }
  bool has_solvable() const {
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      if (is_solvable(s)) return true;
    }
    return false;
  }

  /// Only what moves it: the vertex is beside one that is blended with that one of `from`.
  void blend_moves(std::uint32_t vertex, const Blender& from, std::uint32_t other, float t) {
    change_[vertex] |= motion;
    skin_.blend(vertex, from.skin_.of(other), t);
    for (std::size_t m = 0; m < std::min(moves_.size(), from.moves_.size()); ++m) {
      if (moves_[m] == no_stream || from.moves_[m] == no_stream) continue;
      streams_[moves_[m]].blend_amount(vertex, from.streams_[from.moves_[m]], other, t);
    }
  }

  void place(std::uint32_t vertex, glm::vec3 place) {
    for (std::size_t s = 0; s < vertices_.base.size(); ++s) {
      const VertexStream& stream = vertices_.base[s];
      if (stream.semantic != "POSITION") continue;
      for (std::size_t c = 0; c < 3 && c < stream.format.components; ++c) {
        encode_component(bytes_[s].data() + vertex * stream.format.bytes + c * bytes_of(stream.format.component),
                         stream.format, place[static_cast<int>(c)]);
      }
    }
  }

  /// The vertices for which is_used holds.
  LevelVertices finish(const std::vector<bool>& is_used) {
    for (std::uint32_t v = 0; v < vertices_.count; ++v) {
      if (is_used[v] && change_[v] != nothing) write(v);
    }
    LevelVertices level;
    level.number.resize(vertices_.count, no_vertex);
    auto left = std::make_shared<VertexStreams>(vertices_);
    left->count = 0;
    for (std::uint32_t v = 0; v < vertices_.count; ++v) {
      if (is_used[v]) level.number[v] = left->count++;
    }
    std::size_t s = 0;
    const auto keep = [&](VertexStream& stream) {
      std::vector<std::byte> kept;
      kept.reserve(std::size_t{left->count} * stream.format.bytes);
      for (std::uint32_t v = 0; v < vertices_.count; ++v) {
        const auto row = bytes_[s].begin() + static_cast<std::ptrdiff_t>(std::size_t{v} * stream.format.bytes);
        if (is_used[v]) kept.insert(kept.end(), row, row + stream.format.bytes);
      }
      stream.bytes = Shared<std::byte>(std::move(kept));
      ++s;
    };
    for (VertexStream& stream : left->base) keep(stream);
    for (auto& target : left->morph_targets) {
      for (VertexStream& stream : target) keep(stream);
    }
    level.vertices = std::move(left);
    return level;
  }

 private:
  using Change = std::uint8_t;
  static constexpr Change nothing = 0, attributes = 1, motion = 2, everything = 7;
  static constexpr std::size_t no_stream = ~std::size_t{0};

  void write(std::uint32_t vertex) {
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      const bool has_changed = change_[vertex] == everything ||
                               ((change_[vertex] & attributes) != 0 && is_solvable(s)) ||
                               ((change_[vertex] & motion) != 0 && std::ranges::find(moves_, s) != moves_.end());
      if (!has_changed) continue;
      if (s < vertices_.base.size() && vertices_.base[s].semantic == "POSITION") continue;  // place() wrote it
      streams_[s].write(vertex, bytes_[s]);
    }
    skin_.write(vertex, vertices_.base, bytes_);
  }

  const VertexStreams& vertices_;
  SkinWeights skin_;
  std::vector<BlendedStream> streams_;         ///< the base's, then each target's
  std::vector<std::vector<std::byte>> bytes_;  ///< the same
  std::vector<std::size_t> moves_;             ///< [target] which are its positions, or no_stream
  std::vector<Change> change_;                 ///< [vertex]
};

/// [vertex] the next one at its position, or no_vertex; from a point on, which is the first of them, all are found.
std::vector<std::uint32_t> next_at_point(const JoinedMesh& mesh) {
  const std::vector<std::uint32_t> point = welded(mesh.positions);
  std::vector<std::uint32_t> next(point.size(), no_vertex);
  for (auto v = static_cast<std::uint32_t>(point.size()); v-- > 0;) {
    if (point[v] != v) next[v] = std::exchange(next[point[v]], v);
  }
  return next;
}

}  // namespace

std::vector<LevelVertices> level_vertices(const CollapseSequence& sequence, std::size_t collapses,
                                          const Collapsed& after, const JoinedMesh& mesh) {
  std::vector<Blender> blenders;
  for (const auto& stream : mesh.streams) blenders.emplace_back(*stream);
  const auto blender_of = [&](std::uint32_t vertex) -> Blender& { return blenders[mesh.part[vertex]]; };
  const auto number = [&](std::uint32_t vertex) { return vertex - mesh.first_vertex[mesh.part[vertex]]; };
  const bool moves = std::ranges::any_of(blenders, &Blender::moves);
  const std::vector<std::uint32_t> next = moves ? next_at_point(mesh) : std::vector<std::uint32_t>();
  const bool solves = std::ranges::any_of(blenders, &Blender::has_solvable);
  AttributeWalk walk(sequence, mesh.positions, solves ? mesh.indices : std::span<const std::uint32_t>());
  for (std::size_t k = 0; k < collapses; ++k) {
    const float t = sequence.collapses[k].blend;
    const std::span<const JoinedVertex> joined = walk.next();
    for (const JoinedVertex& one : joined) {
      blender_of(one.vertex).join(one, mesh.first_vertex[mesh.part[one.vertex]], t);
    }
    const auto paired = std::ranges::find_if(joined, &JoinedVertex::stands_for_another);
    if (paired == joined.end() || !moves) continue;
    for (std::uint32_t vertex = sequence.collapses[k].kept; vertex != no_vertex; vertex = next[vertex]) {
      const auto known = std::ranges::find(joined, vertex, &JoinedVertex::vertex);
      if (known != joined.end() && known->stands_for_another()) continue;
      blender_of(vertex).blend_moves(number(vertex), blender_of(paired->removed), number(paired->removed), t);
    }
  }
  std::vector<std::vector<bool>> is_used;
  for (const auto& stream : mesh.streams) is_used.emplace_back(stream->count, false);
  for (const std::uint32_t index : after.indices) is_used[mesh.part[index]][number(index)] = true;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (is_used[mesh.part[v]][number(v)] && after.places[v] != mesh.positions[v]) {
      blender_of(v).place(number(v), after.places[v]);
    }
  }
  std::vector<LevelVertices> levels;
  for (std::size_t s = 0; s < blenders.size(); ++s) levels.push_back(blenders[s].finish(is_used[s]));
  return levels;
}

}  // namespace foredraw
