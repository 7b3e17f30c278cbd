#pragma once
// Resources and stages in GLSL. What stands between @ is filled in.

#include <string_view>

namespace foredraw::displaced_shader_parts::glsl {

inline constexpr std::string_view normalized_map =
    R"(layout(set = @map_set@, binding = @map_binding@) uniform sampler2D displaced_map;

uint displaced_texel(uint column, uint row) {
  return uint(roundEven(texelFetch(displaced_map, ivec2(column, row), 0).r * 65535.0));
}

)";

inline constexpr std::string_view whole_map =
    R"(layout(set = @map_set@, binding = @map_binding@) uniform usampler2D displaced_map;

uint displaced_texel(uint column, uint row) { return texelFetch(displaced_map, ivec2(column, row), 0).r; }

)";

inline constexpr std::string_view frame = R"(layout(push_constant) uniform DisplacedFrame {
  mat4 clip_from_posed;
  vec3 eye;
  float pixels_per_unit;
} displaced_frame;

)";

inline constexpr std::string_view rest =
    R"(layout(std430, set = @set@, binding = @rest@) readonly buffer DisplacedRest { DisplacedVertex displaced_rest[]; };
layout(std430, set = @set@, binding = @maps@) readonly buffer DisplacedMaps { DisplacedMap displaced_maps[]; };

)";

inline constexpr std::string_view rigid = R"(DisplacedVertex displaced_vertex(uint vertex, uint instance) {
  return displaced_posed(displaced_rest[vertex], displaced_maps[instance]);
}

)";

inline constexpr std::string_view skinned = R"(struct DisplacedSkin {
  uvec4 joint;
  vec4 weight;
};
layout(std430, set = @set@, binding = @skin@) readonly buffer DisplacedSkins { DisplacedSkin displaced_skin[]; };

DisplacedVertex displaced_vertex(uint vertex, uint instance) {
  DisplacedSkin skin = displaced_skin[vertex];
  uvec4 joint = displaced_joints * instance + skin.joint;
  return displaced_posed(displaced_rest[vertex],
                         displaced_blended(displaced_maps[joint.x], displaced_maps[joint.y], displaced_maps[joint.z],
                                           displaced_maps[joint.w], skin.weight));
}

)";

inline constexpr std::string_view cage = R"(layout(local_size_x = 64) in;
layout(std430, set = @set@, binding = @cage@) writeonly buffer DisplacedCage { DisplacedVertex displaced_cage[]; };

void main() {
  uint vertex = gl_GlobalInvocationID.x, instance = gl_GlobalInvocationID.y;
  if (vertex >= displaced_vertices) return;
  displaced_cage[displaced_vertices * instance + vertex] = displaced_vertex(vertex, instance);
}
)";

inline constexpr std::string_view cage_capture = R"(layout(xfb_buffer = 0, xfb_stride = 32) out;
layout(location = 0, xfb_offset = 0) out vec3 position;
layout(location = 1, xfb_offset = 12) flat out int x;
layout(location = 2, xfb_offset = 16) out vec3 direction;
layout(location = 3, xfb_offset = 28) flat out int y;

void main() {
  DisplacedVertex posed = displaced_vertex(uint(gl_VertexIndex), uint(gl_InstanceIndex));
  position = posed.position;
  x = posed.x;
  direction = posed.direction;
  y = posed.y;
  gl_PointSize = 1.0;
}
)";

inline constexpr std::string_view posed_cage =
    R"(layout(std430, set = @set@, binding = @cage@) readonly buffer DisplacedCage { DisplacedVertex displaced_cage[]; };

DisplacedVertex displaced_vertex(uint vertex, uint instance) {
  return displaced_cage[displaced_vertices * instance + vertex];
}

)";

inline constexpr std::string_view vertex = R"(layout(location = 0) out vec3 position;
layout(location = 1) out vec3 direction;
layout(location = 2) flat out ivec2 place;
layout(location = 3) flat out uvec2 number;

void main() {
  DisplacedVertex posed = displaced_vertex(uint(gl_VertexIndex), uint(gl_InstanceIndex));
  position = posed.position;
  direction = posed.direction;
  place = ivec2(posed.x, posed.y);
  number = uvec2(gl_VertexIndex, gl_InstanceIndex);
}
)";

inline constexpr std::string_view constant_levels = R"(void displaced_levels(out vec3 outer, out float inner) {
  outer = vec3(displaced_level, displaced_level, displaced_level);
  inner = displaced_level;
}

)";

inline constexpr std::string_view levels_by_pixels = R"(float displaced_level(int one, int other) {
  return displaced_edge_level(position_in[one], position_in[other], displaced_frame.eye, displaced_frame.pixels_per_unit,
                              displaced_pixels_per_part);
}

void displaced_levels(out vec3 outer, out float inner) {
  outer = vec3(displaced_level(1, 2), displaced_level(2, 0), displaced_level(0, 1));
  inner = max(max(outer.x, outer.y), outer.z);
}

)";

inline constexpr std::string_view stored_levels =
    R"(layout(std430, set = @set@, binding = @levels@) readonly buffer DisplacedLevels { vec4 displaced_stored_levels[]; };

void displaced_levels(out vec3 outer, out float inner) {
  vec4 levels = displaced_stored_levels[gl_PrimitiveID];
  outer = levels.xyz;
  inner = levels.w;
}

)";

inline constexpr std::string_view seams =
    R"(layout(std430, set = @set@, binding = @seams@) readonly buffer DisplacedSeams { uint displaced_seam_words[]; };

uint displaced_seam(uint word) { return displaced_seam_words[word]; }

)";

inline constexpr std::string_view patch_in = R"(layout(location = 0) in vec3 position_in[];
layout(location = 1) in vec3 direction_in[];
layout(location = 2) in ivec2 place_in[];
layout(location = 3) in uvec2 number_in[];

)";

inline constexpr std::string_view control = R"(layout(vertices = 3) out;
layout(location = 0) out vec3 position[];
layout(location = 1) out vec3 direction[];
layout(location = 2) out ivec2 place[];
layout(location = 3) out uvec2 number[];

void main() {
  position[gl_InvocationID] = position_in[gl_InvocationID];
  direction[gl_InvocationID] = direction_in[gl_InvocationID];
  place[gl_InvocationID] = place_in[gl_InvocationID];
  number[gl_InvocationID] = number_in[gl_InvocationID];
  if (gl_InvocationID == 0) {
    vec3 outer;
    float inner;
    displaced_levels(outer, inner);
    for (int e = 0; e < 3; ++e) gl_TessLevelOuter[e] = outer[e];
    gl_TessLevelInner[0] = inner;
  }
}
)";

inline constexpr std::string_view evaluation = R"(layout(triangles, @spacing@, cw) in;
@capture@
layout(location = 0@at_0@) out vec3 surface;
layout(location = 1@at_12@) out vec3 weights;
layout(location = 2@at_24@) flat out uvec4 corners;  // vertices, and the instance

DisplacedVertex displaced_corner(int c) {
  return DisplacedVertex(position_in[c], place_in[c].x, direction_in[c], place_in[c].y);
}

void main() {
  DisplacedVertex a = displaced_corner(0), b = displaced_corner(1), c = displaced_corner(2);
  uvec3 w = displaced_height_weights(gl_TessCoord);
  surface = displaced_point(a, b, c, gl_TessCoord, displaced_displacement(@height@));
  weights = gl_TessCoord;
  corners = uvec4(number_in[0].x, number_in[1].x, number_in[2].x, number_in[0].y);
  precise vec4 at = displaced_frame.clip_from_posed * vec4(surface, 1.0);
  gl_Position = at;
}
)";

}  // namespace foredraw::displaced_shader_parts::glsl
