#pragma once
// Figures of several branches, side by side: what every form of a comparison shows.

#include <foredraw/report/comparison.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// One figure, of the input and of every branch; null where nobody measured it.
struct FigureRow {
  std::string evaluator;
  std::string metric;
  const Figure* input = nullptr;
  std::vector<const Figure*> branches;
};

/// Of the totals, by evaluator and metric. They look into the comparison.
std::vector<FigureRow> total_rows(const Comparison& comparison);

/// Of one draw, by its number.
std::vector<FigureRow> draw_rows(const Comparison& comparison, std::size_t draw);

/// How many draws there are in the branch that has the most, and what one of them is called.
std::size_t draw_count(const Comparison& comparison);
std::string draw_name(const Comparison& comparison, std::size_t draw);

/// Whether it is one of a group ("models.amd.acmr"), which tables for people leave out.
bool is_detail(const FigureRow& row);

/// The best value of the input and the branches; not a number where all are equal, nobody measured it, it is neutral,
/// or there is a single branch: nothing competes with it.
double best_of(const FigureRow& row);

/// How a figure differs from the baseline's.
struct Difference {
  double change = 0;              ///< in parts of the baseline
  bool is_within_errors = false;  ///< below two of the larger error, for errors of the same views go together
};

/// Nothing where there is no baseline to compare with, or where a difference is no gain and no loss.
std::optional<Difference> difference(const Figure* figure, const Figure* baseline);

/// The same for people: "-3.8 %"; "~" within the errors; "same" below 0.05 %, but "+2" of exact counts, for two are not
/// the same that differ. Empty where difference() is nothing.
std::string difference_text(const Figure* figure, const Figure* baseline);

/// The baseline of a row: the first branch's.
inline const Figure* baseline_of(const FigureRow& row) { return row.branches.empty() ? nullptr : row.branches.front(); }

}  // namespace foredraw
