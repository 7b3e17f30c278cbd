#include "shape_rules.h"

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::architecture {

namespace {

constexpr std::string_view corpus = "benchmarks/corpus/";
constexpr std::uintmax_t corpus_limit = 25'000'000;

bool is_model(std::string_view path) { return path.ends_with(".glb") || path.ends_with(".gltf"); }

}  // namespace

Breaches plugin_shape_breaches(const std::set<std::string>& paths) {
  Breaches breaches;
  std::set<std::string> folders;
  for (const std::string& path : paths) {
    const std::vector<std::string> parts = parts_of(path);
    if (parts[0] == "evaluators" && parts.size() > 2) folders.insert("evaluators/" + parts[1]);
    if (parts[0] != "plugins" || parts.size() < 3) continue;
    if (parts[1] != "orderers" && parts[1] != "clusterers" && parts[1] != "processors") {
      breaches.push_back(path + ": plugins are orderers, clusterers or processors");
    } else if (parts.size() > 3) {
      folders.insert("plugins/" + parts[1] + '/' + parts[2]);
    } else {
      breaches.push_back(path + ": below plugins/" + parts[1] + "/ there are only folders, one a plugin");
    }
  }
  for (const std::string& folder : folders) {
    const std::string own = folder + '/' + parts_of(folder).back();
    for (const std::string& file : {folder + "/CMakeLists.txt", own + ".h", own + ".cpp", own + "_plugin.cpp",
                                    folder + "/README.md", "tests/" + folder + "_test.cpp"}) {
      if (!paths.contains(file)) breaches.push_back(folder + ": the file " + file + " is missing");
    }
  }
  return breaches;
}

Breaches c_function_breaches(const std::set<std::string>& paths, const std::string& page) {
  const std::size_t table = page.find("Plugins that have no function for C:");
  const std::string without = table == std::string::npos ? "" : page.substr(table, page.find("\n## ", table) - table);
  Breaches breaches;
  for (const std::string& path : paths) {
    if (!path.ends_with("_plugin.cpp") || (!path.starts_with("plugins/") && !path.starts_with("evaluators/"))) continue;
    const std::string own = path.substr(0, path.size() - std::string_view("_plugin.cpp").size());
    const std::vector<std::string> parts = parts_of(own);
    if (parts[parts.size() - 2] != parts.back()) continue;  // a part of one
    std::string name = parts.back();
    std::ranges::replace(name, '_', '-');
    const bool has_function = paths.contains(own + "_c.cpp");
    const bool has_reason = without.find('`' + name + '`') != std::string::npos;
    if (has_function == has_reason) {
      breaches.push_back(own + "_c.cpp: " + (has_function ? "is there, but" : "is missing, and") +
                         " docs/reference/c-functions.md says " + (has_reason ? "" : "not ") + "why there is none");
    }
  }
  return breaches;
}

Breaches corpus_breaches(const std::vector<SourceFile>& files, const std::string& credits) {
  Breaches breaches;
  std::uintmax_t size = 0;
  for (const SourceFile& file : files) {
    if (!file.path.starts_with(corpus)) continue;
    size += file.size;
    const bool is_ascii = std::all_of(file.path.begin(), file.path.end(), [](char c) { return c > 32 && c < 127; });
    if (!is_ascii) breaches.push_back(file.path + ": its name is not plain ASCII without spaces");
    if (file.is_link) breaches.push_back(file.path + ": is a link; the corpus holds the files themselves");
    if (is_model(file.path) && credits.find('`' + parts_of(file.path).back() + '`') == std::string::npos) {
      breaches.push_back(file.path + ": is not named in CREDITS.md");
    }
  }
  if (size > corpus_limit) {
    breaches.push_back(fmt::format("{}: holds {} bytes, of at most {}", corpus, size, corpus_limit));
  }
  return breaches;
}

}  // namespace foredraw::architecture
