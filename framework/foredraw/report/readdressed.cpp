#include <foredraw/report/readdressed.h>

#include <foredraw/report/private/json_values.h>

namespace foredraw {

std::string readdressed(std::string_view report, const std::map<std::string, std::string>& paths,
                        const std::string& pipeline) {
  Json json = Json::parse(report);
  const auto readdress = [&](Json& path) {
    const auto now = paths.find(path.get<std::string>());
    if (now != paths.end()) path = now->second;
  };
  for (const char* file : {"input", "output"}) {
    if (json.contains(file)) readdress(json[file]["path"]);
  }
  for (Json& diagnostic : json["diagnostics"]) readdress(diagnostic["file"]);
  json["pipeline"] = pipeline;
  return indented_text(json) + '\n';
}

}  // namespace foredraw
