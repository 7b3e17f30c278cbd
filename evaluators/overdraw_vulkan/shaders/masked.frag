#version 450
// owner.frag or heavy.frag, of a surface with holes: alpha_at() of analysis/mask.cpp in floats. Without early tests, for a
// fragment that is discarded must not write its depth.

layout(constant_id = 0) const bool is_heavy = false;

layout(push_constant) uniform Draw {
  mat4 clip_from_position;
  uint owner;
  uint first_texel;
  uint width;  // 0: alpha is 1 everywhere
  uint height;
  uint wrap_u;  // as Wrap numbers them
  uint wrap_v;
  uint is_nearest;
  float cutoff;
};

layout(set = 0, binding = 0) readonly buffer Texels { uint alpha[]; };

layout(location = 0) in vec3 at;

layout(location = 0) out uint written;

int remainder(int number, int divisor) {
  int rest = number - divisor * (number / divisor);
  return rest < 0 ? rest + divisor : rest;
}

uint wrapped(int texel, int count, uint wrap) {
  if (wrap == 2) return uint(clamp(texel, 0, count - 1));
  if (wrap == 0) return uint(remainder(texel, count));
  int there_and_back = remainder(texel, 2 * count);
  return uint(min(there_and_back, 2 * count - 1 - there_and_back));
}

float texel(ivec2 at_texel) {
  uint i = first_texel + wrapped(at_texel.y, int(height), wrap_v) * width + wrapped(at_texel.x, int(width), wrap_u);
  return float(alpha[i]) / 65535;
}

float alpha_at(vec2 place) {
  if (width == 0) return 1;
  vec2 texels = place * vec2(width, height);
  if (is_nearest != 0) return texel(ivec2(floor(texels)));
  texels -= 0.5;
  ivec2 first = ivec2(floor(texels));
  vec2 part = texels - floor(texels);
  float upper = mix(texel(first), texel(first + ivec2(1, 0)), part.x);
  float lower = mix(texel(first + ivec2(0, 1)), texel(first + ivec2(1, 1)), part.x);
  return mix(upper, lower, part.y);
}

void main() {
  if (at.z * alpha_at(at.xy) < cutoff) discard;
  written = owner;
  if (!is_heavy) return;
  float x = gl_FragCoord.x + 0.37 * gl_FragCoord.y;
  for (int i = 0; i < 256; ++i) x = sin(x) * 1.7 + 0.3;
  written = floatBitsToUint(x);
}
