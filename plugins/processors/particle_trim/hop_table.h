#pragma once
// Least costs of ways round a hull, of so many hops from edge to edge.

#include <cstddef>
#include <memory>
#include <vector>

namespace foredraw::processors::particle_trim {

/// The cheapest ways of a fixed number of hops from each edge to those behind it, at most once round.
class HopTable {
 public:
  /// One hop: costs[i][steps] from edge i to the steps-th behind it; rows may be of different lengths, [0] is not used.
  static std::shared_ptr<const HopTable> single(std::vector<std::vector<double>> costs);

  /// The hops of `a`, then those of `b`. What costs more than `most` is left out.
  static std::shared_ptr<const HopTable> joined(std::shared_ptr<const HopTable> a, std::shared_ptr<const HopTable> b,
                                                double most);

  std::size_t edges() const { return costs_.size(); }
  const std::vector<double>& from(std::size_t i) const { return costs_[i % costs_.size()]; }
  /// Infinity where there is none.
  double cost(std::size_t i, std::size_t steps) const;

  /// Appends the steps of each hop of that cheapest way, which there has to be.
  void trace(std::size_t i, std::size_t steps, std::vector<std::size_t>& hops) const;

 private:
  std::vector<std::vector<double>> costs_;
  std::shared_ptr<const HopTable> first_, second_;  ///< of a joined one
};

}  // namespace foredraw::processors::particle_trim
