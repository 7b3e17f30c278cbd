#include <foredraw/scene/stream_meaning.h>

namespace foredraw {

bool is_amount(const VertexStream& stream) {
  if (stream.semantic.starts_with("JOINTS_")) return false;
  if (stream.format.component == Component::float32 || stream.format.normalized) return true;
  for (const std::string_view word : {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_", "COLOR_"}) {
    if (stream.semantic.starts_with(word)) return true;
  }
  return false;
}

bool is_direction(const VertexStream& stream) {
  return (stream.semantic == "NORMAL" || stream.semantic == "TANGENT") && stream.format.components >= 3;
}

}  // namespace foredraw
