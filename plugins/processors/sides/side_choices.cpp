#include "side_choices.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace foredraw::sides {

Counted counted(std::span<const Side> wanted) {
  Counted count{wanted.size()};
  for (const Side sides : wanted) {
    count.added += sides == both;
    count.turned += sides == back;
  }
  return count;
}

/// What shows both sides of so many of its triangles, such as a sail, gains nothing by copies.
constexpr double sheet = 0.9;

std::map<DrawId, Choice> first_choices(const std::map<DrawId, Counted>& counts, std::size_t triangles,
                                       const ChoiceOptions& options) {
  double allowed = options.most_added * static_cast<double>(triangles);
  std::vector<std::pair<std::size_t, DrawId>> by_added;
  for (const auto& [id, count] : counts) by_added.emplace_back(count.added, id);
  std::ranges::sort(by_added);
  std::map<DrawId, Choice> choices;
  for (const auto& [added, id] : by_added) {
    const Counted& count = counts.at(id);
    if (count.backs() == 0) {
      choices[id] = Choice::single_sided;
      continue;
    }
    const bool is_sheet = static_cast<double>(added) > sheet * static_cast<double>(count.triangles);
    if (!is_sheet) allowed -= static_cast<double>(added);
    const bool may_split = options.split && count.backs() < count.triangles;
    choices[id] = allowed >= 0 && !is_sheet ? Choice::copies : may_split ? Choice::two_draws : Choice::left;
  }
  return choices;
}

bool pays(Choice choice, const Counted& count, double saved, double visible, double vertices,
          const ChoiceOptions& options) {
  constexpr double misses = 0.7;            // of a triangle in a good order: vertices shaded
  constexpr double least_of_a_draw = 0.01;  // of what is seen: a draw call is worth it from there on
  if (choice == Choice::left || choice == Choice::single_sided) return true;
  const double cost = choice == Choice::two_draws
                          ? least_of_a_draw
                          : options.vertex_weight * misses * static_cast<double>(count.added) / vertices;
  return saved > 0 && saved >= cost * visible;
}

}  // namespace foredraw::sides
