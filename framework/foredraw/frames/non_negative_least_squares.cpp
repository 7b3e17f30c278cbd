#include <foredraw/frames/non_negative_least_squares.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace foredraw {

namespace {

using Column = std::vector<double>;

double dot(const Column& a, const Column& b, std::size_t from = 0) {
  double sum = 0;
  for (std::size_t i = from; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Reflects all columns so that the first of them has nothing below row `at` any more; the other rows above stay.
void reflect(std::vector<Column>& columns, std::size_t first, std::size_t at) {
  Column mirror(columns[first].size(), 0.0);
  for (std::size_t i = at; i < mirror.size(); ++i) mirror[i] = columns[first][i];
  const double length = std::sqrt(dot(mirror, mirror, at));
  if (length == 0) return;
  mirror[at] += mirror[at] < 0 ? -length : length;
  const double squared = dot(mirror, mirror, at);
  for (std::size_t c = first; c < columns.size(); ++c) {
    const double share = 2 * dot(mirror, columns[c], at) / squared;
    for (std::size_t i = at; i < mirror.size(); ++i) columns[c][i] -= share * mirror[i];
  }
  for (std::size_t i = at + 1; i < mirror.size(); ++i) columns[first][i] = 0;
}

/// The columns and, behind them, what they are to add up to: as few rows as there are unknowns, and as long.
std::vector<Column> triangle_of(std::vector<Column> columns) {
  const std::size_t unknowns = columns.size() - 1;
  for (Column& column : columns) column.resize(std::max(column.size(), unknowns), 0.0);
  for (std::size_t i = 0; i < unknowns; ++i) reflect(columns, i, i);
  for (Column& column : columns) column.resize(unknowns);
  return columns;
}

/// What the chosen columns are to be multiplied with; nothing where the last one is a sum of the others.
std::vector<double> solved(const std::vector<Column>& columns, const std::vector<std::size_t>& chosen) {
  constexpr double least = 1e-9;  // of a column of length 1 that is new
  std::vector<Column> some;
  for (const std::size_t c : chosen) some.push_back(columns[c]);
  some.push_back(columns.back());
  for (std::size_t i = 0; i < chosen.size(); ++i) reflect(some, i, i);
  if (!(std::abs(some[chosen.size() - 1][chosen.size() - 1]) > least)) return {};
  std::vector<double> x(chosen.size());
  for (std::size_t i = chosen.size(); i-- > 0;) {
    double left = some.back()[i];
    for (std::size_t j = i + 1; j < chosen.size(); ++j) left -= some[j][i] * x[j];
    x[i] = left / some[i][i];
  }
  return x;
}

/// Takes columns in one after the other, the steepest first, and out again where one would fall below zero.
class ActiveSet {
 public:
  explicit ActiveSet(std::vector<Column> columns)
      : columns_(std::move(columns)), x_(columns_.size() - 1, 0.0), is_barred_(x_.size(), false) {}

  std::vector<double> solution() {
    const std::size_t most_rounds = 30 * x_.size();
    for (std::size_t round = 0; round < most_rounds; ++round) {
      const std::size_t next = steepest();
      if (next == x_.size()) break;
      chosen_.push_back(next);
      std::vector<double> wanted = solved(columns_, chosen_);
      if (wanted.empty() || !(wanted.back() > 0)) {  // it is not new, or rounding alone made it steep
        chosen_.pop_back();
        is_barred_[next] = true;
        continue;
      }
      while (!wanted.empty() && !go_to(wanted)) wanted = solved(columns_, chosen_);
      is_barred_.assign(x_.size(), false);
    }
    return x_;
  }

 private:
  /// The column along which the error falls fastest; x_.size(): there is none. Of nearly equal ones the first.
  std::size_t steepest() const {
    Column left = columns_.back();
    for (const std::size_t c : chosen_) {
      for (std::size_t i = 0; i < left.size(); ++i) left[i] -= x_[c] * columns_[c][i];
    }
    std::size_t best = x_.size();
    double slope = 1e-13 * std::sqrt(dot(columns_.back(), columns_.back()));
    for (std::size_t c = 0; c < x_.size(); ++c) {
      if (is_barred_[c] || std::ranges::find(chosen_, c) != chosen_.end()) continue;
      const double of = dot(columns_[c], left);
      if (of > slope * (1 + 1e-9)) best = c, slope = of;
    }
    return best;
  }

  /// Goes there, or as far as nothing falls below zero; what comes to zero is left out. Whether it got there.
  bool go_to(const std::vector<double>& wanted) {
    double step = 1;
    std::size_t stopped = chosen_.size();
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (wanted[i] > 0) continue;
      const double now = x_[chosen_[i]];
      const double part = now > 0 ? now / (now - wanted[i]) : 0;
      if (stopped == chosen_.size() || part < step) step = part, stopped = i;
    }
    for (std::size_t i = 0; i < chosen_.size(); ++i) x_[chosen_[i]] += step * (wanted[i] - x_[chosen_[i]]);
    if (stopped == chosen_.size()) return true;
    x_[chosen_[stopped]] = 0;
    std::erase_if(chosen_, [&](std::size_t c) {
      const bool is_gone = !(x_[c] > 0);
      if (is_gone) x_[c] = 0;
      return is_gone;
    });
    return chosen_.empty();
  }

  std::vector<Column> columns_;  // of length 1 or 0; the last one is what they are to add up to
  std::vector<double> x_;
  std::vector<std::size_t> chosen_;
  std::vector<bool> is_barred_;  // until the next one is taken in
};

}  // namespace

std::vector<double> non_negative_least_squares(std::span<const double> rows, std::span<const double> wanted,
                                               std::size_t unknowns) {
  if (unknowns == 0) return {};
  std::vector<Column> columns(unknowns + 1, Column(wanted.size()));
  std::vector<double> lengths(unknowns, 0.0);
  for (std::size_t c = 0; c < unknowns; ++c) {
    for (std::size_t r = 0; r < wanted.size(); ++r) columns[c][r] = rows[r * unknowns + c];
    lengths[c] = std::sqrt(dot(columns[c], columns[c]));
    for (double& each : columns[c]) each = lengths[c] > 0 ? each / lengths[c] : 0;
  }
  columns.back().assign(wanted.begin(), wanted.end());
  std::vector<double> x = ActiveSet(triangle_of(std::move(columns))).solution();
  for (std::size_t c = 0; c < unknowns; ++c) x[c] = lengths[c] > 0 ? x[c] / lengths[c] : 0;
  return x;
}

}  // namespace foredraw
