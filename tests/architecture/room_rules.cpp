#include "room_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

namespace foredraw::architecture {

namespace {

std::size_t floor_of(const std::string& name, const std::vector<Room>& rooms) {
  std::size_t floor = 0;
  for (const Room& room : rooms) {
    if (room.name != name) continue;
    for (const std::string& link : room.links) floor = std::max(floor, floor_of(link, rooms) + 1);
  }
  return floor;
}

std::string between(const std::string& text, std::string_view from, std::string_view to) {
  const std::size_t start = text.find(from);
  if (start == std::string::npos) return {};
  const std::size_t first = start + from.size();
  return text.substr(first, text.find(to, first) - first);
}

/// How often the first column of the section's table names each room.
std::map<std::string, int> named_in_table(const std::string& section) {
  static const std::regex name(R"(`(\w+)`)");
  std::map<std::string, int> named;
  std::istringstream lines(section);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string column = between(line, "|", "|");
    for (std::sregex_iterator match(column.begin(), column.end(), name), end; match != end; ++match) {
      ++named[(*match)[1]];
    }
  }
  return named;
}

}  // namespace

std::string picture_of(const std::vector<Room>& rooms) {
  std::map<std::size_t, std::string> floors;
  for (const Room& room : rooms) {
    const std::size_t floor = floor_of(room.name, rooms);
    std::string line = fmt::format("{:2}  {:<13}", floor, room.name);
    for (const std::string& link : room.links) line += ' ' + link;
    line.erase(line.find_last_not_of(' ') + 1);
    floors[floor] += line + '\n';
  }
  std::string picture;
  for (const auto& [floor, lines] : floors) picture += lines;
  return picture;
}

Breaches room_breaches(const std::string& page, const std::vector<Room>& rooms) {
  Breaches breaches;
  const std::string section = between(page, "\n## Rooms\n", "\n## ");
  const std::string picture = picture_of(rooms);
  if (between(section, "\n```\n", "```\n") != picture) {
    breaches.push_back("the picture of the rooms differs from framework/cmake/ForedrawBuild.cmake, which gives\n" +
                       picture);
  }
  std::map<std::string, int> named = named_in_table(section);
  named.erase("runtime");
  for (const Room& room : rooms) {
    if (named[room.name] != 1) {
      breaches.push_back(fmt::format("the table names the room {} {} times, not once", room.name, named[room.name]));
    }
    named.erase(room.name);
  }
  for (const auto& [name, times] : named) breaches.push_back("the table names " + name + ", which is no room");
  return breaches;
}

}  // namespace foredraw::architecture
