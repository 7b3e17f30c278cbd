#include "equal_heights.h"

#include "is_cancelled.h"
#include "sparse_symmetric.h"

namespace foredraw::processors::displacement_seams {

namespace {

/// Which rows name which texel.
struct RowsOfTexels {
  std::vector<std::size_t> starts;
  std::vector<std::uint32_t> rows;

  RowsOfTexels(std::size_t texels, std::span<const EqualityRow> all) : starts(texels + 1, 0) {
    for (const EqualityRow& row : all) {
      for (std::uint32_t i = 0; i < row.count; ++i) ++starts[row.texels[i] + 1];
    }
    for (std::size_t t = 0; t < texels; ++t) starts[t + 1] += starts[t];
    rows.resize(starts[texels]);
    std::vector<std::size_t> ends(starts.begin(), starts.end() - 1);
    for (std::uint32_t r = 0; r < all.size(); ++r) {
      for (std::uint32_t i = 0; i < all[r].count; ++i) rows[ends[all[r].texels[i]]++] = r;
    }
  }
};

struct WeighedRows {
  const std::vector<EqualityRow>& rows;
  double weight;
};

/// The identity, and the rows' squares. Entries are counted before they are made: vectors that grow hold twice as much.
class NormalMatrix {
 public:
  NormalMatrix(std::size_t texels, std::initializer_list<WeighedRows> all) : parts_(all), entry_of_(texels, 0) {
    for (const WeighedRows& part : parts_) of_texels_.emplace_back(texels, part.rows);
  }

  /// Not all of it once it is cancelled.
  SymmetricMatrix made(const std::atomic<bool>* cancel) {
    const std::size_t texels = entry_of_.size();
    SymmetricMatrix matrix;
    matrix.starts.reserve(texels + 1);
    matrix.starts.push_back(0);
    std::vector<std::uint32_t> seen_for(texels, no_row);
    for (std::uint32_t t = 0; t < texels && !is_cancelled(cancel); ++t) {
      std::size_t count = 0;
      for_entries(t, [&](std::uint32_t column, double) {
        count += seen_for[column] != t ? 1 : 0;
        seen_for[column] = t;
      });
      matrix.starts.push_back(matrix.starts.back() + count);
    }
    matrix.columns.reserve(matrix.starts.back());
    matrix.values.reserve(matrix.starts.back());
    for (std::uint32_t t = 0; t < texels && !is_cancelled(cancel); ++t) {
      for_entries(t, [&](std::uint32_t column, double value) {
        std::size_t& entry = entry_of_[column];
        const bool is_there = entry >= matrix.starts[t] && entry < matrix.columns.size();
        if (!is_there || matrix.columns[entry] != column) {
          entry = matrix.columns.size();
          matrix.columns.push_back(column);
          matrix.values.push_back(0);
        }
        matrix.values[entry] += value;
      });
    }
    return matrix;
  }

 private:
  /// Of a row of the matrix, in one sequence; some columns come several times.
  template <class Add>
  void for_entries(std::uint32_t t, const Add& add) const {
    add(t, 1);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      for (std::size_t i = of_texels_[p].starts[t]; i < of_texels_[p].starts[t + 1]; ++i) {
        const EqualityRow& row = parts_[p].rows[of_texels_[p].rows[i]];
        double own = 0;
        for (std::uint32_t k = 0; k < row.count; ++k) own += row.texels[k] == t ? parts_[p].weight * row.weights[k] : 0;
        for (std::uint32_t k = 0; k < row.count; ++k) add(row.texels[k], own * row.weights[k]);
      }
    }
  }

  std::vector<WeighedRows> parts_;
  std::vector<RowsOfTexels> of_texels_;
  std::vector<std::size_t> entry_of_;
};

}  // namespace

std::vector<double> equal_heights(std::vector<double> texels, std::vector<EqualityRow> along,
                                  std::vector<EqualityRow> points, const EqualHeightsWeights& weights) {
  for (;;) {
    const bool has_along = !along.empty();
    const SymmetricMatrix matrix =
        NormalMatrix(texels.size(), {{along, weights.along}, {points, weights.points}}).made(weights.cancel);
    if (is_cancelled(weights.cancel)) return texels;
    along = {};  // rows are as large as the matrix, and not asked again
    const std::vector<std::uint32_t> order = minimum_degree(matrix, weights.cancel);
    if (is_cancelled(weights.cancel)) return texels;
    LdltFactor factor(matrix, order);
    if (factor.multiplications() > weights.most_multiplications && has_along) continue;
    points = {};
    factor.compute(weights.cancel);
    if (is_cancelled(weights.cancel)) return texels;
    factor.solve(texels);
    return texels;
  }
}

}  // namespace foredraw::processors::displacement_seams
