// FOREDRAW_merge_instances, read: nothing in it is trusted. It is optional, so what is wrong in it costs it alone.
#include <foredraw/io/gltf/private/merged_instances.h>

#include <foredraw/io/gltf/private/gate.h>
#include <foredraw/io/gltf/private/member.h>
#include <foredraw/io/gltf/private/merged_proof.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace foredraw::gltf {

namespace {

class MergedReader {
 public:
  MergedReader(const Document& document, const Scene& scene) : document_(document), scene_(scene), proof_(scene) {
    for (const Accessor& accessor : document.accessors) most_bytes_ += accessor.bytes();
  }

  std::vector<MergedInstances> merged;

  /// Empty where all of it holds.
  std::string read(const Json& extension) {
    const Json* sets = member(extension, "sets");
    if (sets == nullptr || !sets->is_array()) return "it has no array 'sets'";
    for (std::size_t s = 0; s < sets->size() && mistake_.empty(); ++s) {
      place_ = at("sets", s);
      merged.push_back(set((*sets)[s]));
      if (!mistake_.empty()) break;
      if (auto mistake = mistake_in(merged.back())) wrong(*mistake);
      check_places(merged.back());
      if (!mistake_.empty()) break;
      if (const std::string found = proof_.difference(merged.back()); !found.empty()) wrong(found);
    }
    std::ranges::sort(places_);
    if (mistake_.empty() && std::ranges::adjacent_find(places_) != places_.end()) {
      return "it names a primitive of a node twice";
    }
    return mistake_;
  }

 private:
  void wrong(const std::string& why) {
    if (mistake_.empty()) mistake_ = place_ + " " + why;
  }

  std::uint32_t number(const Json* json, const char* what) {
    const bool fits = json != nullptr && json->is_number_unsigned() && json->get<std::uint64_t>() <= 0xffffffff;
    if (!fits) wrong(fmt::format("must have '{}', a whole number", what));
    return fits ? json->get<std::uint32_t>() : 0;
  }

  const Accessor* accessor(const Json* json, const char* what) {
    const std::uint32_t i = number(json, what);
    if (!mistake_.empty()) return nullptr;
    if (i >= document_.accessors.size() || document_.accessors[i].count == 0) {
      return wrong(fmt::format("has no accessor {} for '{}'", i, what)), nullptr;
    }
    // Bytes may be named again and again; what is looked at may not go on for ever.
    bytes_ += document_.accessors[i].bytes();
    if (bytes_ > most_bytes_) return wrong("names more than the file holds"), nullptr;
    return &document_.accessors[i];
  }

  /// What an accessor of a kind holds, `T` made of one row or of several.
  template <class T>
  Shared<T> read(const Json& json, const char* key, Component component, int components) {
    const Accessor* from = accessor(member(json, key), key);
    if (from == nullptr) return {};
    const std::size_t bytes = from->count * from->format.bytes;
    if (from->format.component != component || from->format.components != components || from->format.normalized ||
        bytes % sizeof(T) != 0) {
      return wrong(fmt::format("has '{}' of another type than it must have", key)), Shared<T>();
    }
    const std::vector<std::byte> plain = elements(document_, *from);
    std::vector<T> values(bytes / sizeof(T));
    std::memcpy(values.data(), plain.data(), bytes);
    return Shared<T>(std::move(values));
  }

  std::shared_ptr<const VertexStreams> vertices(const Json* attributes) {
    if (attributes == nullptr || !attributes->is_object()) return wrong("must have 'attributes'"), nullptr;
    auto& made = vertices_[*attributes];
    if (made) return made;
    VertexStreams streams;
    for (const auto& [semantic, json] : attributes->items()) {
      const Accessor* from = accessor(&json, semantic.c_str());
      if (from == nullptr) return nullptr;
      streams.count = static_cast<std::uint32_t>(std::min<std::size_t>(from->count, 0xffffffff));
      streams.base.push_back({semantic, from->format, Shared<std::byte>(elements(document_, *from))});
    }
    return made = std::make_shared<const VertexStreams>(std::move(streams));
  }

  MergedInstances set(const Json& json) {
    MergedInstances set;
    set.vertices = vertices(member(json, "attributes"));
    if (const Json* material = member(json, "material")) {
      set.material = number(material, "material");
      if (*set.material >= scene_.materials.size()) wrong("names a material that does not exist");
    }
    set.indices = read<std::uint32_t>(json, "indices", Component::uint32, 1);
    set.slots = read<MergedSlot>(json, "slots", Component::uint32, 2);
    set.transforms = read<MergedTransform>(json, "transforms", Component::float32, 4);
    for (const MergedTransform& transform : set.transforms.view()) {
      if (!std::ranges::all_of(transform, [](float element) { return std::isfinite(element); })) {
        wrong("has a transform that is not finite");
      }
    }
    set.places = read<MergedPlace>(json, "places", Component::uint32, 3);
    if (member(json, "materials") != nullptr) {
      set.materials = read<std::uint32_t>(json, "materials", Component::uint32, 1);
      const auto beyond = [&](std::uint32_t id) { return id >= scene_.materials.size(); };
      if (std::ranges::any_of(set.materials.view(), beyond)) wrong("names a material that does not exist");
    }
    add_meshes(json, set);
    const Json* groups = member(json, "groups");
    if (groups == nullptr || !groups->is_array()) return wrong("must have an array 'groups'"), set;
    for (const Json& group : *groups) add_group(group, set);
    return set;
  }

  void add_meshes(const Json& json, MergedInstances& set) {
    const Json* primitives = member(json, "primitives");
    if (primitives == nullptr || !primitives->is_array()) return wrong("must have an array 'primitives'");
    for (const Json& primitive : *primitives) {
      const std::uint32_t m = number(member(primitive, "mesh"), "mesh");
      const std::uint32_t p = number(member(primitive, "primitive"), "primitive");
      const std::uint32_t first = number(member(primitive, "firstVertex"), "firstVertex");
      if (m >= scene_.meshes.size() || p >= scene_.meshes[m].draws.size()) {
        return wrong(fmt::format("names primitive {} of mesh {}, which does not exist", p, m));
      }
      const DrawId draw = scene_.meshes[m].draws[p];
      if (set.vertices && std::uint64_t{first} + scene_.draws[draw].levels[0].vertices->count > set.vertices->count) {
        return wrong(fmt::format("has no room for the vertices of primitive {} of mesh {} from {} on", p, m, first));
      }
      set.meshes.push_back({draw, first});
    }
  }

  void add_group(const Json& json, MergedInstances& set) {
    MergedGroup group;
    const auto corner = [&](const char* key, glm::vec3& to) {
      const Json* values = member(json, key);
      const bool are_three = values != nullptr && values->is_array() && values->size() == 3 &&
                             std::ranges::all_of(*values, [](const Json& value) {
                               return value.is_number() && std::abs(value.get<double>()) <= std::numeric_limits<float>::max();
                             });
      if (!are_three) return wrong(fmt::format("has a group without '{}', three numbers that fit 32-bit floats", key));
      for (int axis = 0; axis < 3; ++axis) to[axis] = (*values)[static_cast<std::size_t>(axis)].get<float>();
    };
    corner("min", group.least);
    corner("max", group.most);
    for (int axis = 0; axis < 3; ++axis) {
      if (group.least[axis] > group.most[axis]) wrong("has a group whose 'min' is above its 'max'");
    }
    group.first_instance = number(member(json, "firstInstance"), "firstInstance");
    group.instance_count = number(member(json, "instanceCount"), "instanceCount");
    const Json* draws = member(json, "draws");
    if (draws == nullptr || !draws->is_array()) return wrong("has a group without an array 'draws'");
    for (const Json& draw : *draws) {
      set.draws.push_back({static_cast<std::uint32_t>(set.groups.size()), number(member(draw, "frequency"), "frequency"),
                           number(member(draw, "firstSlot"), "firstSlot"), number(member(draw, "slotCount"), "slotCount")});
    }
    set.groups.push_back(group);
  }

  void check_places(const MergedInstances& set) {
    for (const MergedPlace& place : set.places.view()) {
      const Node* node = place.node < scene_.nodes.size() ? &scene_.nodes[place.node] : nullptr;
      const bool is_there = node != nullptr && node->mesh && place.primitive < scene_.meshes[*node->mesh].draws.size() &&
                            place.instance < std::max<std::size_t>(1, node->instances.size());
      if (!is_there) return wrong(fmt::format("stands for primitive {} of node {}, which does not exist", place.primitive, place.node));
      places_.push_back(place);
    }
  }

  const Document& document_;
  const Scene& scene_;
  MergedProof proof_;
  std::map<Json, std::shared_ptr<const VertexStreams>> vertices_;
  std::vector<MergedPlace> places_;
  std::uint64_t bytes_ = 0;
  std::uint64_t most_bytes_ = std::uint64_t{16} << 20;  ///< small ones may be named twice
  std::string place_, mistake_;
};

}  // namespace

void read_merged_instances(Document& document, Scene& scene, Diagnostics& diagnostics) {
  const Json* extension = extension_of(document.json, merge_instances);
  if (extension == nullptr) return;
  MergedReader reader(document, scene);
  const std::string mistake = reader.read(*extension);
  if (!mistake.empty()) {
    diagnostics.warning({.file = document.name, .inside = merge_instances}, "merged-draws-left-out",
                        "the merged draws are left out: " + mistake, "merge them again; the nodes show the same");
    document.let_go = used_by_merged(document.json);
    take_extension(document.json, merge_instances);
    unlist_extension(document.json, merge_instances);
    document.left_out = true;
    return;
  }
  scene.merged = std::move(reader.merged);
  for (const MergedPlace& place : merged_places(scene)) {
    scene.draws[scene.meshes[*scene.nodes[place.node].mesh].draws[place.primitive]].traits.add(traits::extended);
  }
}

namespace {

/// Numbers of accessors, whatever else is wrong.
void collect(const Json* json, std::set<std::size_t>& numbers) {
  if (json != nullptr && json->is_number_unsigned()) numbers.insert(json->get<std::size_t>());
}

const Json& sets_of(const Json& json) {
  static const Json none = Json::array();
  const Json* extension = extension_of(json, merge_instances);
  const Json* sets = extension == nullptr ? nullptr : member(*extension, "sets");
  return sets == nullptr || !sets->is_array() ? none : *sets;
}

}  // namespace

std::set<std::size_t> merged_vertex_data(const Json& json) {
  std::set<std::size_t> numbers;
  for (const Json& set : sets_of(json)) {
    const Json* attributes = member(set, "attributes");
    if (attributes == nullptr || !attributes->is_object()) continue;
    for (const Json& number : *attributes) collect(&number, numbers);
  }
  return numbers;
}

std::set<std::size_t> used_by_merged(const Json& json) {
  std::set<std::size_t> numbers = merged_vertex_data(json);
  for (const Json& set : sets_of(json)) {
    for (const char* key : {"indices", "slots", "transforms", "places", "materials"}) collect(member(set, key), numbers);
  }
  return numbers;
}

}  // namespace foredraw::gltf
