#include "hop_table.h"

#include "plane.h"

#include <algorithm>

namespace foredraw::processors::particle_trim {

namespace {

void cut_off_at(double most, std::vector<double>& row) {
  for (double& cost : row) {
    if (!(cost <= most)) cost = infinity;
  }
  while (!row.empty() && row.back() == infinity) row.pop_back();
}

}  // namespace

std::shared_ptr<const HopTable> HopTable::single(std::vector<std::vector<double>> costs) {
  auto table = std::make_shared<HopTable>();
  table->costs_ = std::move(costs);
  for (std::vector<double>& row : table->costs_) cut_off_at(std::numeric_limits<double>::max(), row);
  return table;
}

std::shared_ptr<const HopTable> HopTable::joined(std::shared_ptr<const HopTable> a, std::shared_ptr<const HopTable> b,
                                                 double most) {
  auto table = std::make_shared<HopTable>();
  const std::size_t edges = a->edges();
  table->costs_.resize(edges);
  for (std::size_t i = 0; i < edges; ++i) {
    const std::vector<double>& head = a->from(i);
    std::size_t length = 0;
    for (std::size_t m = 1; m < head.size(); ++m) length = std::max(length, m + b->from(i + m).size());
    std::vector<double>& row = table->costs_[i];
    row.assign(std::min(length, edges + 1), infinity);
    for (std::size_t m = 1; m < head.size(); ++m) {
      const double before = head[m];
      if (before == infinity) continue;
      const std::vector<double>& tail = b->from(i + m);
      const std::size_t end = std::min(tail.size(), row.size() > m ? row.size() - m : 0);
      double* to = row.data() + m;
      for (std::size_t k = 1; k < end; ++k) to[k] = std::min(to[k], before + tail[k]);
    }
    cut_off_at(most, row);
  }
  table->first_ = std::move(a);
  table->second_ = std::move(b);
  return table;
}

double HopTable::cost(std::size_t i, std::size_t steps) const {
  const std::vector<double>& row = from(i);
  return steps > 0 && steps < row.size() ? row[steps] : infinity;
}

void HopTable::trace(std::size_t i, std::size_t steps, std::vector<std::size_t>& hops) const {
  if (!first_) {
    hops.push_back(steps);
    return;
  }
  const double wanted = cost(i, steps);
  std::size_t m = 1;
  while (first_->cost(i, m) + second_->cost(i + m, steps - m) != wanted) ++m;
  first_->trace(i, m, hops);
  second_->trace(i + m, steps - m, hops);
}

}  // namespace foredraw::processors::particle_trim
