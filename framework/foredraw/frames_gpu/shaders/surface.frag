#version 450
// frames/surface_shading.cpp: the colour of a point on a surface. What the reference takes from a triangle's corners, the
// mip levels and where u and v grow, is taken from how they change from one pixel to the next.

layout(constant_id = 0) const uint rendering = 0;  // as Rendering numbers them
layout(constant_id = 1) const bool has_base = false;
layout(constant_id = 2) const bool has_normal_map = false;
layout(constant_id = 3) const bool has_normals = false;
layout(constant_id = 4) const bool is_masked = false;

layout(push_constant) uniform Draw {
  vec4 colour;
  float normal_scale;
  float cutoff;
  float near;
};

layout(std430, set = 0, binding = 1) readonly buffer Light {
  vec3 to_sun;
  float highlight;
  vec3 sun;
  float unlit;
  vec3 from_sky;
  vec3 from_ground;
};
layout(set = 1, binding = 0) uniform sampler2D base_image;
layout(set = 1, binding = 1) uniform sampler2D normal_map;

layout(location = 0) in vec3 from_eye;
layout(location = 1) in vec3 moved_normal;
layout(location = 2) in vec2 base_at;
layout(location = 3) in vec2 normal_map_at;

layout(location = 0) out vec4 shown;

// A vector of length 0 stays as it is.
vec3 unit(vec3 v) {
  float squared = dot(v, v);
  return squared > 0 ? v * inversesqrt(squared) : v;
}

// mip_level(): each level has a quarter of the texels, and two are the most that a pixel covers.
float mip_level(vec2 right, vec2 down, ivec2 size) {
  float texels = abs(right.x * down.y - right.y * down.x) * float(size.x) * float(size.y);
  return texels > 2 ? ceil(0.5 * log2(texels) - 0.5) : 0;
}

vec3 bent(vec3 normal, vec3 right, vec3 down, vec2 place_right, vec2 place_down, float mip) {
  vec3 texel = textureLod(normal_map, normal_map_at, mip).xyz * 2 - 1;
  float turn = place_right.x * place_down.y - place_right.y * place_down.x < 0 ? -1 : 1;
  vec3 along_u = (right * place_down.y - down * place_right.y) * turn;
  vec3 along_v = (right * place_down.x - down * place_right.x) * turn;
  vec3 u = unit(along_u - normal * dot(normal, along_u));
  vec3 v = unit(along_v - normal * dot(normal, along_v));
  return unit(u * (texel.x * normal_scale) + v * (texel.y * normal_scale) + normal * texel.z);
}

vec3 lit(vec3 base, vec3 normal) {
  float upwards = 0.5 + 0.5 * normal.y;
  vec3 ambient = from_ground * (1 - upwards) + from_sky * upwards;
  float towards = max(0, dot(normal, to_sun));
  float gleam = 0;
  if (towards > 0) {
    gleam = max(0, dot(normal, unit(to_sun + unit(-from_eye))));
    for (int i = 0; i < 5; ++i) gleam *= gleam;
  }
  return base * (ambient + sun * towards) + sun * (highlight * gleam);
}

void main() {
  // Neighbours are asked before any of them is discarded.
  vec3 right = dFdx(from_eye), down = dFdy(from_eye);
  vec2 map_right = dFdx(normal_map_at), map_down = dFdy(normal_map_at);
  vec4 base = colour;
  if (has_base) {
    vec4 texel = textureLod(base_image, base_at, mip_level(dFdx(base_at), dFdy(base_at), textureSize(base_image, 0)));
    base *= vec4(texel.xyz * texel.xyz, texel.w);
  }
  if (is_masked && base.w < cutoff) discard;
  if (rendering == 2) {
    shown = vec4(base.xyz * unlit, base.w);
    return;
  }
  vec3 normal = unit(has_normals ? (gl_FrontFacing ? moved_normal : -moved_normal) : cross(right, down));
  if (!has_normals && dot(normal, from_eye) > 0) normal = -normal;  // the side that is seen
  if (rendering == 0 && has_normal_map) {
    float mip = mip_level(map_right, map_down, textureSize(normal_map, 0));
    normal = bent(normal, right, down, map_right, map_down, mip);
  }
  shown = vec4(lit(base.xyz, normal), base.w);
}
