#include <foredraw/analysis/view_shares.h>

#include <algorithm>
#include <cstddef>

namespace foredraw {

OverdrawCounts draw_in_shares(const Views& views, const Executor& executor,
                              const std::function<OverdrawCounts(const Views&)>& draw) {
  const std::size_t all = views.views.size();
  const std::size_t shares =
      std::clamp<std::size_t>(2 * static_cast<std::size_t>(executor.threads()), 1, std::max<std::size_t>(all, 1));
  std::vector<OverdrawCounts> of_shares(shares);
  executor.for_each(shares, [&](std::size_t share) {
    const auto from = views.views.begin();
    of_shares[share] = draw({{from + static_cast<std::ptrdiff_t>(all * share / shares),
                              from + static_cast<std::ptrdiff_t>(all * (share + 1) / shares)},
                             views.size});
  });
  OverdrawCounts counts = std::move(of_shares[0]);
  for (std::size_t share = 1; share < shares; ++share) {
    for (std::size_t part = 0; part < counts.size(); ++part) {
      counts[part].insert(counts[part].end(), of_shares[share][part].begin(), of_shares[share][part].end());
    }
  }
  return counts;
}

}  // namespace foredraw
