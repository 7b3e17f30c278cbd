#include "type_rules.h"

#include <regex>
#include <sstream>

namespace foredraw::architecture {

void add_types(const std::string& path, const std::string& text, TypeFiles& types) {
  static const std::regex opens(R"(namespace\s*([\w:]*)\s*\{.*)"), closes(R"(\}  // namespace.*)");
  static const std::regex type(R"((?:struct|class)\s+(\w+)(?:\s+final)?\s*(?::(?!:)[^;]*)?\{.*)");
  std::vector<std::string> spaces;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, opens)) {
      spaces.push_back(match[1].length() > 0 ? match[1].str() : path);  // those without a name are the file's own
    } else if (std::regex_match(line, closes) && !spaces.empty()) {
      spaces.pop_back();
    } else if (std::regex_match(line, match, type)) {
      std::string name;
      for (const std::string& space : spaces) name += space + "::";
      types[name + match[1].str()].insert(path);
    }
  }
}

Breaches type_breaches(const TypeFiles& types) {
  Breaches breaches;
  for (const auto& [name, files] : types) {
    if (files.size() < 2) continue;
    std::string all;
    for (const std::string& file : files) all += (all.empty() ? "" : " and ") + file;
    breaches.push_back(name + " is defined in " + all + "; call one of them otherwise");
  }
  return breaches;
}

}  // namespace foredraw::architecture
