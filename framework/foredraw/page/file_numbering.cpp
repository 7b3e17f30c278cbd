#include <foredraw/page/file_numbering.h>

#include <foredraw/analysis/equal_vertices.h>
#include <foredraw/scene/reorder.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace foredraw {

namespace {

bool says_where(const VertexStream& stream) {
  return stream.semantic == "POSITION" || stream.semantic.starts_with("JOINTS_") ||
         stream.semantic.starts_with("WEIGHTS_");
}

std::vector<VertexStream> those_that_say_where(const std::vector<VertexStream>& streams) {
  std::vector<VertexStream> some;
  std::ranges::copy_if(streams, std::back_inserter(some), says_where);
  return some;
}

VertexStreams without_looks(const VertexStreams& vertices) {
  VertexStreams where{those_that_say_where(vertices.base), {}, vertices.count};
  for (const auto& target : vertices.morph_targets) where.morph_targets.push_back(those_that_say_where(target));
  return where;
}

/// [vertex] the least number in the file of what became it; behind all of them where nothing did.
std::vector<std::uint32_t> first_in_file(const Level& level) {
  const auto destination = level.vertex_destination.view();
  std::vector<std::uint32_t> first(level.vertices->count);
  std::iota(first.begin(), first.end(), static_cast<std::uint32_t>(destination.size()));
  for (std::uint32_t file = 0; file < destination.size(); ++file) {
    const std::uint32_t now = destination[file];
    if (now < first.size()) first[now] = std::min(first[now], file);
  }
  return first;
}

using CornerPlaces = std::array<std::uint32_t, 3>;

/// From the least place on, so that it does not matter which corner comes first.
CornerPlaces corners_at(const IndexStream& stream, std::uint32_t triangle, const Places& places) {
  CornerPlaces corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = places.of_vertex[stream.indices.view()[3 * std::size_t{triangle} + i]];
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

std::vector<std::uint32_t> counted_up(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::uint32_t{0});
  return numbers;
}

}  // namespace

Places places_of(const Level& level) {
  const std::vector<std::uint32_t> same = first_of_equals(without_looks(*level.vertices));
  std::vector<std::uint32_t> in_file = first_in_file(level);
  for (std::uint32_t v = 0; v < same.size(); ++v) in_file[same[v]] = std::min(in_file[same[v]], in_file[v]);

  Places places;
  for (std::uint32_t v = 0; v < same.size(); ++v) {
    if (same[v] == v) places.vertex.push_back(v);
  }
  std::ranges::stable_sort(places.vertex, {}, [&](std::uint32_t v) { return in_file[v]; });
  places.of_vertex.resize(same.size());
  for (std::uint32_t place = 0; place < places.vertex.size(); ++place) places.of_vertex[places.vertex[place]] = place;
  for (std::uint32_t v = 0; v < same.size(); ++v) places.of_vertex[v] = places.of_vertex[same[v]];
  return places;
}

std::vector<std::uint32_t> numbers_in_file(const IndexStream& stream, const Places& places) {
  const auto origin = stream.triangle_origin.view();
  if (origin.size() != stream.triangle_count()) return counted_up(stream.triangle_count());
  if (is_permutation(origin, origin.size())) return {origin.begin(), origin.end()};
  std::vector<std::uint32_t> sorted = counted_up(origin.size());
  std::ranges::stable_sort(sorted, [&](std::uint32_t a, std::uint32_t b) {
    return origin[a] != origin[b] ? origin[a] < origin[b]
                                  : corners_at(stream, a, places) < corners_at(stream, b, places);
  });
  std::vector<std::uint32_t> numbers(sorted.size());
  for (std::uint32_t number = 0; number < sorted.size(); ++number) numbers[sorted[number]] = number;
  return numbers;
}

}  // namespace foredraw
