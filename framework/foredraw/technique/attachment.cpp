#include <foredraw/technique/attachment.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

std::optional<std::string> mistake_of(const Film& film) {
  const auto is_edge = [](int pixels) { return pixels >= 1 && pixels <= largest_picture; };
  if (!is_edge(film.width) || !is_edge(film.height)) {
    return "has pictures of " + std::to_string(film.width) + " x " + std::to_string(film.height) +
           " pixels, but an edge has 1 to " + std::to_string(largest_picture);
  }
  if (film.frames.empty()) return "has no frame";
  const std::size_t bytes = 3 * static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  for (std::size_t i = 0; i < film.frames.size(); ++i) {
    if (film.frames[i].size() == bytes) continue;
    return "has " + std::to_string(film.frames[i].size()) + " bytes in frame " + std::to_string(i) + ", but " +
           std::to_string(film.width) + " x " + std::to_string(film.height) + " pixels are " + std::to_string(bytes);
  }
  return std::nullopt;
}

std::optional<std::string> mistake_of(const Chart& chart) {
  if (chart.lines.empty() || chart.lines.front().values.empty()) return "has no value";
  const std::size_t count = chart.lines.front().values.size();
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    const Chart::Line& line = chart.lines[i];
    if (line.name.empty()) return "has a line without a name";
    const auto before = chart.lines.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find_if(chart.lines.begin(), before, [&](const Chart::Line& other) { return other.name == line.name; }) !=
        before) {
      return "has two lines '" + line.name + "'";
    }
    if (line.values.size() != count) {
      return "has " + std::to_string(count) + " values in one line, but " + std::to_string(line.values.size()) +
             " in '" + line.name + "'";
    }
  }
  if (chart.mark && !std::isfinite(chart.mark->value)) return "has a mark that is not finite";
  if (chart.mark && chart.mark->name.empty()) return "has a mark without a name";
  return std::nullopt;
}

}  // namespace

const std::string& name_of(const Attachment& attachment) {
  return std::visit([](const auto& content) -> const std::string& { return content.name; }, attachment);
}

std::size_t frames_of(const Attachment& attachment) {
  if (const Film* film = std::get_if<Film>(&attachment)) return film->frames.size();
  const Chart& chart = std::get<Chart>(attachment);
  return chart.lines.empty() ? 0 : chart.lines.front().values.size();
}

std::optional<std::string> mistake_in(const Attachment& attachment) {
  if (name_of(attachment).empty()) return "has no name";
  return std::visit([](const auto& content) { return mistake_of(content); }, attachment);
}

}  // namespace foredraw
