#include <foredraw/c/library/private/pipeline_text.h>

namespace foredraw::c {

std::optional<std::vector<NamedPipeline>> pipelines_in(const std::string& text, Diagnostics& diagnostics) {
  const bool is_file = text.find('\n') != std::string::npos || text.starts_with("pipeline");
  if (text.starts_with('@')) return load_branches(text, diagnostics);
  if (is_file) return parse_branches(text, "pipeline", diagnostics);
  auto line = parse_line(text, diagnostics);
  if (!line) return std::nullopt;
  return std::vector<NamedPipeline>{{text, std::move(*line)}};
}

}  // namespace foredraw::c
