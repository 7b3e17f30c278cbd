#include "name_rules.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace foredraw::architecture {

namespace {

/// linear_clusters: LinearClusters
std::string in_pascal_case(const std::string& folder) {
  std::string name;
  bool is_first = true;
  for (const char c : folder) {
    if (c != '_') name += is_first ? static_cast<char>(c - 'a' + 'A') : c;
    is_first = c == '_';
  }
  return name;
}

/// DrawOrderer: Orderer
std::string last_word(const std::string& name) {
  const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto last = std::find_if(name.rbegin(), name.rend(), is_upper);
  return last == name.rend() ? name : std::string(last.base() - 1, name.end());
}

}  // namespace

Breaches name_breaches(const std::string& path) {
  static const std::regex says_nothing(R"((^|[^a-z])(utils?|utilities|commons?|managers?|helpers?|misc)([^a-z]|$))");
  static const std::regex lower_case(R"([a-z0-9_]+\.(h|cpp|inl))");
  Breaches breaches;
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (std::regex_search(lower, says_nothing)) {
    breaches.push_back(path + ": a name that says nothing; name the idea that it holds");
  }
  if (is_cpp(path) && !std::regex_match(parts_of(path).back(), lower_case)) {
    breaches.push_back(path + ": C++ files are called in lower case with underscores");
  }
  return breaches;
}

Breaches plugin_name_breaches(const std::string& path, const std::string& text) {
  const std::vector<std::string> place = parts_of(path);
  const bool is_plugin = place[0] == "plugins" && place.size() > 3;
  if (!is_cpp(path) || (!is_plugin && (place[0] != "evaluators" || place.size() < 3))) return {};
  const std::string& kinds = place[is_plugin ? 1 : 0];
  const std::string& folder = place[is_plugin ? 2 : 1];

  static const std::regex opens(R"(namespace ([\w:]+?)(::HWY_NAMESPACE)? \{)");
  static const std::regex derives(R"(class (\w+) final : public (\w+) \{)");
  const std::string own = kinds + "::" + folder;
  const std::set<std::string> namespaces = {"foredraw", own, "foredraw::" + own};
  Breaches breaches;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string at = path + ':' + std::to_string(number) + ": ";
    std::smatch match;
    if (std::regex_match(line, match, opens) && !namespaces.contains(match[1])) {
      breaches.push_back(at + "the namespace is " + match[1].str() + ", not foredraw::" + own);
    }
    if (place.back() == folder + "_plugin.cpp" && std::regex_match(line, match, derives)) {
      const std::string name = in_pascal_case(folder) + last_word(match[2]);
      if (match[1] != name) breaches.push_back(at + "the class is " + match[1].str() + ", not " + name);
    }
  }
  return breaches;
}

Breaches test_namespace_breaches(const std::string& path, const std::string& text,
                                 std::map<std::string, std::string>& files) {
  if (!path.starts_with("tests/") || !path.ends_with("_test.cpp")) return {};
  const std::vector<std::string> parts = parts_of(path);
  const std::string name = parts.back().substr(0, parts.back().size() - 4);
  const std::regex own("(^|\n)namespace (\\w+::)*((" + parts[parts.size() - 2] + "_)?" + name + ") \\{");
  std::smatch found;
  if (!std::regex_search(text, found, own)) {
    return {path + ": its tests are to lie in namespace foredraw::" + name +
            ", so that it can be compiled as one with other tests"};
  }
  const auto [other, is_first] = files.emplace(found[3], path);
  if (is_first) return {};
  return {path + ": its namespace " + other->first + " is that of " + other->second +
          ", too; put the folder before it"};
}

Breaches length_breaches(const std::string& path, const std::string& text, std::size_t limit) {
  if (!is_cpp(path) && !path.ends_with(".mjs") && !path.ends_with(".js")) return {};
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  if (lines <= limit) return {};
  return {path + ": has " + std::to_string(lines) + " lines, more than " + std::to_string(limit) + "; one idea a file"};
}

}  // namespace foredraw::architecture
