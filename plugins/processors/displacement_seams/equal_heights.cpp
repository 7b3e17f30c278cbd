#include "equal_heights.h"

#include "sparse_symmetric.h"

namespace foredraw::seams {

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
  std::span<const EqualityRow> rows;
  double weight;
};

/// The identity, and the rows' squares.
SymmetricMatrix normal_matrix(std::size_t texels, std::initializer_list<WeighedRows> all) {
  std::vector<RowsOfTexels> of_texels;
  for (const WeighedRows& part : all) of_texels.emplace_back(texels, part.rows);
  SymmetricMatrix matrix;
  matrix.starts.push_back(0);
  std::vector<std::size_t> entry_of(texels, 0);
  for (std::uint32_t t = 0; t < texels; ++t) {
    const std::size_t begin = matrix.columns.size();
    const auto add = [&](std::uint32_t column, double value) {
      std::size_t& entry = entry_of[column];
      if (entry < begin || entry >= matrix.columns.size() || matrix.columns[entry] != column) {
        entry = matrix.columns.size();
        matrix.columns.push_back(column);
        matrix.values.push_back(0);
      }
      matrix.values[entry] += value;
    };
    add(t, 1);
    for (std::size_t p = 0; p < all.size(); ++p) {
      const WeighedRows& part = all.begin()[p];
      for (std::size_t i = of_texels[p].starts[t]; i < of_texels[p].starts[t + 1]; ++i) {
        const EqualityRow& row = part.rows[of_texels[p].rows[i]];
        double own = 0;
        for (std::uint32_t k = 0; k < row.count; ++k) own += row.texels[k] == t ? part.weight * row.weights[k] : 0;
        for (std::uint32_t k = 0; k < row.count; ++k) add(row.texels[k], own * row.weights[k]);
      }
    }
    matrix.starts.push_back(matrix.columns.size());
  }
  return matrix;
}

}  // namespace

std::vector<double> equal_heights(std::span<const double> texels, std::span<const EqualityRow> along,
                                  std::span<const EqualityRow> points, const EqualHeightsWeights& weights) {
  std::vector<double> heights(texels.begin(), texels.end());
  for (const auto rows : {along, along.first(0)}) {
    const SymmetricMatrix matrix = normal_matrix(texels.size(), {{rows, weights.along}, {points, weights.points}});
    const std::vector<std::uint32_t> order = minimum_degree(matrix);
    LdltFactor factor(matrix, order);
    if (factor.multiplications() > weights.most_multiplications && !rows.empty()) continue;
    factor.compute();
    factor.solve(heights);
    break;
  }
  return heights;
}

}  // namespace foredraw::seams
