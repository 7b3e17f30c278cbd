#include "progressive_stream.h"

#include "split_forest.h"
#include "stream_bytes.h"

#include <foredraw/runtime/progressive_stream.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

/// The mesh as a reader of the stream has it, with what each of its things is in the mesh that is written.
class Writer {
 public:
  Writer(const JoinedMesh& mesh, const CollapseSequence& sequence, const ProgressiveStreamOptions& options)
      : mesh_(mesh),
        sequence_(sequence),
        options_(options),
        grid_(number_grid(mesh, options)),
        numbers_(vertex_numbers(mesh, grid_).value()),
        forest_(split_forest(mesh, sequence)),
        number_of_(mesh.positions.size(), no_point),
        next_child_(mesh.positions.size(), 0),
        is_undone_(sequence.collapses.size(), false) {
    number_base_points();
  }

  ProgressiveStream write(const std::atomic<bool>* cancel) {
    begin();
    write_base();
    const std::size_t splits = sequence_.collapses.size();
    double known = static_cast<double>(points_.size());  // splits that this pass may take: the first of the sequence
    while (made_.collapse.size() < splits && !(cancel != nullptr && *cancel)) {
      const std::uint32_t before = coding_.at;
      const std::uint32_t point = next_split(known);
      if (foredraw_code_is_split(&coding_, point != no_point) != 0) {
        write_split(point);
        if (chunk_bytes() >= options_.chunk_size) end_chunk();
      } else if (coding_.at <= before) {
        known *= options_.growth;
      }
      if (coding_.damaged || coding_.coder.failed) {
        throw std::runtime_error("a point has too many triangles, or splits depend on each other in too long a row");
      }
    }
    end_chunk();
    return finish();
  }

 private:
  /// As triangles have them; those come last of which all triangles come later.
  void number_base_points() {
    const auto number = [&](std::uint32_t point) {
      if (number_of_[point] != no_point) return;
      number_of_[point] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(point);
    };
    for (const std::uint32_t t : forest_.base) {
      for (std::size_t k = 0; k < 3; ++k) number(root_of(forest_.point_of[mesh_.indices[std::size_t{3} * t + k]]));
    }
    for (std::size_t i = 0; i < mesh_.indices.size(); ++i) {
      if (forest_.is_proper[i / 3]) number(root_of(forest_.point_of[mesh_.indices[i]]));
    }
    for (std::uint32_t p = 0; p < forest_.parent.size(); ++p) {
      if (forest_.parent[p] == no_point && !forest_.children.of(p).empty()) number(p);
    }
  }

  /// What stands for it at the beginning.
  std::uint32_t root_of(std::uint32_t point) const {
    while (forest_.parent[point] != no_point) point = forest_.parent[point];
    return point;
  }

  /// What stands for it now.
  std::uint32_t standing_vertex(std::uint32_t vertex) const {
    while (forest_.parent_vertex[vertex] != no_point && number_of_[forest_.point_of[vertex]] == no_point) {
      vertex = forest_.parent_vertex[vertex];
    }
    return vertex;
  }

  void begin() {
    foredraw_stream_header header{};
    header.points = static_cast<std::uint32_t>(points_.size() + sequence_.collapses.size());
    header.vertices = static_cast<std::uint32_t>(mesh_.positions.size());
    header.triangles = static_cast<std::uint32_t>(std::ranges::count(forest_.is_proper, true));
    header.grid_bits = grid_.bits;
    std::copy_n(grid_.least, 3, header.least);
    header.step = grid_.step;
    header.parts = static_cast<std::uint32_t>(grid_.parts.size());
    header.draws = static_cast<std::uint32_t>(mesh_.stream_of.size());
    header.components = static_cast<std::uint32_t>(grid_.components.size());
    head_ = header;
    const std::vector<std::byte> bytes = header_bytes(header, grid_.parts, mesh_.stream_of, grid_.components);
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    memory_.resize(foredraw_stream_memory(&header, data) / 4 + 1);
    foredraw_stream stream;
    foredraw_stream_begin(&stream, &header, data, memory_.data());
    coding_ = stream.coding;
    moves_.resize(header.triangles);
    corner_names_.resize(std::size_t{3} * header.triangles);
    corner_.resize(corner_names_.size());
    made_.vertex.resize(header.vertices);
    wanted_ = {moves_.data(), corner_names_.data(), nullptr, 0, nullptr, made_.vertex.data(), numbers_.values.data()};
    coding_.wanted = &wanted_;
    const std::size_t base = (points_.size() + 3 * forest_.base.size()) * (64 + 8 * std::size_t{grid_.width});
    room_.resize((std::size_t{1} << 20) + 2 * std::size_t{options_.chunk_size} + base);
    begin_chunk();
  }

  foredraw_wanted_triangle wanted_triangle(std::uint32_t triangle) const {
    foredraw_wanted_triangle wanted{{}, {}, 0, FOREDRAW_NONE};
    for (std::size_t k = 0; k < 3; ++k) {
      wanted.names[k] = standing_vertex(mesh_.indices[std::size_t{3} * triangle + k]);
      wanted.points[k] = number_of_[forest_.point_of[wanted.names[k]]];
    }
    const auto behind = std::ranges::upper_bound(mesh_.first_index, 3 * triangle);
    wanted.draw = static_cast<std::uint32_t>(behind - mesh_.first_index.begin()) - 1;
    return wanted;
  }

  void want_triangles(std::span<const std::uint32_t> triangles) {
    added_.clear();
    for (const std::uint32_t t : triangles) added_.push_back(wanted_triangle(t));
    wanted_.added = added_.data();
    wanted_.added_count = static_cast<std::uint32_t>(added_.size());
  }

  /// Those that were wanted have numbers now.
  void note_triangles(std::span<const std::uint32_t> triangles) {
    for (std::size_t i = 0; i < triangles.size() && !coding_.damaged && !coding_.coder.failed; ++i) {
      const foredraw_wanted_triangle& wanted = added_[i];
      for (std::uint32_t k = 0; k < 3; ++k) {  // the stream may begin it at another corner
        const std::uint32_t at = 3 * wanted.number + k;
        const auto which = std::ranges::find(wanted.points, coding_.mesh.corner[at].point) - wanted.points;
        corner_[at] = 3 * triangles[i] + static_cast<std::uint32_t>(which);
        corner_names_[at] = wanted.names[which];
      }
    }
  }

  void write_base() {
    std::vector<std::int32_t> places;
    for (const std::uint32_t p : points_) {
      places.insert(places.end(), numbers_.places.begin() + 3 * std::ptrdiff_t{p},
                    numbers_.places.begin() + 3 * std::ptrdiff_t{p} + 3);
    }
    want_triangles(forest_.base);
    wanted_.place = places.data();
    foredraw_code_base(&coding_, static_cast<std::uint32_t>(points_.size()));
    note_triangles(forest_.base);
  }

  /// What the point that is asked splits off now; no_point: nothing.
  std::uint32_t next_split(double known) const {
    const std::uint32_t point = points_[coding_.at];
    const auto children = forest_.children.of(point);
    if (next_child_[point] == children.size()) return no_point;
    const std::uint32_t child = children[next_child_[point]];
    const std::size_t behind = sequence_.collapses.size() - 1 - forest_.collapse[child];
    if (static_cast<double>(behind) >= known) return no_point;
    const auto is_there = [&](std::uint32_t wing) { return number_of_[wing] != no_point; };
    return std::ranges::all_of(forest_.wings.of(child), is_there) ? child : no_point;
  }

  void write_split(std::uint32_t child) {
    const std::uint32_t old_point = coding_.at;
    ++next_child_[points_[old_point]];
    number_of_[child] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(child);
    const foredraw_split_mesh& now = coding_.mesh;
    for (std::uint32_t c = now.point[old_point].first_corner; c != FOREDRAW_NONE; c = now.corner[c].next) {
      const std::uint32_t vertex = mesh_.indices[corner_[c]];
      moves_[c / 3] = forest_.is_below(forest_.point_of[vertex], child) ? 1 : 0;
      if (moves_[c / 3] != 0) corner_names_[c] = standing_vertex(vertex);
    }
    want_triangles(forest_.triangles.of(child));
    wanted_.place = numbers_.places.data() + std::size_t{3} * child;
    foredraw_code_next_split(&coding_);
    note_triangles(forest_.triangles.of(child));
    made_.collapse.push_back(forest_.collapse[child]);
    is_undone_[forest_.collapse[child]] = true;
    while (undone_from_ > 0 && is_undone_[undone_from_ - 1]) --undone_from_;
  }

  std::size_t chunk_bytes() const { return room_.size() - coding_.coder.left + coding_.coder.held; }

  void begin_chunk() {
    foredraw_writer_begin(&coding_.coder, reinterpret_cast<std::uint8_t*>(room_.data()), room_.size());
  }

  void end_chunk() {
    if (!made_.splits.empty() && made_.splits.back() == made_.collapse.size()) return;
    foredraw_writer_end(&coding_.coder);
    const auto coded = std::span(room_).first(room_.size() - coding_.coder.left);
    const auto splits = static_cast<std::uint32_t>(made_.collapse.size());
    const std::uint32_t before = made_.splits.empty() ? 0 : made_.splits.back();
    chunks_.push_back({{coded.begin(), coded.end()},
                       splits - before,
                       coding_.mesh.vertices,
                       coding_.mesh.triangles,
                       undone_from_ > 0 ? sequence_.collapses[undone_from_ - 1].error : 0.0f});
    made_.splits.push_back(splits);
    begin_chunk();
  }

  ProgressiveStream finish() {
    head_.vertices = coding_.mesh.vertices;
    head_.triangles = coding_.mesh.triangles;
    head_.points = coding_.mesh.points;
    made_.vertex.resize(head_.vertices);
    made_.bytes = stream_bytes(head_, grid_.parts, mesh_.stream_of, grid_.components, chunks_, made_.chunk_end);
    return std::move(made_);
  }

  const JoinedMesh& mesh_;
  const CollapseSequence& sequence_;
  ProgressiveStreamOptions options_;
  NumberGrid grid_;
  VertexNumbers numbers_;
  SplitForest forest_;
  std::vector<std::uint32_t> points_;     ///< [point of the stream] = the mesh's
  std::vector<std::uint32_t> number_of_;  ///< and back; no_point: it is not there yet
  std::vector<std::uint32_t> next_child_;
  std::vector<bool> is_undone_;  ///< [collapse]
  std::size_t undone_from_ = sequence_.collapses.size();
  std::vector<std::uint32_t> corner_;  ///< [corner of the stream] = the mesh's
  std::vector<std::uint32_t> memory_, corner_names_;
  std::vector<std::uint8_t> moves_;
  std::vector<foredraw_wanted_triangle> added_;
  foredraw_wanted wanted_ = {};
  foredraw_split_coding coding_ = {};
  foredraw_stream_header head_ = {};
  std::vector<std::byte> room_;
  std::vector<CodedChunk> chunks_;
  ProgressiveStream made_;
};

}  // namespace

ProgressiveStream progressive_stream(const JoinedMesh& mesh, const CollapseSequence& sequence,
                                     const ProgressiveStreamOptions& options, const std::atomic<bool>* cancel) {
  return Writer(mesh, sequence, options).write(cancel);
}

}  // namespace foredraw
