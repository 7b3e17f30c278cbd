#include <foredraw/modules/remeshed.h>

#include <foredraw/scene/taken_vertices.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

template <class... Arguments>
void require(bool good, fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  if (!good) throw std::runtime_error(fmt::format(message, std::forward<Arguments>(arguments)...));
}

/// That each of them is below the count; `what` says in words what each names.
void check_all_below(std::span<const std::uint32_t> numbers, std::size_t count, std::string_view what) {
  const auto wrong = std::ranges::find_if(numbers, [&](std::uint32_t number) { return number >= count; });
  if (wrong == numbers.end()) return;
  require(false, "its answer has {} {}, but there are {}", what, *wrong, count);
}

void check(const Draw& draw, const Remesh& answer) {
  const std::size_t triangles = draw.full().stream().triangle_count(), vertices = draw.full().vertices->count;
  require(answer.indices.size() % 3 == 0, "its answer has {} indices, which is no multiple of three",
          answer.indices.size());
  require(answer.indices.size() / 3 <= triangles, "its answer has {} triangles, but the draw has {}",
          answer.indices.size() / 3, triangles);
  require(answer.vertex_from.size() <= vertices, "its answer has {} vertices, but the draw has {}",
          answer.vertex_from.size(), vertices);
  require(!answer.indices.empty() || triangles == 0, "it leaves no triangle of {}", triangles);
  require(!answer.vertex_from.empty() || vertices == 0, "it leaves no vertex of {}", vertices);
  check_all_below(answer.vertex_from, vertices, "a vertex from vertex");
  check_all_below(answer.indices, answer.vertex_from.size(), "an index to vertex");
}

/// [number in the file] = number now: of those that are there several times the first.
std::vector<std::uint32_t> destinations(const Level& before, std::span<const std::uint32_t> vertex_from) {
  std::vector<std::uint32_t> moved(before.vertices->count, no_vertex);
  for (std::size_t v = vertex_from.size(); v-- > 0;) moved[vertex_from[v]] = static_cast<std::uint32_t>(v);
  if (before.vertex_destination.empty()) return moved;
  const auto of_file = before.vertex_destination.view();
  std::vector<std::uint32_t> whole(of_file.begin(), of_file.end());
  for (std::uint32_t& v : whole) v = v == no_vertex ? no_vertex : moved[v];
  return whole;
}

}  // namespace

Draw remeshed(const Draw& draw, Remesh answer) {
  check(draw, answer);
  Draw result = draw;
  Level& level = result.full();
  // Triangles that nobody can follow from where they were.
  std::vector<std::uint32_t> origin(answer.indices.size() / 3, ~std::uint32_t{0});
  level.vertex_destination = Shared(destinations(draw.full(), answer.vertex_from));
  level.vertices = std::make_shared<const VertexStreams>(taken_vertices(*draw.full().vertices, answer.vertex_from));
  IndexStream stream;
  stream.indices = Shared(std::move(answer.indices));
  stream.triangle_origin = Shared(std::move(origin));
  level.orders = {std::move(stream)};
  return result;
}

}  // namespace foredraw
