#include "is_cancelled.h"
#include "sparse_symmetric.h"

#include <algorithm>

namespace foredraw::processors::displacement_seams {

/// The entries left of the diagonal, and it, of a row in the new sequence.
template <class Use>
void LdltFactor::for_each_left(std::uint32_t row, Use use) const {
  const std::uint32_t old = order_[row];
  for (std::size_t i = matrix_.starts[old]; i < matrix_.starts[old + 1]; ++i) {
    const std::uint32_t column = place_[matrix_.columns[i]];
    if (column <= row) use(column, matrix_.values[i]);
  }
}

/// Row k of L has entries where paths to parents, begun at the entries of row k of the matrix, lead before they reach
/// k.
LdltFactor::LdltFactor(const SymmetricMatrix& matrix, std::span<const std::uint32_t> order)
    : matrix_(matrix),
      order_(order),
      place_(order.size()),
      parent_(order.size(), no_row),
      starts_(order.size() + 1, 0),
      diagonal_(order.size(), 0) {
  const auto size = static_cast<std::uint32_t>(order.size());
  for (std::uint32_t k = 0; k < size; ++k) place_[order[k]] = k;
  std::vector<std::uint32_t> seen_at(size, no_row);
  for (std::uint32_t k = 0; k < size; ++k) {
    seen_at[k] = k;
    for_each_left(k, [&](std::uint32_t j, double) {
      for (; seen_at[j] != k; j = parent_[j]) {
        if (parent_[j] == no_row) parent_[j] = k;
        seen_at[j] = k;
        ++starts_[j + 1];
      }
    });
  }
  for (std::size_t j = 0; j < size; ++j) {
    const auto entries = static_cast<double>(starts_[j + 1]);
    multiplications_ += entries * entries / 2;
    starts_[j + 1] += starts_[j];
  }
}

void LdltFactor::compute(const std::atomic<bool>* cancel) {
  const auto size = static_cast<std::uint32_t>(order_.size());
  rows_.resize(starts_[size]);
  values_.resize(starts_[size]);
  std::vector<std::size_t> ends(starts_.begin(), starts_.end() - 1);
  std::vector<double> row(size, 0);
  std::vector<std::uint32_t> path, pattern, seen_at(size, no_row);
  for (std::uint32_t k = 0; k < size; ++k) {
    if (is_cancelled(cancel)) return;
    pattern.clear();
    seen_at[k] = k;
    for_each_left(k, [&](std::uint32_t j, double value) {
      row[j] += value;
      path.clear();
      for (; seen_at[j] != k; j = parent_[j]) {
        seen_at[j] = k;
        path.push_back(j);
      }
      pattern.insert(pattern.end(), path.rbegin(), path.rend());
    });
    double diagonal = row[k];
    row[k] = 0;
    for (auto j = pattern.rbegin(); j != pattern.rend(); ++j) {  // what a column changes comes behind it
      const double value = row[*j];
      row[*j] = 0;
      for (std::size_t i = starts_[*j]; i < ends[*j]; ++i) row[rows_[i]] -= values_[i] * value;
      const double scaled = value / diagonal_[*j];
      diagonal -= scaled * value;
      rows_[ends[*j]] = k;
      values_[ends[*j]++] = scaled;
    }
    diagonal_[k] = diagonal;
  }
}

void LdltFactor::solve(std::span<double> right_side) const {
  std::vector<double> x(order_.size());
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = right_side[order_[k]];
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (std::size_t i = starts_[k]; i < starts_[k + 1]; ++i) x[rows_[i]] -= values_[i] * x[k];
  }
  for (std::size_t k = x.size(); k-- > 0;) {
    x[k] /= diagonal_[k];
    for (std::size_t i = starts_[k]; i < starts_[k + 1]; ++i) x[k] -= values_[i] * x[rows_[i]];
  }
  for (std::size_t k = 0; k < x.size(); ++k) right_side[order_[k]] = x[k];
}

}  // namespace foredraw::processors::displacement_seams
