#include <foredraw/io/merged_files.h>

#include <foredraw/io/merged_shader.h>
#include <foredraw/io/text/private/file_kind.h>

#include <nlohmann/json.hpp>

#include <map>
#include <stdexcept>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t alignment = 256;  ///< the strictest that graphics interfaces ask of the parts of a buffer

std::vector<std::byte> bytes_of_text(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// One file of all buffers, one behind the other; what is there already is not put there again.
class Buffers {
 public:
  template <class T>
  Json put(const Shared<T>& values) {
    return {{"offset", place_of(values.stamp(), std::as_bytes(values.view()))}, {"count", values.size()}};
  }

  std::size_t place_of(const Stamp& stamp, std::span<const std::byte> bytes) {
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

Json json_of(const VertexStreams& vertices, Buffers& buffers) {
  const MergedVertexLayout layout = merged_vertex_layout(vertices);
  Json json;
  json["offset"] = buffers.place_of(vertices.stamp(), merged_vertex_bytes(vertices, layout));
  json["count"] = vertices.count;
  json["bytes"] = layout.bytes;
  json["attributes"] = Json::array();
  for (const MergedVertexLayout::Attribute& attribute : layout.attributes) {
    json["attributes"].push_back({{"semantic", attribute.semantic},
                                  {"shader", "merged_" + attribute.name},
                                  {"offset", attribute.offset},
                                  {"stride", attribute.format.bytes},
                                  {"component", text_of(attribute.format.component)},
                                  {"components", attribute.format.components},
                                  {"normalized", attribute.format.normalized}});
  }
  return json;
}

Json json_of(const MergedInstances& set, const Scene& scene, Buffers& buffers) {
  Json json;
  if (set.material) {
    json["material"] = *set.material;
    json["materialName"] = scene.materials[*set.material].name;
  }
  json["vertices"] = json_of(*set.vertices, buffers);
  json["indices"] = buffers.put(set.indices);
  json["slots"] = buffers.put(set.slots);
  json["transforms"] = buffers.put(set.transforms);
  json["places"] = buffers.put(set.places);
  if (!set.materials.empty()) json["materials"] = buffers.put(set.materials);
  json["groups"] = Json::array();
  for (const MergedGroup& group : set.groups) {
    json["groups"].push_back({{"min", {group.least.x, group.least.y, group.least.z}},
                              {"max", {group.most.x, group.most.y, group.most.z}},
                              {"firstInstance", group.first_instance},
                              {"instanceCount", group.instance_count},
                              {"draws", Json::array()}});
  }
  for (const MergedDraw& draw : set.draws) {
    json["groups"][draw.group]["draws"].push_back({{"frequency", draw.frequency},
                                                   {"firstSlot", draw.first_slot},
                                                   {"slotCount", draw.slot_count},
                                                   {"vertexCount", draw.frequency * draw.slot_count}});
  }
  return json;
}

std::vector<OutputFile> description(const Scene& scene, const std::filesystem::path& target) {
  Buffers buffers;
  const std::filesystem::path beside = merged_buffer_beside(target);
  const std::u8string name = beside.filename().u8string();
  Json json{{"foredraw", "merge-instances"}, {"version", 1}, {"buffer", std::string(name.begin(), name.end())}};
  json["sets"] = Json::array();
  for (const MergedInstances& set : scene.merged) json["sets"].push_back(json_of(set, scene, buffers));
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  return {{target, bytes_of_text(text)}, {beside, buffers.take()}};
}

}  // namespace

bool is_merged_output(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".json" || extension == ".glsl" || extension == ".hlsl";
}

std::filesystem::path merged_buffer_beside(const std::filesystem::path& json) {
  std::filesystem::path path = json;
  path += ".bin";
  return path;
}

std::optional<std::vector<OutputFile>> encode_merged(const Scene& scene, const std::filesystem::path& target,
                                                     Diagnostics& diagnostics) {
  if (scene.merged.empty()) {
    diagnostics.error({.file = target.string()}, "nothing-merged", "files of this kind hold merged draws, and nothing of " +
                                                                       scene.name + " is merged",
                      "add the stage merge-instances, and see its notes for why it leaves draws alone");
    return std::nullopt;
  }
  try {
    const std::string extension = lower_extension(target);
    if (extension == ".json") return description(scene, target);
    const ShaderLanguage language = extension == ".hlsl" ? ShaderLanguage::hlsl : ShaderLanguage::glsl;
    return std::vector<OutputFile>{{target, bytes_of_text(merged_shader_text(scene.merged, language))}};
  } catch (const std::length_error& error) {
    diagnostics.error({.file = target.string()}, "too-large", error.what(),
                      "merge in parts, each stage with another only = \"NAMES\"");
    return std::nullopt;
  }
}

}  // namespace foredraw
