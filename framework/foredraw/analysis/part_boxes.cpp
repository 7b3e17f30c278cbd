#include <foredraw/analysis/part_boxes.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

constexpr double much_larger = 8;
constexpr std::size_t most_parts = 16;

BoxTree::Box box_of(const std::array<glm::vec3, 3>& corners) {
  BoxTree::Box box;
  for (const glm::vec3& corner : corners) box.add(corner);
  return box;
}

int longest_axis(const BoxTree::Box& box) {
  const glm::vec3 size = box.max - box.min;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// A point that was reckoned, with what it may be off.
void add_near(BoxTree::Box& box, const glm::dvec3& point, double off) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float low = std::nextafter(static_cast<float>(point[axis] - off), -infinity);
    const float high = std::nextafter(static_cast<float>(point[axis] + off), infinity);
    box.min[axis] = std::min(box.min[axis], low);
    box.max[axis] = std::max(box.max[axis], high);
  }
}

}  // namespace

std::size_t boxes_worth_having(const std::array<glm::vec3, 3>& corners) {
  const glm::dvec3 a(corners[0]);
  const glm::dvec3 normal = glm::abs(glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a));
  const double area = (normal.x + normal.y + normal.z) / 2;  // as it is seen along the axes, as the box's is
  const double parts = half_area(box_of(corners)) / (much_larger * area);
  if (std::isnan(parts)) return 1;  // a point
  return static_cast<std::size_t>(std::clamp(parts, 1.0, static_cast<double>(most_parts)));
}

void add_part_boxes(const std::array<glm::vec3, 3>& corners, std::size_t parts, std::vector<BoxTree::Box>& boxes) {
  const BoxTree::Box whole = box_of(corners);
  if (parts <= 1) return boxes.push_back(whole);
  const int axis = longest_axis(whole);
  const double first = whole.min[axis], length = double{whole.max[axis]} - first;
  const auto plane = [&](std::size_t i) {
    return first + length * static_cast<double>(i) / static_cast<double>(parts);
  };
  for (std::size_t i = 0; i < parts; ++i) {
    const double from = i == 0 ? first : plane(i), to = i + 1 == parts ? double{whole.max[axis]} : plane(i + 1);
    BoxTree::Box box;
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::dvec3 a(corners[c]), b(corners[(c + 1) % 3]);
      if (a[axis] >= from && a[axis] <= to) box.add(corners[c]);
      const double off = (glm::length(a) + glm::length(b)) * 0x1p-48;
      for (const double at : {from, to}) {
        if ((a[axis] < at) != (b[axis] < at)) add_near(box, a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a), off);
      }
    }
    boxes.push_back(box);
  }
}

}  // namespace foredraw
