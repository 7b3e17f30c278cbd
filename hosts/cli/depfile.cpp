#include "depfile.h"

#include <algorithm>
#include <set>

namespace foredraw::cli {

namespace {

/// As gcc -MD writes names: backslashes count double before a blank alone.
std::string escaped(const std::filesystem::path& path) {
  std::string text;
  std::size_t backslashes = 0;
  for (const char c : path.generic_string()) {
    if (c == ' ' || c == '\t') {
      text.append(backslashes, '\\');
      text += '\\';
    } else if (c == '#' || c == ':') {
      text += '\\';
    } else if (c == '$') {
      text += '$';
    }
    backslashes = c == '\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text;
}

bool is_writable(const std::filesystem::path& path) { return path.native().find_first_of("\r\n") == std::string::npos; }

}  // namespace

std::string rule_text(const DependencyRule& rule) {
  if (!std::ranges::all_of(rule.outputs, is_writable)) return {};
  std::string text;
  for (const auto& output : rule.outputs) text += (text.empty() ? "" : " ") + escaped(output);
  text += ':';
  std::string without_rule;
  std::set<std::string> named;
  for (std::size_t i = 0; i < rule.inputs.size(); ++i) {
    if (!is_writable(rule.inputs[i])) continue;
    const std::string name = escaped(rule.inputs[i].lexically_normal());
    if (!named.insert(name).second) continue;
    text += " \\\n " + name;
    if (i > 0) without_rule += name + ":\n";
  }
  return text + '\n' + without_rule;
}

}  // namespace foredraw::cli
