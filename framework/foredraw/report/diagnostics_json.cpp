#include <foredraw/report/diagnostics_json.h>
#include <foredraw/report/private/json_values.h>

namespace foredraw {

std::string to_json(const Diagnostics& diagnostics) {
  Json all = Json::array();
  for (const Diagnostic& diagnostic : diagnostics.all()) all.push_back(json_of(diagnostic));
  return Json{{"diagnostics", std::move(all)}}.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foredraw
