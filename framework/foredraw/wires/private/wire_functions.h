#pragma once
// What shaders of wires compute, as text.

#include <string_view>

namespace foredraw::wire_shader_parts {

/// wire_radius.h in the words that GLSL and HLSL share, spelled as in GLSL. No function returns early: glslang's front
/// end for HLSL makes a switch without cases of that, of which Mesa's software driver (22.3) draws nothing.
inline constexpr std::string_view functions = R"(struct WireView {
  vec4 x, y, w;
};

struct WireSection {
  vec2 place, across;
  vec3 aside;
  float pixels;
};

struct WireVertex {
  vec3 position;
  float radius, drawn, half_pixel;
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
  at.aside = vec3(0.0, 0.0, 0.0);
  at.pixels = 0.0;
  float w = wire_row(view.w, centre);
  if (w > 0.0) {
    at.place = vec2(wire_row(view.x, centre) / w, wire_row(view.y, centre) / w);
    precise vec3 x = view.x.xyz - at.place.x * view.w.xyz;
    precise vec3 y = view.y.xyz - at.place.y * view.w.xyz;
    float along_x = wire_along(x, axis), along_y = wire_along(y, axis);
    precise float squares = along_x * along_x + along_y * along_y;
    float size = sqrt(squares);
    if (size > 0.0) at.across = vec2(-along_y / size, along_x / size);
    precise vec3 gradient = at.across.x * x + at.across.y * y;
    float steepness = sqrt(wire_along(gradient, gradient));
    if (steepness > 0.0) at.aside = gradient / steepness;
    at.pixels = steepness / w;
  }
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

float wire_breadth(vec3 to_centre, vec3 axis) {
  float along = wire_along(to_centre, axis);
  precise vec3 square = to_centre - along * axis;
  return sqrt(wire_along(square, square));
}

float wire_seen(WireSection at, vec3 to_centre, vec3 axis, float half_width) {
  float breadth = wire_breadth(to_centre, axis), shown = abs(wire_along(to_centre, at.aside));
  return breadth > shown ? half_width * (shown / breadth) : half_width;
}

float wire_covering(float half_width, float mean, WireSection at, int samples) {
  float to_corner = 0.5 * (abs(at.across.x) + abs(at.across.y));
  precise float wide = mean + ((samples > 1 ? 2.0 : 1.0) * to_corner + 0.015625) / at.pixels;
  return half_width > 0.0 && at.pixels > 0.0 ? wide : abs(half_width);
}

vec3 wire_moved(vec3 position, vec3 to_centre, float half_width, float drawn, WireSection at) {
  float wider = half_width > 0.0 ? drawn / half_width - 1.0 : 0.0;
  float outwards = -wider * wire_along(to_centre, at.aside);
  precise vec3 moved = position + outwards * at.aside;
  return wider > 0.0 ? moved : position;
}

vec3 wire_pushed(vec3 position, vec3 to_centre, vec3 axis, float half_width, float by, WireSection at) {
  float part = half_width > 0.0 ? wire_breadth(to_centre, axis) / half_width : 0.0;
  float outwards = wire_along(to_centre, at.aside) > 0.0 ? -part * by : part * by;
  precise vec3 pushed = position + outwards * at.aside;
  return by > 0.0 && part > 0.0 ? pushed : position;
}

WireVertex wire_vertex(WireView view, vec3 position, vec4 wire, vec4 axis, int covers) {
  precise vec3 centre = position + wire.xyz;
  WireSection at = wire_section(view, centre, axis.xyz);
  bool is_flat = axis.w > 0.5;
  WireVertex result;
  result.half_pixel = wire_half_pixel(at);
  float seen = abs(is_flat ? wire_seen(at, wire.xyz, axis.xyz, wire.w) : wire.w);
  result.radius = covers > 0 && !is_flat ? wire_mean(wire.xyz, wire.w) : seen;
  result.drawn = covers > 0 ? wire_covering(wire.w, result.radius, at, covers)
                            : wire_drawn(wire.w > 0.0 ? result.radius : -result.radius, result.half_pixel);
  result.position = is_flat ? wire_pushed(position, wire.xyz, axis.xyz, wire.w, result.drawn - result.radius, at)
                            : wire_moved(position, wire.xyz, wire.w, result.drawn, at);
  return result;
}

float wire_fade(float radius, float drawn) { return drawn > radius && drawn > 0.0 ? radius / drawn : 1.0; }

float wire_lit(float radius, float half_pixel) {
  return half_pixel > 0.0 ? clamp(2.0 * radius / half_pixel - 1.0, 0.0, 1.0) : 1.0;
}

vec3 wire_normal(vec3 axis, vec3 to_eye, float part) {
  float squares = wire_along(axis, axis), rest = part * part < 1.0 ? sqrt(1.0 - part * part) : 0.0;
  vec3 middle = to_eye - axis * (squares > 0.0 ? wire_along(to_eye, axis) / squares : 0.0);
  if (!(wire_along(middle, middle) > 0.0)) middle = to_eye;
  vec3 side = cross(axis, middle);
  float size = sqrt(wire_along(middle, middle)), across = sqrt(wire_along(side, side));
  return middle * (size > 0.0 ? rest / size : 0.0) + side * (across > 0.0 ? part / across : 0.0);
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
  float covered = wire_side(wide + from_line, at.across) + wire_side(wide - from_line, at.across) - 1.0;
  return wide > 0.0 ? covered : 1.0;
}

)";

}  // namespace foredraw::wire_shader_parts
