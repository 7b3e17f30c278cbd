#include "is_cancelled.h"
#include "sparse_symmetric.h"

#include <algorithm>
#include <span>

namespace foredraw::processors::displacement_seams {

namespace {

/// Rows by their degree, a list for each.
class DegreeLists {
 public:
  explicit DegreeLists(std::size_t rows)
      : head_(rows + 1, no_row), next_(rows, no_row), last_(rows, no_row), degree_(rows) {}

  void put(std::uint32_t row, std::size_t degree) {
    degree_[row] = static_cast<std::uint32_t>(degree);
    last_[row] = no_row;
    next_[row] = head_[degree];
    if (next_[row] != no_row) last_[next_[row]] = row;
    head_[degree] = row;
    least_ = std::min(least_, degree);
  }

  void take(std::uint32_t row) {
    (last_[row] != no_row ? next_[last_[row]] : head_[degree_[row]]) = next_[row];
    if (next_[row] != no_row) last_[next_[row]] = last_[row];
  }

  /// There must be one. Of equals the one that was put in last.
  std::uint32_t take_least() {
    while (head_[least_] == no_row) ++least_;
    const std::uint32_t row = head_[least_];
    take(row);
    return row;
  }

 private:
  std::vector<std::uint32_t> head_, next_, last_;
  std::vector<std::uint32_t> degree_;
  std::size_t least_ = 0;
};

/// What is left of the matrix: rows that were not eliminated yet, joined by its entries, and by elements, which are the
/// cliques that eliminated rows left behind. An element bears the number of its row. A row gets an element only in
/// place of a neighbour or of an element that it had: so both fit where its entries were, all rows in one list.
class QuotientGraph {
 public:
  explicit QuotientGraph(const SymmetricMatrix& matrix)
      : starts_(matrix.starts),
        joined_(matrix.columns.size()),
        neighbours_(matrix.size(), 0),
        elements_(matrix.size(), 0),
        members_(matrix.size()),
        outside_(matrix.size()),
        is_inside_of_(matrix.size(), no_row),
        is_counted_for_(matrix.size(), no_row),
        is_absorbed_(matrix.size()) {
    for (std::uint32_t row = 0; row < matrix.size(); ++row) {
      for (std::size_t i = starts_[row]; i < starts_[row + 1]; ++i) {
        if (matrix.columns[i] != row) joined_[starts_[row] + neighbours_[row]++] = matrix.columns[i];
      }
    }
  }

  std::size_t degree(std::uint32_t row) const { return neighbours_[row]; }

  /// Makes an element of a row. Those that it was part of are absorbed.
  const std::vector<std::uint32_t>& eliminate(std::uint32_t pivot) {
    std::vector<std::uint32_t>& inside = members_[pivot];
    const auto add = [&](std::span<const std::uint32_t> rows) {
      for (const std::uint32_t row : rows) {
        if (is_inside_of_[row] == pivot) continue;
        is_inside_of_[row] = pivot;
        inside.push_back(row);
      }
    };
    is_inside_of_[pivot] = pivot;
    add(neighbours_of(pivot));
    for (const std::uint32_t element : elements_of(pivot)) {
      add(members_[element]);
      members_[element] = {};
      is_absorbed_[element] = true;
    }
    neighbours_[pivot] = elements_[pivot] = 0;
    inside.shrink_to_fit();
    for (const std::uint32_t row : inside) {
      for (const std::uint32_t element : elements_of(row)) {
        if (is_absorbed_[element]) continue;
        if (is_counted_for_[element] != pivot) outside_[element] = static_cast<std::uint32_t>(members_[element].size());
        is_counted_for_[element] = pivot;
        --outside_[element];
      }
    }
    return inside;
  }

  /// Of a member of the element that was made last: at least how many rows it is joined with.
  std::size_t update(std::uint32_t row, std::uint32_t pivot) {
    std::uint32_t neighbours = 0, elements = 0;
    std::uint32_t* to = &joined_[starts_[row]];
    for (const std::uint32_t other : neighbours_of(row)) {
      if (is_inside_of_[other] != pivot) to[neighbours++] = other;
    }
    std::size_t degree = members_[pivot].size() - 1 + neighbours;
    for (const std::uint32_t element : elements_of(row)) {
      if (is_absorbed_[element] || outside_[element] == 0) continue;
      to[neighbours + elements++] = element;
      degree += outside_[element];
    }
    to[neighbours + elements++] = pivot;
    neighbours_[row] = neighbours;
    elements_[row] = elements;
    return degree;
  }

 private:
  std::span<const std::uint32_t> neighbours_of(std::uint32_t row) const {
    return std::span(joined_).subspan(starts_[row], neighbours_[row]);
  }
  std::span<const std::uint32_t> elements_of(std::uint32_t row) const {
    return std::span(joined_).subspan(starts_[row] + neighbours_[row], elements_[row]);
  }

  std::span<const std::size_t> starts_;               ///< of the matrix
  std::vector<std::uint32_t> joined_;                 ///< [row] not yet eliminated: its neighbours, then its elements
  std::vector<std::uint32_t> neighbours_, elements_;  ///< [row] how many
  std::vector<std::vector<std::uint32_t>> members_;   ///< [element] not absorbed
  std::vector<std::uint32_t> outside_;                ///< [element] members that the newest one lacks
  std::vector<std::uint32_t> is_inside_of_, is_counted_for_;  ///< [row], [element]: the newest element
  std::vector<bool> is_absorbed_;                             ///< [element]
};

}  // namespace

std::vector<std::uint32_t> minimum_degree(const SymmetricMatrix& matrix, const std::atomic<bool>* cancel) {
  QuotientGraph graph(matrix);
  DegreeLists lists(matrix.size());
  for (std::size_t row = matrix.size(); row-- > 0;) {
    lists.put(static_cast<std::uint32_t>(row), graph.degree(static_cast<std::uint32_t>(row)));
  }
  std::vector<std::uint32_t> order;
  order.reserve(matrix.size());
  while (order.size() < matrix.size() && !is_cancelled(cancel)) {
    const std::uint32_t pivot = lists.take_least();
    order.push_back(pivot);
    for (const std::uint32_t row : graph.eliminate(pivot)) {
      lists.take(row);
      lists.put(row, std::min(graph.update(row, pivot), matrix.size() - order.size()));
    }
  }
  return order;
}

}  // namespace foredraw::processors::displacement_seams
