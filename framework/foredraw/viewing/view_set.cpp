#include <foredraw/viewing/view_set.h>

#include <foredraw/base/diagnostics.h>
#include <foredraw/base/whole_number.h>
#include <foredraw/viewing/view_directions.h>
#include <foredraw/viewing/view_list.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <variant>
#include <vector>

namespace foredraw {

namespace {

constexpr std::array icosphere_counts = {12, 42, 162, 642, 2562};
constexpr int default_icosphere = 162;
constexpr int default_count = 100;
constexpr int axis_count = 6;

/// The number of views that an icosphere set asks for, spelled as a bare number or by its count.
std::int64_t icosphere_count(const ViewSet& set) {
  if (const auto number = whole_number(set.views)) return *number;
  return set.count.value_or(default_icosphere);
}

bool is_icosphere(const ViewSet& set) { return set.views == "icosphere" || whole_number(set.views); }

/// Unit length; nothing where the text is no direction.
std::optional<glm::dvec3> direction_in(const std::string& text) {
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  glm::dvec3 v(0);
  words >> v.x >> v.y >> v.z;
  const double length = glm::length(v);
  if (words.fail() || !(words >> std::ws).eof() || !(length > 0) || !std::isfinite(length)) return std::nullopt;
  return normalised(v);
}

/// Of a set that is no file, and has no mistakes.
std::vector<View> views_by_word(const ViewSet& set) {
  const auto count = static_cast<std::size_t>(set.count.value_or(default_count));
  Directions directions;
  if (is_icosphere(set)) {
    directions = icosphere_directions(static_cast<std::size_t>(icosphere_count(set)));
  } else if (set.views == "axes") {
    directions = axis_directions();
  } else if (set.views == "random") {
    directions = random_directions(count, static_cast<std::uint64_t>(set.seed));
  } else if (set.views == "cone") {
    directions = turned_to(direction_in(set.axis).value(), fibonacci_directions(count, set.angle));
  } else {
    directions = fibonacci_directions(count);
  }
  std::vector<View> views;
  for (const glm::dvec3& direction : directions) views.push_back({direction, set.distance.value_or(0)});
  return views;
}

std::string words_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + ", ";
  return text;
}

std::optional<std::string> mistake_in_icosphere(const ViewSet& set) {
  const std::int64_t count = icosphere_count(set);
  if (set.count && *set.count != count) {
    return "views is " + set.views + ", but count is " + std::to_string(*set.count) + "; leave one of them out";
  }
  if (std::find(icosphere_counts.begin(), icosphere_counts.end(), count) == icosphere_counts.end()) {
    return "an icosphere has 12, 42, 162, 642 or 2562 views, not " + std::to_string(count);
  }
  return std::nullopt;
}

std::optional<std::string> mistake_in_word(const ViewSet& set) {
  static const std::vector<std::string> words = {"icosphere", "fibonacci", "axes", "random", "cone"};
  if (std::find(words.begin(), words.end(), set.views) == words.end()) {
    const std::string_view meant = nearest(set.views, words);
    return "there is no view set '" + set.views + "'; " +
           (meant.empty() ? "expected " + words_text(words) + "a number or a file (with a dot or a slash in its path)"
                          : "did you mean '" + std::string(meant) + "'?");
  }
  if (set.views == "axes" && set.count.value_or(axis_count) != axis_count) {
    return "there are 6 views along the axes, not " + std::to_string(*set.count);
  }
  if (set.count && *set.count < 1) {
    return "count is " + std::to_string(*set.count) + ", but there must be at least 1 view";
  }
  if (set.views == "cone" && !direction_in(set.axis)) {
    return "axis is '" + set.axis + "', but must be a direction such as '0 1 0'";
  }
  if (set.views == "cone" && !(set.angle > 0 && set.angle <= 180)) {
    return "angle is " + std::to_string(set.angle) + ", but must be above 0 and at most 180 degrees";
  }
  return std::nullopt;
}

void turn_at_random(std::vector<View>& views, std::uint64_t seed) {
  Directions directions;
  for (const View& view : views) directions.push_back(view.direction);
  directions = turned_at_random(directions, seed);
  for (std::size_t i = 0; i < directions.size(); ++i) views[i].direction = directions[i];
}

}  // namespace

std::optional<std::string> mistake_in(const ViewSet& set) {
  if (set.distance && !(*set.distance > 1 && std::isfinite(*set.distance))) {
    return "distance is " + std::to_string(*set.distance) +
           " bounding-sphere radii, but the camera must be outside the sphere (more than 1)";
  }
  if (set.size < 1) return "size is " + std::to_string(set.size) + ", but there must be at least 1 pixel";
  if (is_icosphere(set)) return mistake_in_icosphere(set);
  if (!is_view_list(set.views)) return mistake_in_word(set);
  if (set.count) return "views is the file " + set.views + ", which says how many there are; leave count out";
  return std::nullopt;
}

std::variant<Views, std::string> views_of(const ViewSet& set) {
  if (auto mistake = mistake_in(set)) return std::move(*mistake);
  Views made{{}, set.size};
  if (!is_icosphere(set) && is_view_list(set.views)) {
    auto listed = read_view_list(set.views, set.distance.value_or(0));
    if (auto* why = std::get_if<std::string>(&listed)) return std::move(*why);
    made.views = std::get<std::vector<View>>(std::move(listed));
  } else {
    made.views = views_by_word(set);
  }
  if (set.rotation) turn_at_random(made.views, static_cast<std::uint64_t>(*set.rotation));
  return made;
}

Views make_views(const ViewSet& set) {
  auto made = views_of(set);
  if (const auto* why = std::get_if<std::string>(&made)) throw std::invalid_argument(*why);
  return std::get<Views>(std::move(made));
}

}  // namespace foredraw
