#include "cut_draw.h"

#include <utility>

namespace foredraw::processors::hidden {

void cut(Draw& draw, const std::vector<std::uint8_t>& goes) {
  const IndexStream& before = draw.full().stream();
  const auto corners = before.indices.view();
  const auto of_file = before.triangle_origin.view();
  std::vector<std::uint32_t> indices, origin;
  for (std::uint32_t t = 0; t < goes.size(); ++t) {
    if (goes[t] != 0) continue;
    indices.insert(indices.end(), &corners[3 * std::size_t{t}], &corners[3 * std::size_t{t}] + 3);
    origin.push_back(of_file.empty() ? t : of_file[t]);
  }
  if (indices.empty() && !corners.empty()) {
    indices.assign(3, corners[0]);
    origin.assign(1, of_file.empty() ? 0 : of_file[0]);
  }
  IndexStream after;
  after.indices = Shared(std::move(indices));
  after.triangle_origin = Shared(std::move(origin));
  draw.full().stream() = std::move(after);
}

}  // namespace foredraw::processors::hidden
