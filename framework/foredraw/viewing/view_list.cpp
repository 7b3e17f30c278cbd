#include <foredraw/viewing/view_list.h>

#include <foredraw/viewing/view_directions.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <fstream>
#include <locale>
#include <optional>
#include <sstream>

namespace foredraw {

namespace {

constexpr std::size_t most_views = 100000;

/// Why the line is no view, or the view.
std::variant<View, std::string> view_in(const std::string& line, double distance) {
  std::istringstream words(line);
  words.imbue(std::locale::classic());
  std::string kind;
  glm::dvec3 at(0);
  words >> kind >> at.x >> at.y >> at.z;
  View view;
  view.distance = distance;
  bool is_read = !words.fail() && (kind == "direction" || kind == "position");
  if (is_read && !(words >> std::ws).eof())
    is_read = static_cast<bool>(words >> view.weight) && (words >> std::ws).eof();
  if (!is_read) return "expected 'direction x y z [weight]' or 'position x y z [weight]', but found '" + line + "'";

  const double length = glm::length(at);
  if (!(length > 0) || !std::isfinite(length)) return "the " + kind + " must be finite, and not 0 0 0";
  if (!(view.weight > 0) || !std::isfinite(view.weight)) return std::string("the weight must be above 0");
  if (kind == "position") {
    if (length < 1.01) {
      return "the camera is " + std::to_string(length) +
             " bounding-sphere radii from the centre, but must be outside the sphere (at least 1.01)";
    }
    view.distance = length;
  }
  view.direction = normalised(at);
  return view;
}

}  // namespace

std::variant<std::vector<View>, std::string> read_view_list(const std::string& path, double distance) {
  std::ifstream file(path);
  if (!file)
    return path +
           ": there is no such file, or it cannot be read; views come from icosphere, fibonacci, axes, random, cone "
           "or a file";
  std::vector<View> views;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    auto view = view_in(line, distance);
    const std::string place = path + ":" + std::to_string(number) + ": ";
    if (const auto* why = std::get_if<std::string>(&view)) return place + *why;
    if (views.size() == most_views) return place + "a set has at most " + std::to_string(most_views) + " views";
    views.push_back(std::get<View>(view));
  }
  if (views.empty()) return path + ": it has no views; expected lines such as 'direction 0 0 1'";
  return views;
}

}  // namespace foredraw
