#include "link_rules.h"

#include <algorithm>
#include <sstream>

namespace foredraw::architecture {

namespace {

struct Link {
  std::string file, heading;  ///< the file from the project's root; the heading as after '#', or empty
  std::string text;           ///< as the page has it
  int line = 0;
};

/// The lines outside of blocks of code; those within are empty.
std::vector<std::string> prose(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  bool is_code = false;
  for (std::string line; std::getline(in, line);) {
    const bool is_fence =
        line.find_first_not_of(' ') != std::string::npos && line.compare(line.find_first_not_of(' '), 3, "```") == 0;
    if (is_fence) is_code = !is_code;
    lines.push_back(is_code || is_fence ? std::string() : line);
  }
  return lines;
}

std::vector<Link> links_of(const std::string& path, const std::string& text) {
  std::vector<Link> links;
  int number = 0;
  for (const std::string& line : prose(text)) {
    ++number;
    for (std::size_t at = line.find("]("); at != std::string::npos; at = line.find("](", at)) {
      at += 2;
      const std::size_t end = line.find(')', at);
      if (end == std::string::npos) break;
      const std::string target = line.substr(at, end - at);
      if (target.empty() || target.find_first_of(" :") != std::string::npos) continue;
      const std::size_t hash = std::min(target.find('#'), target.size());
      const std::filesystem::path file =
          hash == 0 ? std::filesystem::path(path) : std::filesystem::path(path).parent_path() / target.substr(0, hash);
      std::string place = file.lexically_normal().generic_string();
      if (place.ends_with('/')) place.pop_back();
      links.push_back({place, target.substr(std::min(hash + 1, target.size())), target, number});
    }
  }
  return links;
}

/// A heading as links name it: in lower case, without punctuation, a hyphen for each space.
std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ') anchor += '-';
    if (c >= 'A' && c <= 'Z') anchor += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || (c & 0x80) != 0) anchor += c;
  }
  return anchor;
}

std::set<std::string> anchors_of(const std::string& text) {
  std::set<std::string> anchors;
  for (const std::string& line : prose(text)) {
    const std::size_t depth = line.find_first_not_of('#');
    if (depth == 0 || depth == std::string::npos || line[depth] != ' ') continue;
    const std::string anchor = anchor_of(std::string_view(line).substr(depth + 1));
    std::string again = anchor;
    for (int count = 1; !anchors.insert(again).second; ++count) again = anchor + '-' + std::to_string(count);
  }
  return anchors;
}

}  // namespace

Breaches link_breaches(const Pages& pages, const std::set<std::string>& paths) {
  std::set<std::string> places = paths;
  for (std::string path : paths) {
    for (std::size_t end = path.rfind('/'); end != std::string::npos; end = path.rfind('/')) {
      path.resize(end);
      places.insert(path);
    }
  }
  Breaches breaches;
  for (const auto& [path, text] : pages) {
    for (const Link& link : links_of(path, text)) {
      const std::string place = path + ':' + std::to_string(link.line) + ": " + link.text;
      const auto page = pages.find(link.file);
      if (!places.contains(link.file)) breaches.push_back(place + ": there is no such file or folder");
      if (page == pages.end() || link.heading.empty() || anchors_of(page->second).contains(link.heading)) continue;
      breaches.push_back(place + ": the page has no such heading");
    }
  }
  return breaches;
}

Breaches unreached_breaches(const Pages& pages, const std::string& start, const std::string& folder) {
  std::set<std::string> reached = {start};
  std::vector<std::string> open = {start};
  while (!open.empty()) {
    const auto page = pages.find(open.back());
    open.pop_back();
    if (page == pages.end()) continue;
    for (const Link& link : links_of(page->first, page->second)) {
      if (reached.insert(link.file).second) open.push_back(link.file);
    }
  }
  Breaches breaches;
  for (const auto& [path, text] : pages) {
    if (path.starts_with(folder) && !reached.contains(path)) {
      breaches.push_back(path + ": no links lead to it from " + start + "; name it in the index of its folder");
    }
  }
  return breaches;
}

}  // namespace foredraw::architecture
