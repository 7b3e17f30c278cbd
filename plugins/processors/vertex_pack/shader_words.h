#pragma once
// Text of shaders with words that are put in.

#include "packed_shader.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace foredraw::processors::vertex_pack {

/// Words that begin with a dollar are those of the language, or a layout's.
using Word = std::pair<std::string_view, std::string>;

inline std::string with_words(std::string_view text, const std::vector<Word>& words) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto is_here = [&](const Word& word) { return text.substr(at).starts_with(word.first); };
    const auto word = std::ranges::find_if(words, is_here);
    result += word == words.end() ? std::string(1, text[at]) : word->second;
    at += word == words.end() ? 1 : word->first.size();
  }
  return result;
}

inline std::vector<Word> words_of(ShaderLanguage language) {
  if (language == ShaderLanguage::glsl) {
    return {{"$f2", "vec2"},
            {"$f3", "vec3"},
            {"$f4", "vec4"},
            {"$u2", "uvec2"},
            {"$u4", "uvec4"},
            {"$float", "uintBitsToFloat"},
            {"$uint", "floatBitsToUint"},
            {"$round", "roundEven"}};
  }
  return {{"$f2", "float2"}, {"$f3", "float3"},     {"$f4", "float4"},   {"$u2", "uint2"},
          {"$u4", "uint4"},  {"$float", "asfloat"}, {"$uint", "asuint"}, {"$round", "round"}};
}

}  // namespace foredraw::processors::vertex_pack
