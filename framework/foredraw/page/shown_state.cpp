#include <foredraw/page/private/shown_state.h>

#include <foredraw/page/file_numbering.h>

#include <foredraw/base/counted.h>
#include <foredraw/collapses/geomorphs.h>
#include <foredraw/viewing/stretch.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

/// Of a part at a level.
std::vector<std::uint32_t> shown_ancestors(const Scene& scene, std::size_t level, const ShownPart& fine,
                                           const ShownPart& coarse) {
  const auto ancestors = ancestors_of(scene, {fine.part.draw, level});
  if (ancestors.empty()) return {};
  const Places places = places_of(scene.draws[coarse.part.draw].level(level + 1));
  std::vector<std::uint32_t> number(places.vertex.size(), no_vertex);  // [place] among those shown
  for (std::uint32_t i = 0; i < coarse.vertices.size(); ++i) number[places.of_vertex[coarse.vertices[i]]] = i;
  std::vector<std::uint32_t> shown;
  for (const std::uint32_t vertex : fine.vertices) {
    shown.push_back(number[places.of_vertex[ancestors[vertex]]]);
    if (shown.back() == no_vertex) return {};
  }
  return shown;
}

double error_of(const Scene& scene, const ShownSubject& shown) {
  double most = 0;
  const PosedNodes nodes = posed_nodes(scene);
  for (const ShownPart& part : shown.parts) {
    const double error = scene.draws[part.part.draw].full().error;
    if (error > 0) most = std::max(most, error * most_stretch(scene, part.part, nodes));
  }
  return most;
}

void add_coarser(ShownState& state, std::span<const Scene> levels, ShownTrianglesOnce& once) {
  std::size_t count = 1;
  for (const SubjectPart& part : state.subject->parts) {
    count = std::max(count, state.scene->draws[part.draw].levels.size());
  }
  for (const Scene& scene : levels.first(count - 1)) {
    state.coarser.push_back({&scene, state.subject, shown_subject(scene, *state.subject, once), ""});
    state.coarser.back().error = error_of(scene, state.coarser.back().shown);
  }
  ShownState* finer = &state;
  for (std::size_t level = 0; level + 1 < count; ++level) {
    ShownState& coarser = state.coarser[level];
    for (const ShownPart& part : finer->shown.parts) {
      const auto same = std::ranges::find(coarser.shown.parts, part.part, &ShownPart::part);
      finer->ancestors.emplace_back();
      if (same != coarser.shown.parts.end())
        finer->ancestors.back() = shown_ancestors(*state.scene, level, part, *same);
    }
    finer = &coarser;
  }
}

}  // namespace

ShownState shown_state(const ShownScene& scene, std::span<const Subject> of_input, std::size_t number,
                       ShownTrianglesOnce& once) {
  if (!scene.absent.empty()) return {nullptr, nullptr, {}, scene.absent};
  const Subject* subject = counterpart(scene.subjects, of_input, number);
  if (subject == nullptr) {
    return {nullptr,
            nullptr,
            {},
            fmt::format("it has {}, the input has {}", counted(scene.subjects.size(), "subject"),
                        counted(of_input.size(), "subject"))};
  }
  ShownState state{scene.scene, subject, shown_subject(*scene.scene, *subject, once), ""};
  const auto is_empty = [](const ShownPart& part) { return part.triangles() == 0; };
  if (std::ranges::all_of(state.shown.parts, is_empty)) state.absent = "it draws no triangles of this subject";
  add_coarser(state, scene.coarser, once);
  return state;
}

}  // namespace foredraw
