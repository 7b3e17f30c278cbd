#include <foredraw/cache/result_about.h>

#include <nlohmann/json.hpp>

namespace foredraw {

using Json = nlohmann::ordered_json;

std::string to_text(const ResultAbout& about) {
  Json files = Json::array();
  for (const ResultAbout::File& file : about.files) files.push_back({file.output, file.name});
  const Json json{{"input", about.input}, {"outputs", about.outputs}, {"pipeline", about.pipeline}, {"files", files}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ResultAbout> result_about(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    ResultAbout about{json.at("input").get<std::string>(),
                      json.at("outputs").get<std::vector<std::string>>(),
                      json.at("pipeline").get<std::string>(),
                      {}};
    for (const Json& file : json.at("files")) {
      about.files.push_back({file.at(0).get<std::size_t>(), file.at(1).get<std::string>()});
    }
    return about;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace foredraw
