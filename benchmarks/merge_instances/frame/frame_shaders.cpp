#include "frame_shaders.h"

#include <foredraw/instances/merged_instances.h>
#include <plugins/processors/merge_instances/merged_shader.h>

namespace foredraw::bench {

namespace {

constexpr const char* shared_text = R"(
layout(push_constant) uniform Frame {
  mat4 clip_from_world;
  uint first;
};
layout(std430, set = 0, binding = 5) readonly buffer Places { uint places[]; };
layout(std430, set = 0, binding = 6) readonly buffer Looks { uint looks[]; };

layout(location = 0) flat out uvec4 corner;
layout(location = 1) out vec3 shown_normal;
layout(location = 2) out vec2 shown_texture_place;
invariant gl_Position;

uint mixed(uint hash, float value) {
  hash = (hash ^ floatBitsToUint(value)) * 0x9e3779b1u;
  return hash ^ (hash >> 15);
}

void show(uint place, uint look, vec3 world, vec3 normal, vec2 texture_place) {
  gl_Position = clip_from_world * vec4(world, 1.0);
  corner = uvec4(place, look, mixed(mixed(mixed(1u, normal.x), normal.y), normal.z),
                 mixed(mixed(1u, texture_place.x), texture_place.y));
  shown_normal = normal;
  shown_texture_place = texture_place;
}
)";

constexpr const char* own_transforms_text = R"(
layout(std430, set = 0, binding = 2) readonly buffer Transforms { vec4 rows[]; };

vec3 to_world(uint instance, vec3 position) {
  vec4 p = vec4(position, 1.0);
  return vec3(dot(rows[3u * instance], p), dot(rows[3u * instance + 1u], p), dot(rows[3u * instance + 2u], p));
}

vec3 normal_to_world(uint instance, vec3 normal) {
  vec3 x = rows[3u * instance].xyz, y = rows[3u * instance + 1u].xyz, z = rows[3u * instance + 2u].xyz;
  mat3 cofactors = mat3(cross(y, z), cross(z, x), cross(x, y));
  vec3 turned = vec3(dot(cofactors[0], normal), dot(cofactors[1], normal), dot(cofactors[2], normal));
  return dot(x, cofactors[0]) < 0.0 ? -turned : turned;
}
)";

bool has(const FramePart& part, const char* semantic) { return part.vertices->find(semantic) != nullptr; }

std::string input(const FramePart& part, const char* semantic, std::uint32_t location, const char* type,
                  const char* name) {
  if (!has(part, semantic)) return std::string("const ") + type + " " + name + " = " + type + "(0.0);\n";
  return "layout(location = " + std::to_string(location) + ") in " + type + " " + name + ";\n";
}

std::string merged_text(const Scene& scene, const FramePart& part, std::uint32_t frequency) {
  const auto fetched = [&](const char* semantic, const char* call, const char* none) {
    return std::string(has(part, semantic) ? call : none);
  };
  const std::string material = part.material ? std::to_string(*part.material) + "u" : "merged_material(at.instance)";
  return "#define MERGED_SET " + std::to_string(part.merged_set) + "\n#define MERGED_FREQUENCY " +
         std::to_string(frequency) + "u\n" + merged_shader_text(merged_sets(scene), ShaderLanguage::glsl) +
         shared_text +
         "void main() {\n"
         "  MergedVertex at = merged_vertex(uint(gl_VertexIndex), first);\n"
         "  vec3 normal = " +
         fetched("NORMAL", "merged_normal_to_world(at.instance, merged_normal(at.vertex))", "vec3(0.0)") +
         ";\n  vec2 texture_place = " + fetched("TEXCOORD_0", "merged_texcoord_0(at.vertex)", "vec2(0.0)") +
         ";\n  show(places[at.instance], looks[" + material +
         "], merged_to_world(at.instance, merged_position(at.vertex)), normal, texture_place);\n}\n";
}

std::string indexed_text(const FramePart& part) {
  const bool is_in_world = part.fetch == VertexFetch::in_world;
  std::string text = shared_text;
  text += "layout(std430, set = 0, binding = 4) readonly buffer Materials { uint materials[]; };\n";
  text += input(part, "POSITION", location::position, "vec3", "position");
  text += input(part, "NORMAL", location::normal, "vec3", "normal");
  text += input(part, "TEXCOORD_0", location::texture_place, "vec2", "texture_place");
  if (is_in_world) {
    text += "layout(location = " + std::to_string(location::instance) + ") in uint instance;\nvoid main() {\n" +
            "  show(places[instance], looks[materials[instance]], position, normal, texture_place);\n}\n";
  } else {
    text += own_transforms_text;
    text +=
        "void main() {\n"
        "  uint instance = first + uint(gl_InstanceIndex);\n"
        "  show(places[instance], looks[materials[instance]], to_world(instance, position),\n"
        "       normal_to_world(instance, normal), texture_place);\n}\n";
  }
  return text;
}

}  // namespace

std::string vertex_shader_text(const Scene& scene, const FramePart& part, std::uint32_t frequency) {
  return "#version 450\n" +
         (part.fetch == VertexFetch::merged ? merged_text(scene, part, frequency) : indexed_text(part));
}

std::string fragment_shader_text() {
  return R"(#version 450
layout(location = 0) flat in uvec4 corner;
layout(location = 1) in vec3 shown_normal;
layout(location = 2) in vec2 shown_texture_place;
layout(location = 0) out uint shown;

uint mixed(uint hash, uint value) {
  hash = (hash ^ value) * 0x9e3779b1u;
  return hash ^ (hash >> 15);
}

void main() {
  // A hair off zero, where many components lie, so that the last bit does not decide.
  ivec3 normal = ivec3(floor(normalize(shown_normal) * 64.0 + 0.4));
  ivec2 place = ivec2(floor(shown_texture_place * 1024.0 + 0.4));
  uint hash = mixed(mixed(mixed(mixed(1u, corner.x), corner.y), corner.z), corner.w);
  hash = mixed(mixed(mixed(hash, uint(normal.x)), uint(normal.y)), uint(normal.z));
  hash = mixed(mixed(hash, uint(place.x)), uint(place.y));
  shown = hash == 0xffffffffu ? 0u : hash;  // which is nobody's
}
)";
}

}  // namespace foredraw::bench
