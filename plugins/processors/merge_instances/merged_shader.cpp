#include "merged_shader.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>
#include <stdexcept>

namespace foredraw {

namespace {

/// "TEXCOORD_0" as "texcoord_0", "_MY--THING" as "my_thing": no shading language allows two underscores in a row.
std::string shader_name(const std::string& semantic, std::set<std::string>& taken) {
  std::string name;
  for (const char c : semantic) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_digit = c >= '0' && c <= '9';
    if (is_letter || is_digit) {
      name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) name = "attribute";
  // The names of the functions that are always there, without "merged_".
  static const std::set<std::string> own = {"vertex",          "to_world",   "direction_to_world",
                                            "normal_to_world", "handedness", "byte",
                                            "short",           "word",       "frequency",
                                            "slots",           "indices",    "transforms",
                                            "words",           "materials",  "material"};
  std::string free = own.contains(name) ? name + "_attribute" : name;
  for (int i = 2; !taken.insert(free).second; ++i) free = name + "_of_" + std::to_string(i);
  return free;
}

std::string number(std::uint64_t value) { return std::to_string(value) + "u"; }

/// What the two languages call differently.
struct Words {
  const char *vec2, *vec3, *vec4, *as_float, *pair;
};

const Words& words_of(ShaderLanguage language) {
  static const Words glsl{"vec2", "vec3", "vec4", "uintBitsToFloat", "uvec2"};
  static const Words hlsl{"float2", "float3", "float4", "asfloat", "uint2"};
  return language == ShaderLanguage::glsl ? glsl : hlsl;
}

std::string glsl_buffers(const MergedShaderOptions& options) {
  const auto buffer = [&](std::uint32_t place, const char* block, const char* content) {
    return "layout(std430, set = " + std::to_string(options.set) +
           ", binding = " + std::to_string(options.first_binding + place) + ") readonly buffer " + block + " { " +
           content + " };\n";
  };
  return buffer(0, "MergedSlots", "uvec2 merged_slots[];") + buffer(1, "MergedIndices", "uint merged_indices[];") +
         buffer(2, "MergedTransforms", "vec4 merged_transforms[];") + buffer(3, "MergedWords", "uint merged_words[];") +
         (options.materials ? buffer(4, "MergedMaterials", "uint merged_materials[];") : "");
}

std::string hlsl_buffers(const MergedShaderOptions& options) {
  const auto buffer = [&](std::uint32_t place, const char* type, const char* name) {
    return std::string(type) + " " + name + " : register(t" + std::to_string(options.first_binding + place) +
           ", space" + std::to_string(options.set) + ");\n";
  };
  return buffer(0, "StructuredBuffer<uint2>", "merged_slots") + buffer(1, "StructuredBuffer<uint>", "merged_indices") +
         buffer(2, "StructuredBuffer<float4>", "merged_transforms") + buffer(3, "ByteAddressBuffer", "merged_words") +
         (options.materials ? buffer(4, "StructuredBuffer<uint>", "merged_materials") : "");
}

std::string fetch(const MergedShaderOptions& options) {
  const Words& words = words_of(options.language);
  const bool glsl = options.language == ShaderLanguage::glsl;
  std::string text;
  text += "#ifndef MERGED_FREQUENCY\n#define MERGED_FREQUENCY " + number(options.frequency) + "\n#endif\n";
  text += std::string(glsl ? "" : "static ") + "const uint merged_frequency = MERGED_FREQUENCY;\n\n";
  text += "struct MergedVertex {\n  uint instance;\n  uint vertex;\n};\n\n";
  text +=
      "MergedVertex merged_vertex(uint number, uint first_slot) {\n"
      "  uint slot = number / merged_frequency;\n";
  text += std::string("  ") + words.pair + " record = merged_slots[first_slot + slot];\n";
  text +=
      "  MergedVertex at;\n"
      "  at.instance = record.y;\n"
      "  at.vertex = merged_indices[record.x + (number - slot * merged_frequency)];\n"
      "  return at;\n}\n\n";
  return text;
}

std::string transforms(const MergedShaderOptions& options) {
  const Words& words = words_of(options.language);
  const std::string vec3 = words.vec3, vec4 = words.vec4;
  const auto rows = [&](const char* with) {
    std::string text;
    for (const char* row : {"x", "y", "z"}) {
      const int at = row[0] - 'x';
      text +=
          "  " + vec4 + " " + row + " = merged_transforms[3u * instance" + (at > 0 ? " + " + number(at) : "") + "];\n";
    }
    return text + with;
  };
  return vec3 + " merged_to_world(uint instance, " + vec3 + " position) {\n" +
         rows(("  " + vec4 + " p = " + vec4 + "(position, 1.0);\n  return " + vec3 +
               "(dot(x, p), dot(y, p), dot(z, p));\n}\n\n")
                  .c_str()) +
         vec3 + " merged_direction_to_world(uint instance, " + vec3 + " direction) {\n" +
         rows(("  return " + vec3 + "(dot(x.xyz, direction), dot(y.xyz, direction), dot(z.xyz, direction));\n}\n\n")
                  .c_str()) +
         "float merged_handedness(uint instance) {\n" +
         rows("  return dot(x.xyz, cross(y.xyz, z.xyz)) < 0.0 ? -1.0 : 1.0;\n}\n\n") +
         "// The cofactor matrix is the inverse transpose, up to a scale.\n" + vec3 +
         " merged_normal_to_world(uint instance, " + vec3 + " normal) {\n" +
         rows(("  " + vec3 + " a = cross(y.xyz, z.xyz);\n  " + vec3 + " turned = " + vec3 +
               "(dot(a, normal), dot(cross(z.xyz, x.xyz), normal), dot(cross(x.xyz, y.xyz), normal));\n"
               "  return dot(x.xyz, a) < 0.0 ? -turned : turned;\n}\n\n")
                  .c_str());
}

/// The smallest reads that attributes need, at a byte's address.
std::string reads(const MergedVertexLayout& layout, ShaderLanguage language) {
  const bool glsl = language == ShaderLanguage::glsl;
  const auto any = [&](std::size_t bytes) {
    return std::ranges::any_of(layout.attributes, [&](const MergedVertexLayout::Attribute& attribute) {
      return attribute.format.components <= 4 && bytes_of(attribute.format.component) == bytes;
    });
  };
  std::string text = std::string("uint merged_word(uint address) { return ") +
                     (glsl ? "merged_words[address >> 2]" : "merged_words.Load(address & ~3u)") + "; }\n";
  if (any(2))
    text += "uint merged_short(uint address) { return merged_word(address) >> ((address & 2u) * 8u) & 0xffffu; }\n";
  if (any(1))
    text += "uint merged_byte(uint address) { return merged_word(address) >> ((address & 3u) * 8u) & 0xffu; }\n";
  return text + "\n";
}

/// One component at `address`, as a float.
std::string component_text(const Format& format, const std::string& address, const Words& words) {
  const auto scaled = [&](const std::string& value, bool is_signed, const char* most) {
    if (!format.normalized) return "float(" + value + ")";
    return is_signed ? "max(float(" + value + ") / " + most + ", -1.0)" : "float(" + value + ") / " + most;
  };
  switch (format.component) {
    case Component::float32: return std::string(words.as_float) + "(merged_word(" + address + "))";
    case Component::uint32: return scaled("merged_word(" + address + ")", false, "4294967295.0");
    case Component::uint16: return scaled("merged_short(" + address + ")", false, "65535.0");
    case Component::uint8: return scaled("merged_byte(" + address + ")", false, "255.0");
    case Component::int16: return scaled("(int(merged_short(" + address + ") << 16) >> 16)", true, "32767.0");
    case Component::int8: return scaled("(int(merged_byte(" + address + ") << 24) >> 24)", true, "127.0");
  }
  return "0.0";
}

std::string attribute_text(const MergedVertexLayout::Attribute& attribute, const Words& words) {
  const Format& format = attribute.format;
  if (format.components < 1 || format.components > 4) {
    return "// " + attribute.name + " has " + std::to_string(format.components) +
           " components and is not read here.\n\n";
  }
  const std::string types[] = {"float", words.vec2, words.vec3, words.vec4};
  const std::string type = types[format.components - 1];
  const std::size_t size = bytes_of(format.component);
  std::string text = type + " merged_" + attribute.name +
                     "(uint vertex) {\n  uint address = " + number(attribute.offset) + " + vertex * " +
                     number(format.bytes) + ";\n  return ";
  std::string components;
  for (std::size_t c = 0; c < format.components; ++c) {
    if (c > 0) components += ",\n      ";
    components += component_text(format, c == 0 ? "address" : "address + " + number(c * size), words);
  }
  return text + (format.components == 1 ? components : type + "(\n      " + components + ")") + ";\n}\n\n";
}

std::set<std::uint32_t> frequencies_of(const MergedInstances& set) {
  std::set<std::uint32_t> frequencies;
  for (const MergedDraw& draw : set.draws) frequencies.insert(draw.frequency);
  return frequencies;
}

}  // namespace

MergedVertexLayout merged_vertex_layout(const VertexStreams& vertices) {
  MergedVertexLayout layout;
  std::set<std::string> taken;
  for (const VertexStream& stream : vertices.base) {
    if (layout.bytes + stream.bytes.size() > 0xffffffff) {
      throw std::length_error(
          "the merged vertices have 2^32 bytes or more, which no shader can address; merge fewer meshes");
    }
    layout.attributes.push_back({stream.semantic, shader_name(stream.semantic, taken), stream.format,
                                 static_cast<std::uint32_t>(layout.bytes)});
    layout.bytes += (stream.bytes.size() + 3) / 4 * 4;
  }
  return layout;
}

std::vector<std::byte> merged_vertex_bytes(const VertexStreams& vertices, const MergedVertexLayout& layout) {
  std::vector<std::byte> bytes(layout.bytes);
  for (std::size_t i = 0; i < vertices.base.size(); ++i) {
    std::ranges::copy(vertices.base[i].bytes.view(), bytes.begin() + layout.attributes[i].offset);
  }
  return bytes;
}

std::string merged_shader_text(const MergedVertexLayout& layout, const MergedShaderOptions& options) {
  const bool glsl = options.language == ShaderLanguage::glsl;
  std::string text = (glsl ? glsl_buffers(options) : hlsl_buffers(options)) + "\n";
  text += fetch(options) + transforms(options);
  if (options.materials) text += "uint merged_material(uint instance) { return merged_materials[instance]; }\n\n";
  text += reads(layout, options.language);
  for (const MergedVertexLayout::Attribute& attribute : layout.attributes) {
    text += attribute_text(attribute, words_of(options.language));
  }
  return text;
}

std::string merged_shader_text(std::span<const MergedInstances> sets, ShaderLanguage language) {
  std::string text =
      "// Made by Foredraw: the vertex fetch of merged draws. Define before including:\n"
      "//   MERGED_SET        number of the set; 0 by default\n"
      "//   MERGED_FREQUENCY  index entries of a slot of the draw; those of each set:\n";
  for (std::size_t s = 0; s < sets.size(); ++s) {
    std::string frequencies;
    for (const std::uint32_t frequency : frequencies_of(sets[s])) {
      frequencies += (frequencies.empty() ? " " : ", ") + std::to_string(frequency);
    }
    text += "//                     set " + std::to_string(s) + ":" + frequencies + "\n";
  }
  text += "#ifndef MERGED_SET\n#define MERGED_SET 0\n#endif\n\n";
  for (std::size_t s = 0; s < sets.size(); ++s) {
    MergedShaderOptions options;
    options.language = language;
    options.materials = !sets[s].materials.empty();
    const std::set<std::uint32_t> frequencies = frequencies_of(sets[s]);
    if (!frequencies.empty()) options.frequency = *frequencies.begin();
    text += "#if MERGED_SET == " + std::to_string(s) + "\n\n";
    text += merged_shader_text(merged_vertex_layout(*sets[s].vertices), options);
    text += "#endif  // MERGED_SET == " + std::to_string(s) + "\n\n";
  }
  return text;
}

}  // namespace foredraw
