#include <foredraw/wires/private/wire_functions.h>
#include <foredraw/wires/wire_shader.h>

#include <string_view>

namespace foredraw {

namespace {

/// How many samples a pixel has, of which wire_covering() needs to know no more than whether it is one.
constexpr std::string_view samples = R"(#ifndef WIRE_SAMPLES
#define WIRE_SAMPLES 1
#endif

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
layout(location = 2) in vec4 axis;
layout(location = 0) out vec3 wire_radii;  // as it is seen, as it is drawn, and half a pixel
#ifdef WIRE_COVERAGE
layout(location = 1) out vec3 wire_centre;
layout(location = 2) out vec3 wire_axis;
#endif

void main() {
  WireView view = wire_view(wire_frame.clip_from_mesh, wire_frame.viewport);
#ifdef WIRE_COVERAGE
  WireVertex at = wire_vertex(view, position, wire, axis, WIRE_SAMPLES);
  wire_centre = position + wire.xyz;
  wire_axis = axis.xyz;
#else
  WireVertex at = wire_vertex(view, position, wire, axis, 0);
#endif
  wire_radii = vec3(at.radius, at.drawn, at.half_pixel);
  gl_Position = wire_frame.clip_from_mesh * vec4(at.position, 1.0);
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
#ifdef WIRE_OPAQUE
  if (alpha < 1.0) discard;
#endif
#ifdef WIRE_FADED
  if (!(alpha < 1.0)) discard;
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
  [[vk::location(0)]] float3 radii : WIRE_RADII;  // as it is seen, as it is drawn, and half a pixel
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
             [[vk::location(2)]] float4 axis : FOREDRAW_WIRE_AXIS) {
  WireView view = wire_view(wire_frame.clip_from_mesh, wire_frame.viewport);
  WireOut result;
#ifdef WIRE_COVERAGE
  WireVertex at = wire_vertex(view, position, wire, axis, WIRE_SAMPLES);
  result.corner.centre = position + wire.xyz;
  result.corner.axis = axis.xyz;
#else
  WireVertex at = wire_vertex(view, position, wire, axis, 0);
#endif
  result.corner.radii = float3(at.radius, at.drawn, at.half_pixel);
  result.position = mul(wire_frame.clip_from_mesh, float4(at.position, 1.0));
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
#ifdef WIRE_OPAQUE
  if (alpha < 1.0) discard;
#endif
#ifdef WIRE_FADED
  if (!(alpha < 1.0)) discard;
#endif
  float lit = wire_lit(corner.radii.x, corner.radii.z);
  return float4(lit, lit, lit, alpha);
}
#endif
)";

}  // namespace

std::string wire_functions_text() { return std::string(wire_shader_parts::functions).append(view_glsl); }

std::string wire_shader_text(ShaderLanguage language) {
  if (language == ShaderLanguage::glsl) {
    return std::string(wire_shader_parts::functions).append(samples).append(view_glsl).append(stages_glsl);
  }
  return in_hlsl(wire_shader_parts::functions).append(samples).append(view_hlsl).append(stages_hlsl);
}

}  // namespace foredraw
