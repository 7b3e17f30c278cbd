#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/private/line_scanner.h>

namespace foredraw {

std::optional<std::vector<Stage>> parse_stages(std::string_view text, const std::string& name,
                                               Diagnostics& diagnostics) {
  return scan_stages(text, {Where{name, 1, 1, {}}}, diagnostics);
}

std::optional<Pipeline> parse_line(std::string_view text, Diagnostics& diagnostics) {
  auto stages = parse_stages(text, "pipeline", diagnostics);
  if (!stages) return std::nullopt;
  Pipeline pipeline;
  pipeline.stages = std::move(*stages);
  return pipeline;
}

}  // namespace foredraw
