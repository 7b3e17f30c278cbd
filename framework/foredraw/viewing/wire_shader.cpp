#include <foredraw/viewing/wire_shader.h>

#include <string_view>

namespace foredraw {

namespace {

/// wire_radius.h in the words that GLSL and HLSL share, spelled as in GLSL.
constexpr std::string_view functions = R"(struct WireView {
  vec4 x, y, w;
};

struct WireSection {
  vec2 place, across;
  float pixels;
};

float wire_row(vec4 row, vec3 v) {
  precise float sum = ((row.x * v.x + row.y * v.y) + row.z * v.z) + row.w;
  return sum;
}

float wire_along(vec3 a, vec3 b) {
  precise float sum = (a.x * b.x + a.y * b.y) + a.z * b.z;
  return sum;
}

WireSection wire_section(WireView view, vec3 centre, vec3 axis) {
  WireSection at;
  at.place = vec2(0.0, 0.0);
  at.across = vec2(0.0, 1.0);
  at.pixels = 0.0;
  float w = wire_row(view.w, centre);
  if (!(w > 0.0)) return at;
  at.place = vec2(wire_row(view.x, centre) / w, wire_row(view.y, centre) / w);
  precise vec3 x = view.x.xyz - at.place.x * view.w.xyz;
  precise vec3 y = view.y.xyz - at.place.y * view.w.xyz;
  float along_x = wire_along(x, axis), along_y = wire_along(y, axis);
  precise float squares = along_x * along_x + along_y * along_y;
  float size = sqrt(squares);
  if (size > 0.0) at.across = vec2(-along_y / size, along_x / size);
  precise vec3 gradient = at.across.x * x + at.across.y * y;
  at.pixels = sqrt(wire_along(gradient, gradient)) / w;
  return at;
}

float wire_half_pixel(WireSection at) { return at.pixels > 0.0 ? 0.5 / at.pixels : 0.0; }

float wire_drawn(float half_width, float half_pixel) {
  return half_width > 0.0 && half_pixel > half_width ? half_pixel : abs(half_width);
}

float wire_mean(vec3 to_centre, float half_width) {
  precise float squares = (to_centre.x * to_centre.x + to_centre.y * to_centre.y) + to_centre.z * to_centre.z;
  float r = abs(half_width), corner = sqrt(squares);
  return corner > r ? (2.0 * corner + r) / 3.0 : r;
}

float wire_covering(float half_width, float mean, WireSection at) {
  float to_corner = 0.5 * (abs(at.across.x) + abs(at.across.y));
  if (!(half_width > 0.0) || !(at.pixels > 0.0)) return abs(half_width);
  precise float wide = mean + (to_corner + 0.015625) / at.pixels;
  return wide;
}

vec3 wire_moved(vec3 position, vec3 to_centre, float half_width, float drawn) {
  float outwards = half_width > 0.0 ? drawn / half_width - 1.0 : 0.0;
  precise vec3 moved = position - to_centre * outwards;
  return outwards > 0.0 ? moved : position;
}

float wire_fade(float radius, float drawn) { return drawn > radius && drawn > 0.0 ? radius / drawn : 1.0; }

float wire_lit(float radius, float half_pixel) {
  return half_pixel > 0.0 ? clamp(radius / half_pixel - 1.0, 0.0, 1.0) : 1.0;
}

float wire_side(float from_middle, vec2 across) {
  float a = abs(across.x), b = abs(across.y), most = max(a, b), least = min(a, b);
  float to_corner = 0.5 * (a + b), to_flat = 0.5 * (most - least), size = abs(from_middle), outside;
  if (size >= to_corner) {
    outside = 0.0;
  } else if (size <= to_flat) {
    outside = 0.5 - size / most;
  } else {
    outside = (to_corner - size) * (to_corner - size) / (2.0 * most * least);
  }
  return from_middle > 0.0 ? 1.0 - outside : outside;
}

float wire_coverage(WireSection at, float radius, vec2 pixel) {
  float from_line = (pixel.x - at.place.x) * at.across.x + (pixel.y - at.place.y) * at.across.y;
  float wide = radius * at.pixels;
  if (!(wide > 0.0)) return 1.0;
  return wire_side(wide + from_line, at.across) + wire_side(wide - from_line, at.across) - 1.0;
}

)";

constexpr std::string_view view_glsl = R"(WireView wire_view(mat4 clip_from_mesh, vec2 viewport) {
  vec4 x = vec4(clip_from_mesh[0].x, clip_from_mesh[1].x, clip_from_mesh[2].x, clip_from_mesh[3].x);
  vec4 y = vec4(clip_from_mesh[0].y, clip_from_mesh[1].y, clip_from_mesh[2].y, clip_from_mesh[3].y);
  vec4 w = vec4(clip_from_mesh[0].w, clip_from_mesh[1].w, clip_from_mesh[2].w, clip_from_mesh[3].w);
  precise vec4 row_x = 0.5 * viewport.x * (x + w);
  precise vec4 row_y = 0.5 * viewport.y * (y + w);
  WireView view;
  view.x = row_x;
  view.y = row_y;
  view.w = w;
  return view;
}

)";

constexpr std::string_view view_hlsl = R"(WireView wire_view(float4x4 clip_from_mesh, float2 viewport) {
#ifdef WIRE_VULKAN
  float4 y = clip_from_mesh[1];
#else
  float4 y = -clip_from_mesh[1];
#endif
  precise float4 row_x = 0.5 * viewport.x * (clip_from_mesh[0] + clip_from_mesh[3]);
  precise float4 row_y = 0.5 * viewport.y * (y + clip_from_mesh[3]);
  WireView view;
  view.x = row_x;
  view.y = row_y;
  view.w = clip_from_mesh[3];
  return view;
}

)";

constexpr std::string_view stages_glsl = R"(#if defined(WIRE_VERTEX) || defined(WIRE_FRAGMENT)
layout(push_constant) uniform WireFrame {
  mat4 clip_from_mesh;
  vec2 viewport;
} wire_frame;
#endif

#ifdef WIRE_VERTEX
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 wire;
layout(location = 2) in vec3 axis;
layout(location = 0) out vec3 wire_radii;  // as it is, as it is drawn, and half a pixel
#ifdef WIRE_COVERAGE
layout(location = 1) out vec3 wire_centre;
layout(location = 2) out vec3 wire_axis;
#endif

void main() {
  WireView view = wire_view(wire_frame.clip_from_mesh, wire_frame.viewport);
  vec3 centre = position + wire.xyz;
  WireSection at = wire_section(view, centre, axis);
  float half_pixel = wire_half_pixel(at);
#ifdef WIRE_COVERAGE
  float radius = wire_mean(wire.xyz, wire.w), drawn = wire_covering(wire.w, radius, at);
  wire_centre = centre;
  wire_axis = axis;
#else
  float radius = abs(wire.w), drawn = wire_drawn(wire.w, half_pixel);
#endif
  wire_radii = vec3(radius, drawn, half_pixel);
  gl_Position = wire_frame.clip_from_mesh * vec4(wire_moved(position, wire.xyz, wire.w, drawn), 1.0);
}
#endif

#ifdef WIRE_FRAGMENT
layout(location = 0) in vec3 wire_radii;
#ifdef WIRE_COVERAGE
layout(location = 1) in vec3 wire_centre;
layout(location = 2) in vec3 wire_axis;
#endif
layout(location = 0) out vec4 colour;

void main() {
#ifdef WIRE_COVERAGE
  WireView view = wire_view(wire_frame.clip_from_mesh, wire_frame.viewport);
  float alpha = wire_coverage(wire_section(view, wire_centre, wire_axis), wire_radii.x, gl_FragCoord.xy);
#else
  float alpha = wire_fade(wire_radii.x, wire_radii.y);
#endif
  float lit = wire_lit(wire_radii.x, wire_radii.z);
  colour = vec4(lit, lit, lit, alpha);
}
#endif
)";

constexpr std::string_view stages_hlsl = R"(#if defined(WIRE_VERTEX) || defined(WIRE_FRAGMENT)
struct WireFrame {
  column_major float4x4 clip_from_mesh;
  float2 viewport;
};
#ifdef WIRE_VULKAN
[[vk::push_constant]] ConstantBuffer<WireFrame> wire_frame;
#else
ConstantBuffer<WireFrame> wire_frame : register(b0);
#endif

struct WireCorner {
  [[vk::location(0)]] float3 radii : WIRE_RADII;  // as it is, as it is drawn, and half a pixel
#ifdef WIRE_COVERAGE
  [[vk::location(1)]] float3 centre : WIRE_CENTRE;
  [[vk::location(2)]] float3 axis : WIRE_AXIS;
#endif
};
#endif

#ifdef WIRE_VERTEX
struct WireOut {
  WireCorner corner;
  float4 position : SV_Position;
};

WireOut main([[vk::location(0)]] float3 position : POSITION, [[vk::location(1)]] float4 wire : FOREDRAW_WIRE,
             [[vk::location(2)]] float3 axis : FOREDRAW_WIRE_AXIS) {
  WireView view = wire_view(wire_frame.clip_from_mesh, wire_frame.viewport);
  WireOut result;
  float3 centre = position + wire.xyz;
  WireSection at = wire_section(view, centre, axis);
  float half_pixel = wire_half_pixel(at);
#ifdef WIRE_COVERAGE
  float radius = wire_mean(wire.xyz, wire.w), drawn = wire_covering(wire.w, radius, at);
  result.corner.centre = centre;
  result.corner.axis = axis;
#else
  float radius = abs(wire.w), drawn = wire_drawn(wire.w, half_pixel);
#endif
  result.corner.radii = float3(radius, drawn, half_pixel);
  result.position = mul(wire_frame.clip_from_mesh, float4(wire_moved(position, wire.xyz, wire.w, drawn), 1.0));
  return result;
}
#endif

#ifdef WIRE_FRAGMENT
float4 main(WireCorner corner, float4 pixel : SV_Position) : SV_Target {
#ifdef WIRE_COVERAGE
  WireView view = wire_view(wire_frame.clip_from_mesh, wire_frame.viewport);
  float alpha = wire_coverage(wire_section(view, corner.centre, corner.axis), corner.radii.x, pixel.xy);
#else
  float alpha = wire_fade(corner.radii.x, corner.radii.y);
#endif
  float lit = wire_lit(corner.radii.x, corner.radii.z);
  return float4(lit, lit, lit, alpha);
}
#endif
)";

}  // namespace

std::string wire_shader_text(ShaderLanguage language) {
  if (language == ShaderLanguage::glsl) {
    return std::string(functions).append(view_glsl).append(stages_glsl);
  }
  return in_hlsl(functions).append(view_hlsl).append(stages_hlsl);
}

}  // namespace foredraw
