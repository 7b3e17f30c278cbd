#include "image_parts.h"

#include <algorithm>

namespace foredraw {

namespace {

/// Boxes that become one as their runs turn out to hang together.
class Parts {
 public:
  std::uint32_t add() {
    const auto id = static_cast<std::uint32_t>(parents_.size());
    parents_.push_back(id);
    boxes_.emplace_back();
    return id;
  }

  void grow(std::uint32_t id, const TexelBox& box) { boxes_[root(id)].add(box); }

  /// The older one stays.
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    parents_[b] = a;
    boxes_[a].add(boxes_[b]);
  }

  std::vector<TexelBox> boxes() const {
    std::vector<TexelBox> boxes;
    for (std::uint32_t id = 0; id < parents_.size(); ++id) {
      if (parents_[id] == id) boxes.push_back(boxes_[id]);
    }
    return boxes;
  }

 private:
  std::uint32_t root(std::uint32_t id) {
    while (parents_[id] != id) id = parents_[id] = parents_[parents_[id]];
    return id;
  }

  std::vector<std::uint32_t> parents_;
  std::vector<TexelBox> boxes_;
};

/// Covered texels of a row, side by side.
struct Span {
  std::int64_t first, last;
  std::uint32_t part;
};

}  // namespace

void TexelBox::add(const TexelBox& other) {
  if (other.is_empty()) return;
  if (is_empty()) {
    *this = other;
    return;
  }
  left = std::min(left, other.left);
  top = std::min(top, other.top);
  right = std::max(right, other.right);
  bottom = std::max(bottom, other.bottom);
}

std::vector<TexelBox> image_parts(const AlphaImage& image, const SpriteFrame& frame, std::uint16_t limit,
                                  std::uint32_t reach) {
  // Each texel is made a square of `reach` by `reach` to the right and downwards. Two such squares overlap or touch, be
  // it by a corner, where their texels are no more than `reach` apart along both axes. So parts are what hangs together
  // of all that squares cover, and rows of it need only be compared with the row above.
  const std::int64_t width = frame.width, height = frame.height, side = reach;
  constexpr std::int64_t never = -(std::int64_t{1} << 40);
  std::vector<std::int64_t> last_row(frame.width, never);  // in which a square began that covers the column
  std::vector<Span> spans, above;
  Parts parts;
  for (std::int64_t y = 0; y < height; ++y) {
    const std::uint16_t* row = &image.alpha[(frame.y + static_cast<std::size_t>(y)) * image.width + frame.x];
    for (std::int64_t x = 0, covered = 0; x < width; ++x) {
      if (row[x] > limit) covered = x + side;
      if (x < covered) last_row[static_cast<std::size_t>(x)] = y;
    }
    spans.clear();
    for (std::int64_t x = 0; x < width; ++x) {
      if (y - last_row[static_cast<std::size_t>(x)] >= side) continue;
      if (spans.empty() || spans.back().last != x - 1) spans.push_back({x, x, 0});
      spans.back().last = x;
    }
    std::size_t other = 0;
    for (Span& span : spans) {
      while (other < above.size() && above[other].last < span.first - 1) ++other;
      bool is_new = true;
      for (std::size_t i = other; i < above.size() && above[i].first <= span.last + 1; ++i) {
        if (is_new) span.part = above[i].part;
        parts.unite(span.part, above[i].part);
        is_new = false;
      }
      if (is_new) span.part = parts.add();
      std::int64_t first = span.first, last = span.last;
      while (first <= last && row[first] <= limit) ++first;
      while (last >= first && row[last] <= limit) --last;
      if (first <= last) parts.grow(span.part, {first + frame.x, y + frame.y, last + frame.x, y + frame.y});
    }
    std::swap(spans, above);
  }
  return parts.boxes();
}

}  // namespace foredraw
