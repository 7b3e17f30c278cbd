#include <foredraw/viewing/shared_views.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace foredraw {

namespace {

/// Hands out views, each once before any is handed out again.
class Pool {
 public:
  explicit Pool(std::span<const View> views) : views_(views) { refill(); }

  /// The one that is farthest from all of `taken`; the first of those that are left where none is taken.
  std::size_t take(std::span<const std::size_t> taken) {
    if (left_.empty()) refill();
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left_.size(); ++i) {
      double nearest = -1;  // the cosine to it
      for (const std::size_t other : taken) {
        nearest = std::max(nearest, glm::dot(views_[left_[i]].direction, views_[other].direction));
      }
      if (nearest < least) {
        least = nearest;
        best = i;
      }
    }
    const std::size_t view = left_[best];
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(best));
    return view;
  }

 private:
  void refill() {
    left_.resize(views_.size());
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  std::span<const View> views_;
  std::vector<std::size_t> left_;
};

}  // namespace

std::vector<std::vector<std::size_t>> shared_views(std::span<const View> views, std::size_t poses, std::size_t looks) {
  std::vector<std::vector<std::size_t>> shares(poses);
  Pool pool(views);
  const std::size_t all = std::min(looks, poses * views.size());
  for (std::size_t pose = 0; pose < poses; ++pose) {
    const std::size_t count = all * (pose + 1) / poses - all * pose / poses;
    for (std::size_t i = 0; i < count; ++i) shares[pose].push_back(pool.take(shares[pose]));
    std::ranges::sort(shares[pose]);
  }
  return shares;
}

}  // namespace foredraw
