#pragma once
// Resources and stages in HLSL. What stands between @ is filled in.

#include <string_view>

namespace foredraw::displaced_shader_parts::hlsl {

inline constexpr std::string_view normalized_map =
    R"(Texture2D<float> displaced_map : register(t@map_binding@, space@map_set@);

uint displaced_texel(uint column, uint row) {
  return uint(round(displaced_map.Load(int3(column, row, 0)) * 65535.0));
}

)";

inline constexpr std::string_view whole_map =
    R"(Texture2D<uint> displaced_map : register(t@map_binding@, space@map_set@);

uint displaced_texel(uint column, uint row) { return displaced_map.Load(int3(column, row, 0)); }

)";

inline constexpr std::string_view frame = R"(struct DisplacedFrame {
  column_major float4x4 clip_from_posed;
  float3 eye;
  float pixels_per_unit;
};
#ifdef DISPLACED_PUSH_CONSTANT
[[vk::push_constant]] ConstantBuffer<DisplacedFrame> displaced_frame;
#else
ConstantBuffer<DisplacedFrame> displaced_frame : register(b0, space@set@);
#endif

)";

inline constexpr std::string_view rest =
    R"(StructuredBuffer<DisplacedVertex> displaced_rest : register(t@rest@, space@set@);
StructuredBuffer<DisplacedMap> displaced_maps : register(t@maps@, space@set@);

)";

inline constexpr std::string_view rigid = R"(DisplacedVertex displaced_vertex(uint vertex, uint instance) {
  return displaced_posed(displaced_rest[vertex], displaced_maps[instance]);
}

)";

inline constexpr std::string_view skinned = R"(struct DisplacedSkin {
  uint4 joint;
  float4 weight;
};
StructuredBuffer<DisplacedSkin> displaced_skin : register(t@skin@, space@set@);

DisplacedVertex displaced_vertex(uint vertex, uint instance) {
  DisplacedSkin skin = displaced_skin[vertex];
  uint4 joint = displaced_joints * instance + skin.joint;
  return displaced_posed(displaced_rest[vertex],
                         displaced_blended(displaced_maps[joint.x], displaced_maps[joint.y], displaced_maps[joint.z],
                                           displaced_maps[joint.w], skin.weight));
}

)";

inline constexpr std::string_view cage =
    R"(RWStructuredBuffer<DisplacedVertex> displaced_cage : register(u@cage@, space@set@);

[numthreads(64, 1, 1)]
void main(uint3 number : SV_DispatchThreadID) {
  if (number.x >= displaced_vertices) return;
  displaced_cage[displaced_vertices * number.y + number.x] = displaced_vertex(number.x, number.y);
}
)";

inline constexpr std::string_view posed_cage =
    R"(StructuredBuffer<DisplacedVertex> displaced_cage : register(t@cage@, space@set@);

DisplacedVertex displaced_vertex(uint vertex, uint instance) {
  return displaced_cage[displaced_vertices * instance + vertex];
}

)";

inline constexpr std::string_view corner = R"(struct DisplacedCorner {
  float3 position : DISPLACED_POSITION;
  float3 direction : DISPLACED_DIRECTION;
  int2 place : DISPLACED_PLACE;
  uint2 number : DISPLACED_NUMBER;  // the vertex's and the instance's
};

)";

inline constexpr std::string_view vertex =
    R"(DisplacedCorner main(uint vertex : SV_VertexID, uint instance : SV_InstanceID) {
  DisplacedVertex posed = displaced_vertex(vertex, instance);
  DisplacedCorner result;
  result.position = posed.position;
  result.direction = posed.direction;
  result.place = int2(posed.x, posed.y);
  result.number = uint2(vertex, instance);
  return result;
}
)";

inline constexpr std::string_view patch = R"(struct DisplacedLevels {
  float outer[3] : SV_TessFactor;
  float inner : SV_InsideTessFactor;@triangle_member@
};

)";

inline constexpr std::string_view constant_levels =
    R"(DisplacedLevels displaced_levels(InputPatch<DisplacedCorner, 3> corner, uint number : SV_PrimitiveID) {
  DisplacedLevels levels;@triangle_set@
  for (int e = 0; e < 3; ++e) levels.outer[e] = displaced_level;
  levels.inner = displaced_level;
  return levels;
}

)";

inline constexpr std::string_view levels_by_pixels = R"(float displaced_level(float3 one, float3 other) {
  return displaced_edge_level(one, other, displaced_frame.eye, displaced_frame.pixels_per_unit, displaced_pixels_per_part);
}

DisplacedLevels displaced_levels(InputPatch<DisplacedCorner, 3> corner, uint number : SV_PrimitiveID) {
  DisplacedLevels levels;@triangle_set@
  levels.outer[0] = displaced_level(corner[1].position, corner[2].position);
  levels.outer[1] = displaced_level(corner[2].position, corner[0].position);
  levels.outer[2] = displaced_level(corner[0].position, corner[1].position);
  levels.inner = max(max(levels.outer[0], levels.outer[1]), levels.outer[2]);
  return levels;
}

)";

inline constexpr std::string_view stored_levels =
    R"(StructuredBuffer<float4> displaced_stored_levels : register(t@levels@, space@set@);

DisplacedLevels displaced_levels(InputPatch<DisplacedCorner, 3> corner, uint number : SV_PrimitiveID) {
  float4 stored = displaced_stored_levels[number];
  DisplacedLevels levels;@triangle_set@
  levels.outer[0] = stored.x;
  levels.outer[1] = stored.y;
  levels.outer[2] = stored.z;
  levels.inner = stored.w;
  return levels;
}

)";

inline constexpr std::string_view seams =
    R"(StructuredBuffer<uint> displaced_seam_words : register(t@seams@, space@set@);

uint displaced_seam(uint word) { return displaced_seam_words[word]; }

)";

inline constexpr std::string_view control = R"([domain("tri")]
[partitioning("@spacing@")]
[outputtopology("triangle_cw")]
[outputcontrolpoints(3)]
[patchconstantfunc("displaced_levels")]
DisplacedCorner main(InputPatch<DisplacedCorner, 3> corner, uint number : SV_OutputControlPointID) {
  return corner[number];
}
)";

inline constexpr std::string_view evaluation = R"(struct DisplacedSurface {
  float3 surface : DISPLACED_SURFACE;
  float3 weights : DISPLACED_WEIGHTS;
  nointerpolation uint4 corners : DISPLACED_CORNERS;  // vertices, and the instance
  float4 at : SV_Position;
};

DisplacedVertex displaced_corner(DisplacedCorner from) {
  DisplacedVertex corner;
  corner.position = from.position;
  corner.x = from.place.x;
  corner.direction = from.direction;
  corner.y = from.place.y;
  return corner;
}

[domain("tri")]
DisplacedSurface main(DisplacedLevels levels, float3 weights : SV_DomainLocation,
                      const OutputPatch<DisplacedCorner, 3> corner) {
  DisplacedVertex a = displaced_corner(corner[0]), b = displaced_corner(corner[1]), c = displaced_corner(corner[2]);
  DisplacedSurface result;
  uint3 w = displaced_height_weights(weights);
  result.surface = displaced_point(a, b, c, weights, displaced_displacement(@height@));
  result.weights = weights;
  result.corners = uint4(corner[0].number.x, corner[1].number.x, corner[2].number.x, corner[0].number.y);
  precise float4 at = mul(displaced_frame.clip_from_posed, float4(result.surface, 1.0));
  result.at = at;
  return result;
}
)";

}  // namespace foredraw::displaced_shader_parts::hlsl
