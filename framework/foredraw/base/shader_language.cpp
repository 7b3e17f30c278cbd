#include <foredraw/base/shader_language.h>

#include <cctype>
#include <utility>

namespace foredraw {

std::string in_hlsl(std::string_view glsl) {
  static constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"vec2", "float2"}, {"vec3", "float3"}, {"vec4", "float4"}, {"ivec2", "int2"},  {"ivec3", "int3"},
      {"ivec4", "int4"},  {"uvec2", "uint2"}, {"uvec3", "uint3"}, {"uvec4", "uint4"}, {"roundEven", "round"}};
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::string result;
  for (std::size_t at = 0; at < glsl.size();) {
    std::size_t end = at + 1;
    if (is_part(glsl[at])) {
      while (end < glsl.size() && is_part(glsl[end])) ++end;
    }
    std::string_view word = glsl.substr(at, end - at);
    for (const auto& [from, to] : words) {
      if (word == from) {
        word = to;
        break;
      }
    }
    result += word;
    at = end;
  }
  return result;
}

}  // namespace foredraw
