#include <foredraw/page/shown_subject.h>

#include <foredraw/page/file_numbering.h>

#include <foredraw/base/counted.h>
#include <foredraw/viewing/posed_positions.h>
#include <foredraw/viewing/subject_geometry.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

std::vector<glm::vec3> chosen_positions(std::span<const glm::vec3> positions, std::span<const std::uint32_t> vertices) {
  std::vector<glm::vec3> some;
  some.reserve(vertices.size());
  for (const std::uint32_t vertex : vertices) some.push_back(positions[vertex]);
  return some;
}

/// `numbers`: of the stream's triangles in the file. `shown`: those that are shown.
ShownOrder shown_order(const IndexStream& stream, std::span<const std::uint32_t> numbers, const ShownTriangles& shown) {
  constexpr std::uint32_t hidden = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(numbers.size(), hidden);  // [number in the file] among those shown
  for (std::uint32_t i = 0; i < shown.triangles.size(); ++i) place[shown.triangles[i]] = i;
  ShownOrder order;
  std::vector<std::uint32_t> offsets{0};
  const auto end_cluster = [&] {  // one of which nothing is shown is none
    const auto end = static_cast<std::uint32_t>(order.triangles.size());
    if (offsets.back() < end) offsets.push_back(end);
  };
  std::size_t cluster = 0;
  for (std::uint32_t t = 0; t < numbers.size(); ++t) {
    if (stream.clusters && t == stream.clusters->offsets[cluster + 1]) {
      ++cluster;
      end_cluster();
    }
    if (place[numbers[t]] == hidden) continue;
    order.triangles.push_back(place[numbers[t]]);
    order.drawn.push_back(t);
  }
  end_cluster();
  if (stream.clusters && offsets.size() > 1) order.clusters = std::move(offsets);
  return order;
}

ShownPart shown_part(const Level& level, const SubjectPart& part, std::span<const glm::vec3> positions,
                     std::size_t at_most, ShownTrianglesOnce& once) {
  const Places places = places_of(level);
  const std::vector<std::uint32_t> first = numbers_in_file(level.stream(), places);
  const auto given = level.stream().indices.view();
  std::vector<std::uint32_t> indices(given.size());
  for (std::size_t i = 0; i < 3 * first.size(); ++i) {
    indices[3 * std::size_t{first[i / 3]} + i % 3] = places.of_vertex[given[i]];
  }
  ShownTriangles shown = once.of(chosen_positions(positions, places.vertex), indices, at_most);

  ShownPart result{part, std::move(shown.indices), std::move(shown.vertices), {}};
  for (std::uint32_t& vertex : result.vertices) vertex = places.vertex[vertex];
  for (const IndexStream& stream : level.orders) {
    result.orders.push_back(shown_order(stream, numbers_in_file(stream, places), shown));
  }
  return result;
}

std::string sentence(std::string text, const std::string& next) {
  return text.empty() || next.empty() ? text + next : text + ". " + next;
}

/// What of a subject is shown otherwise than it is measured, or not at all.
struct LeftOut {
  std::size_t all_triangles = 0;
  std::size_t shown_triangles = 0;
  std::size_t blended = 0;
  std::size_t masked = 0;

  std::string note() const {
    std::string text;
    if (shown_triangles < all_triangles) {
      text = fmt::format("{} of {} triangles are shown; counts and ratios here are those of the shown triangles",
                         counted(shown_triangles), counted(all_triangles));
    }
    if (blended > 0) text = sentence(text, counted(blended, "blended draw") + " left out, as in the figures");
    if (masked > 0) {
      text = sentence(text, "The holes of " + counted(masked, "masked draw") +
                                " are not shown; figures leave them out, so ratios here differ");
    }
    return text;
  }
};

}  // namespace

std::vector<glm::vec3> ShownPart::positions(const Scene& scene, const PosedNodes& nodes) const {
  return chosen_positions(posed_positions(scene, part, nodes), vertices);
}

ShownSubject shown_subject(const Scene& scene, const Subject& subject, ShownTrianglesOnce& once) {
  const PosedNodes nodes = posed_nodes(scene);
  const std::size_t all = count_triangles(scene, subject);
  ShownSubject shown;
  LeftOut left_out;
  std::size_t share_before = 0;
  for (const SubjectPart& part : subject.parts) {
    const Draw& draw = scene.draws[part.draw];
    if (draw.topology != Topology::triangles) continue;
    if (is_blended(scene, draw)) {
      ++left_out.blended;
      continue;
    }
    const std::size_t triangles = draw.full().stream().triangle_count();
    left_out.all_triangles += triangles;
    const auto positions = posed_positions(scene, part, nodes);
    if (positions.empty()) continue;
    // Shares are cut from one whole, so that together they are no more than it.
    const std::size_t share_end =
        all <= most_shown_triangles ? left_out.all_triangles : left_out.all_triangles * most_shown_triangles / all;
    shown.parts.push_back(shown_part(draw.full(), part, positions, share_end - share_before, once));
    share_before = share_end;
    left_out.shown_triangles += shown.parts.back().triangles();
    const Material* material = scene.material_of(draw);
    if (material != nullptr && material->alpha_mode == AlphaMode::mask) ++left_out.masked;
  }
  shown.note = left_out.note();
  return shown;
}

}  // namespace foredraw
