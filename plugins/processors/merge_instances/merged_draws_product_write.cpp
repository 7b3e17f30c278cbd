// FOREDRAW_merge_instances, written; and the files for engines that read no glTF.
#include "merged_draws_product.h"
#include "merged_shader.h"

#include <map>

namespace foredraw::processors::merge_instances {

namespace {

using Members = ExtensionValue::Members;

/// With `counts_vertices` a draw says how many vertices it is drawn with.
ExtensionValue groups_of(const MergedInstances& set, bool counts_vertices) {
  std::vector<ExtensionValue::List> draws(set.groups.size());
  for (const MergedDraw& draw : set.draws) {
    Members members{{"frequency", draw.frequency}, {"firstSlot", draw.first_slot}, {"slotCount", draw.slot_count}};
    if (counts_vertices) members.emplace_back("vertexCount", draw.frequency * draw.slot_count);
    draws[draw.group].push_back(std::move(members));
  }
  const auto corner = [](const glm::vec3& at) { return ExtensionValue::List{at.x, at.y, at.z}; };
  ExtensionValue::List groups;
  for (std::size_t g = 0; g < set.groups.size(); ++g) {
    const MergedGroup& group = set.groups[g];
    groups.push_back(Members{{"min", corner(group.least)},
                             {"max", corner(group.most)},
                             {"firstInstance", group.first_instance},
                             {"instanceCount", group.instance_count},
                             {"draws", std::move(draws[g])}});
  }
  return groups;
}

/// Each mesh's primitives, and where their vertices begin, which need no bytes of their own.
ExtensionValue primitives_of(const Scene& scene, const MergedInstances& set,
                             const std::vector<std::pair<std::string, AccessorRef>>& attributes, ExtensionWriter& to) {
  std::map<DrawId, std::uint32_t> first_vertex;
  for (const MergedMesh& mesh : set.meshes) first_vertex.emplace(mesh.draw, mesh.first_vertex);
  ExtensionValue::List list;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    for (std::size_t p = 0; p < scene.meshes[m].draws.size(); ++p) {
      const auto first = first_vertex.find(scene.meshes[m].draws[p]);
      if (first == first_vertex.end()) continue;
      list.push_back(Members{{"mesh", m}, {"primitive", p}, {"firstVertex", first->second}});
      to.share_vertices(first->first, attributes, first->second);
    }
  }
  return list;
}

ExtensionValue value_of(const Scene& scene, const MergedInstances& set, ExtensionWriter& to) {
  const auto numbers = [&](const auto& values, Component component, std::uint8_t components) {
    return to.accessor(accessor_data(values.view(), component, components));
  };
  Members members;
  if (set.material) members.emplace_back("material", *set.material);
  std::vector<std::pair<std::string, AccessorRef>> attributes;
  for (const VertexStream& stream : set.vertices->base) {
    using Use = AccessorData::Use;
    const Use use = stream.semantic == "POSITION" ? Use::positions : Use::vertices;
    attributes.emplace_back(stream.semantic, to.accessor({stream.format, set.vertices->count, stream.bytes, use}));
  }
  members.emplace_back("attributes", Members(attributes.begin(), attributes.end()));
  members.emplace_back("indices", numbers(set.indices, Component::uint32, 1));
  members.emplace_back("slots", numbers(set.slots, Component::uint32, 2));
  members.emplace_back("transforms", numbers(set.transforms, Component::float32, 4));
  members.emplace_back("places", numbers(set.places, Component::uint32, 3));
  if (!set.materials.empty()) members.emplace_back("materials", numbers(set.materials, Component::uint32, 1));
  members.emplace_back("groups", groups_of(set, false));
  members.emplace_back("primitives", primitives_of(scene, set, attributes, to));
  return members;
}

/// One file of all buffers, one behind the other; what is there already is not put there again.
class Buffers {
 public:
  template <class T>
  ExtensionValue put(const Shared<T>& values) {
    return Members{{"offset", place_of(values.stamp(), std::as_bytes(values.view()))}, {"count", values.size()}};
  }

  std::size_t place_of(const Stamp& stamp, std::span<const std::byte> bytes) {
    constexpr std::size_t alignment = 256;  // the strictest that graphics interfaces ask of the parts of a buffer
    const auto [place, is_new] = places_.try_emplace(stamp, 0);
    if (!is_new) return place->second;
    bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
    place->second = bytes_.size();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return place->second;
  }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::map<Stamp, std::size_t> places_;
  std::vector<std::byte> bytes_;
};

const char* text_of(Component component) {
  switch (component) {
    case Component::int8: return "int8";
    case Component::uint8: return "uint8";
    case Component::int16: return "int16";
    case Component::uint16: return "uint16";
    case Component::uint32: return "uint32";
    case Component::float32: return "float32";
  }
  return "";
}

ExtensionValue value_of(const VertexStreams& vertices, Buffers& buffers) {
  const MergedVertexLayout layout = merged_vertex_layout(vertices);
  return Members{{"offset", buffers.place_of(vertices.stamp(), merged_vertex_bytes(vertices, layout))},
                 {"count", vertices.count},
                 {"bytes", layout.bytes},
                 {"attributes", listed(layout.attributes, [](const MergedVertexLayout::Attribute& attribute) {
                    return Members{{"semantic", attribute.semantic},
                                   {"shader", "merged_" + attribute.name},
                                   {"offset", attribute.offset},
                                   {"stride", attribute.format.bytes},
                                   {"component", text_of(attribute.format.component)},
                                   {"components", attribute.format.components},
                                   {"normalized", attribute.format.normalized}};
                  })}};
}

ExtensionValue value_of(const MergedInstances& set, const Scene& scene, Buffers& buffers) {
  Members members;
  members.reserve(9);  // all of these
  if (set.material) {
    members.emplace_back("material", *set.material);
    members.emplace_back("materialName", scene.materials[*set.material].name);
  }
  members.emplace_back("vertices", value_of(*set.vertices, buffers));
  members.emplace_back("indices", buffers.put(set.indices));
  members.emplace_back("slots", buffers.put(set.slots));
  members.emplace_back("transforms", buffers.put(set.transforms));
  members.emplace_back("places", buffers.put(set.places));
  if (!set.materials.empty()) members.emplace_back("materials", buffers.put(set.materials));
  members.emplace_back("groups", groups_of(set, true));
  return members;
}

SideFile description(const Scene& scene, const std::string& beside) {
  Buffers buffers;
  ExtensionValue value = Members{{"foredraw", "merge-instances"}, {"version", 1}, {"buffer", beside}};
  value.put("sets",
            listed(merged_sets(scene), [&](const MergedInstances& set) { return value_of(set, scene, buffers); }));
  return {.content = std::move(value), .beside = buffers.take()};
}

}  // namespace

void write_merged_draws(const Scene& scene, ExtensionWriter& to) {
  to.put_on_file(Members{
      {"sets", listed(merged_sets(scene), [&](const MergedInstances& set) { return value_of(scene, set, to); })}});
}

SideFile merged_side_file(const Scene& scene, std::string_view extension, const std::string& beside) {
  try {
    if (extension == ".json") return description(scene, beside);
    const ShaderLanguage language = extension == ".hlsl" ? ShaderLanguage::hlsl : ShaderLanguage::glsl;
    return {.content = merged_shader_text(merged_sets(scene), language)};
  } catch (const std::length_error& error) {
    throw Refusal("too-large", error.what(), "merge in several stages, each with its own only = \"NAMES\"");
  }
}

}  // namespace foredraw::processors::merge_instances
