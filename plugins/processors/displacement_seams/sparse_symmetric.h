#pragma once
// Linear equations with a sparse, symmetric, positive definite matrix, solved directly and in one fixed sequence of
// operations: the same bytes from every compiler and at any number of threads.

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::displacement_seams {

inline constexpr std::uint32_t no_row = ~std::uint32_t{0};

/// Row by row; every row has its diagonal, and both of two mirrored entries are there. Columns ascend.
struct SymmetricMatrix {
  std::vector<std::size_t> starts;     ///< [row], and the end of the last
  std::vector<std::uint32_t> columns;  ///< [entry]
  std::vector<double> values;          ///< [entry]

  std::size_t size() const { return starts.size() - 1; }
};

/// In which sequence rows are eliminated so that few entries appear: [new] = old. Minimum degree, with degrees bounded
/// from above as by P. Amestoy, T. Davis, I. Duff: An Approximate Minimum Degree Ordering Algorithm, SIAM J. Matrix
/// Anal. Appl. 17(4), 1996, section 4. Of equal degrees the smaller number goes first. Not of all rows once it is
/// cancelled.
std::vector<std::uint32_t> minimum_degree(const SymmetricMatrix& matrix, const std::atomic<bool>* cancel = nullptr);

/// L D L^T of the matrix, its rows in this sequence.
class LdltFactor {
 public:
  /// Finds where entries are. The matrix and the order have to stay until it is computed.
  LdltFactor(const SymmetricMatrix& matrix, std::span<const std::uint32_t> order);

  /// How many multiplications compute() will need, and how many entries there will be.
  double multiplications() const { return multiplications_; }
  std::size_t entries() const { return starts_.back(); }

  /// Ends early once it is cancelled, with nothing that is of use.
  void compute(const std::atomic<bool>* cancel = nullptr);

  /// The solution for a right side, in place; both as long as the matrix.
  void solve(std::span<double> right_side) const;

 private:
  template <class Use>
  void for_each_left(std::uint32_t row, Use use) const;

  const SymmetricMatrix& matrix_;
  std::span<const std::uint32_t> order_;
  std::vector<std::uint32_t> place_;   ///< [row of the matrix] where it stands now
  std::vector<std::uint32_t> parent_;  ///< [column of L] the row of its first entry below the diagonal
  std::vector<std::size_t> starts_;    ///< [column of L], and the end of the last
  std::vector<std::uint32_t> rows_;    ///< [entry] below the diagonal, ascending
  std::vector<double> values_;         ///< [entry]
  std::vector<double> diagonal_;
  double multiplications_ = 0;
};

}  // namespace foredraw::processors::displacement_seams
