#include "quadric_collapse.h"

#include "collapser.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <tuple>
#include <utility>

namespace foredraw {

namespace {

using namespace processors::quadric_collapse;

constexpr std::size_t piece_points = 4096;   // at most: what belongs to them nearly fits a second-level cache
constexpr std::size_t fewest_points = 1024;  // of fewer a piece, too many lie at its rim
constexpr std::size_t round_ranks = 8;       // costs double in a round
constexpr std::size_t round_share = 8;       // of a piece's points no more than the eighth part goes in a round

/// In rounds: every piece of the mesh collapses its own edges up to a cost, all at once, and then those between pieces
/// are collapsed up to that cost. What comes out does not depend on who works on which piece when.
class QuadricCollapse {
 public:
  QuadricCollapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                  const QuadricCollapseOptions& options, AttributeRows attributes,
                  std::span<const std::uint32_t> stream, const PosedVertices& posed)
      : options_(options),
        mesh_(positions, indices, piece_points),
        attributes_(mesh_, std::move(attributes), solves()),
        poses_(mesh_, posed, options.poses),
        parts_(mesh_, options.parts, stream),
        points_(mesh_.point_count()),
        faces_(mesh_.face_count()),
        between_({options_, mesh_, attributes_, poses_, parts_}, Collapser::between, mesh_.piece_count(), editors()) {
    for (std::size_t i = 0; i < mesh_.piece_count(); ++i) {
      all_.emplace_back(Collapsing{options_, mesh_, attributes_, poses_, parts_}, i, i, editors());
      pieces_.push_back(&all_.back());
    }
  }

  CollapseSequence run() {
    each_piece([](std::size_t, Collapser& piece) { piece.begin(); });
    between_.enter_parts();
    for (std::size_t before = ~std::size_t{0}; faces_ > options_.least && faces_ < before;) {
      before = faces_;
      each_piece([](std::size_t, Collapser& piece) { piece.enter_edges(); });
      if (!is_one_piece()) between_.enter_edges();
      hand_over();
      while (faces_ > options_.least && !is_cancelled() && next_rank() < CostQueue::ranks) round();
    }
    sequence_.first_pair.push_back(static_cast<std::uint32_t>(sequence_.pairs.size()));
    sequence_.solves = solves();
    return std::move(sequence_);
  }

 private:
  bool is_cancelled() const { return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed); }

  bool solves() const { return options_.solves && options_.placement == CollapsePlacement::optimal; }
  std::size_t editors() const { return mesh_.piece_count() + 1; }
  bool is_one_piece() const { return pieces_.size() == 1; }

  template <class Task>
  void each_piece(const Task& task) {
    const auto run = [&](std::size_t i) { task(i, *pieces_[i]); };
    if (options_.executor != nullptr) {
      options_.executor->for_each(pieces_.size(), run);
    } else {
      for (std::size_t i = 0; i < pieces_.size(); ++i) run(i);
    }
  }

  /// The lowest rank of all edges.
  std::size_t next_rank() const {
    std::size_t rank = between_.queue().next();
    for (const Collapser* piece : pieces_) rank = std::min(rank, piece->queue().next());
    return rank;
  }

  void round() {
    const std::size_t most = is_one_piece() ? CostQueue::ranks : next_rank() + round_ranks - 1;
    if (!is_one_piece()) {
      each_piece([&](std::size_t, Collapser& piece) { piece.run_inside(most, round_share); });
      hand_over();
      append_by_cost();
    }
    between_.run(most, faces_, options_.least);
    append(between_.steps(), 0, between_.steps().steps.size());
    between_.steps().clear();
    hand_over();
    while (!is_one_piece() && points_ < fewest_points * pieces_.size()) join_pieces();
  }

  /// Edges go to whom they belong.
  void hand_over() {
    for (Collapser* piece : pieces_) {
      for (const auto& [rank, entry] : piece->elsewhere()) between_.queue().push(rank, entry);
      piece->elsewhere().clear();
    }
    for (const auto& [rank, entry] : between_.elsewhere()) {
      pieces_[mesh_.piece_of(entry.p)]->queue().push(rank, entry);
    }
    between_.elsewhere().clear();
  }

  void join_pieces() {
    mesh_.join_pieces();
    const std::vector<Collapser*> halves = std::exchange(pieces_, {});
    for (std::size_t i = 0; i < halves.size(); i += 2) pieces_.push_back(halves[i]);
    each_piece([&](std::size_t i, Collapser& piece) { piece.join(*halves[2 * i + 1]); });
    if (is_one_piece()) between_.take(*pieces_.front());
  }

  /// What pieces did at once comes one after the other, the cheapest first.
  void append_by_cost() {
    struct Place {
      std::uint32_t rank, piece, step;
    };
    std::vector<Place> places;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      for (std::uint32_t j = 0; j < pieces_[i]->steps().steps.size(); ++j) {
        places.push_back({pieces_[i]->steps().steps[j].rank, i, j});
      }
    }
    std::ranges::sort(places, {}, [](const Place& at) { return std::tuple(at.rank, at.piece, at.step); });
    for (const Place& at : places) append(pieces_[at.piece]->steps(), at.step, at.step + 1);
    for (Collapser* piece : pieces_) piece->steps().clear();
  }

  void append(const Steps& from, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end && faces_ > options_.least; ++i) {
      const Steps::Step& step = from.steps[i];
      error_ = std::max(error_, step.collapse.error);
      Collapse collapse = step.collapse;
      collapse.error = error_;
      sequence_.collapses.push_back(collapse);
      sequence_.first_pair.push_back(static_cast<std::uint32_t>(sequence_.pairs.size()));
      const std::uint32_t begin = i == 0 ? 0 : from.steps[i - 1].end;
      sequence_.pairs.insert(sequence_.pairs.end(), from.pairs.begin() + begin, from.pairs.begin() + step.end);
      for (int k = 0; k < 3; ++k) sequence_.places.push_back(step.place[k]);
      faces_ -= step.faces;
      --points_;
    }
  }

  QuadricCollapseOptions options_;
  CollapsingMesh mesh_;
  AttributeCosts attributes_;
  PosedPlanes poses_;
  WholeParts parts_;
  std::size_t points_, faces_;  // that are left
  std::deque<Collapser> all_;
  std::vector<Collapser*> pieces_;
  Collapser between_;
  CollapseSequence sequence_;
  float error_ = 0;
};

}  // namespace

CollapseSequence quadric_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                  const QuadricCollapseOptions& options, AttributeRows attributes,
                                  std::span<const std::uint32_t> stream, const PosedVertices& posed) {
  if (posed.poses() > 0) {
    // The surface counts at rest and in poses. Beside it attributes weigh what they did.
    const auto scale = static_cast<float>(std::sqrt(1 + options.poses));
    for (float& value : attributes.values) value *= scale;
    for (AttributeRows::Direction& one : attributes.directions) one.length *= static_cast<double>(scale);
  }
  return QuadricCollapse(positions, indices, options, std::move(attributes), stream, posed).run();
}

}  // namespace foredraw
