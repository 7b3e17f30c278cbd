#include "family_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

namespace foredraw::architecture {

namespace {

constexpr std::array<std::string_view, 4> product_folders = {"framework/", "plugins/", "evaluators/", "hosts/"};
constexpr std::array<std::string_view, 5> endings = {".h", ".cpp", ".c", ".js", ".py"};

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace

std::vector<Family> families_in(const std::string& table) {
  std::vector<Family> families;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| family ")) continue;
    std::istringstream row(line.substr(2));
    std::array<std::string, 4> columns;
    for (std::string& column : columns) std::getline(row, column, '|');
    columns[0].erase(columns[0].find_last_not_of(' ') + 1);
    families.push_back({columns[0], words_in(columns[1]), words_in(columns[2]), std::stoul(columns[3])});
  }
  return families;
}

bool names_from_elsewhere(const Family& family, const std::string& path, const std::string& text) {
  const auto begins = [&](std::string_view folder) { return path.starts_with(folder); };
  const auto ends = [&](std::string_view ending) { return path.ends_with(ending); };
  if (std::ranges::none_of(product_folders, begins) || std::ranges::none_of(endings, ends)) return false;
  if (begins("framework/foredraw/runtime/") || std::ranges::any_of(family.homes, begins)) return false;
  const std::string in_lower_case = lower(text);
  return std::ranges::any_of(family.words,
                             [&](const std::string& word) { return in_lower_case.find(word) != std::string::npos; });
}

Breaches family_breaches(const Family& family, const std::vector<std::string>& files) {
  if (files.size() == family.files_elsewhere) return {};
  const bool is_fewer = files.size() < family.files_elsewhere;
  std::string breach =
      fmt::format("tests/architecture/families.md: {} files elsewhere name {}, the table says {}; {}", files.size(),
                  family.name, family.files_elsewhere, is_fewer ? "lower it" : "name it at home");
  if (!is_fewer) breach += fmt::format("\n  {}", fmt::join(files, "\n  "));
  return {breach};
}

}  // namespace foredraw::architecture
