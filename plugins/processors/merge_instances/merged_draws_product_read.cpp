// FOREDRAW_merge_instances, read.
#include "merged_draws_product.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw::processors::merge_instances {

namespace {

class Reader {
 public:
  Reader(ExtensionReader& from, const Scene& scene)
      : from_(from), scene_(scene), most_bytes_((std::uint64_t{16} << 20) + from.bytes()) {}

  std::variant<MergedDraws, std::string> read() {
    const ExtensionValue* extension = from_.of_file();
    const ExtensionValue::List* sets = extension == nullptr ? nullptr : list(*extension, "sets");
    if (sets == nullptr) return "it has no array 'sets'";
    MergedDraws merged;
    for (std::size_t s = 0; s < sets->size() && mistake_.empty(); ++s) {
      place_ = fmt::format("sets[{}]", s);
      merged.sets.push_back(set((*sets)[s]));
      if (!mistake_.empty()) break;
      if (const auto mistake = mistake_in(merged.sets.back())) wrong(*mistake);
      check_places(merged.sets.back());
    }
    std::ranges::sort(places_);
    if (mistake_.empty() && std::ranges::adjacent_find(places_) != places_.end()) {
      return "it names the same primitive of a node twice";
    }
    if (!mistake_.empty()) return mistake_;
    return merged;
  }

 private:
  using NamedAccessors = std::vector<std::pair<std::string, std::uint32_t>>;

  void wrong(const std::string& why) {
    if (mistake_.empty()) mistake_ = place_ + " " + why;
  }

  static const ExtensionValue::List* list(const ExtensionValue& value, std::string_view name) {
    const ExtensionValue* held = value.member(name);
    return held == nullptr ? nullptr : held->list();
  }

  std::uint32_t number(const ExtensionValue& holder, std::string_view name) {
    return number(holder.member(name), name);
  }
  std::uint32_t number(const ExtensionValue* value, std::string_view name) {
    const auto whole = value == nullptr ? std::nullopt : value->whole();
    if (!whole) wrong(fmt::format("must have '{}', a whole number", name));
    return whole.value_or(0);
  }

  std::optional<AccessorData> accessor(const ExtensionValue* value, std::string_view name) {
    const std::uint32_t i = number(value, name);
    if (!mistake_.empty()) return std::nullopt;
    auto data = from_.accessor(i);
    if (!data) return wrong(fmt::format("names accessor {} for '{}', which does not exist", i, name)), std::nullopt;
    // Bytes may be named again and again; what is looked at may not go on for ever.
    bytes_ += data->bytes.size();
    if (bytes_ > most_bytes_) return wrong("names the same bytes too often"), std::nullopt;
    return data;
  }

  /// What an accessor of a kind holds, `T` made of one row or of several.
  template <class T>
  Shared<T> values(const ExtensionValue& holder, std::string_view name, Component component, int components) {
    const auto from = accessor(holder.member(name), name);
    if (!from) return {};
    const auto bytes = from->bytes.view();
    if (from->format.component != component || from->format.components != components || from->format.normalized ||
        bytes.size() % sizeof(T) != 0) {
      return wrong(fmt::format("has the wrong accessor type for '{}'", name)), Shared<T>();
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return Shared<T>(std::move(values));
  }

  /// Sets of equal attributes share them.
  std::shared_ptr<const VertexStreams> vertices(const ExtensionValue* attributes) {
    if (attributes == nullptr || attributes->members() == nullptr) return wrong("must have 'attributes'"), nullptr;
    NamedAccessors named;
    for (const auto& [semantic, value] : *attributes->members()) named.emplace_back(semantic, number(&value, semantic));
    for (const auto& [names, made] : vertices_) {
      if (names == named) return made;
    }
    VertexStreams streams;
    for (const auto& [semantic, value] : *attributes->members()) {
      const auto from = accessor(&value, semantic);
      if (!from) return nullptr;
      streams.count = static_cast<std::uint32_t>(std::min<std::size_t>(from->count, 0xffffffff));
      streams.base.push_back({semantic, from->format, from->bytes});
    }
    return vertices_.emplace_back(std::move(named), std::make_shared<const VertexStreams>(std::move(streams))).second;
  }

  MergedInstances set(const ExtensionValue& value) {
    MergedInstances set;
    set.vertices = vertices(value.member("attributes"));
    if (value.member("material") != nullptr) {
      set.material = number(value, "material");
      if (*set.material >= scene_.materials.size()) wrong("names a material that does not exist");
    }
    set.indices = values<std::uint32_t>(value, "indices", Component::uint32, 1);
    set.slots = values<MergedSlot>(value, "slots", Component::uint32, 2);
    set.transforms = values<MergedTransform>(value, "transforms", Component::float32, 4);
    for (const MergedTransform& transform : set.transforms.view()) {
      if (!std::ranges::all_of(transform, [](float element) { return std::isfinite(element); })) {
        wrong("has a transform that is not finite");
      }
    }
    set.places = values<MergedPlace>(value, "places", Component::uint32, 3);
    if (value.member("materials") != nullptr) {
      set.materials = values<std::uint32_t>(value, "materials", Component::uint32, 1);
      const auto beyond = [&](std::uint32_t id) { return id >= scene_.materials.size(); };
      if (std::ranges::any_of(set.materials.view(), beyond)) wrong("names a material that does not exist");
    }
    add_meshes(value, set);
    const ExtensionValue::List* groups = list(value, "groups");
    if (groups == nullptr) return wrong("must have an array 'groups'"), set;
    for (const ExtensionValue& group : *groups) add_group(group, set);
    return set;
  }

  void add_meshes(const ExtensionValue& value, MergedInstances& set) {
    const ExtensionValue::List* primitives = list(value, "primitives");
    if (primitives == nullptr) return wrong("must have an array 'primitives'");
    for (const ExtensionValue& primitive : *primitives) {
      const std::uint32_t m = number(primitive, "mesh");
      const std::uint32_t p = number(primitive, "primitive");
      const std::uint32_t first = number(primitive, "firstVertex");
      if (m >= scene_.meshes.size() || p >= scene_.meshes[m].draws.size()) {
        return wrong(fmt::format("names primitive {} of mesh {}, which does not exist", p, m));
      }
      const DrawId draw = scene_.meshes[m].draws[p];
      if (set.vertices && std::uint64_t{first} + scene_.draws[draw].levels[0].vertices->count > set.vertices->count) {
        return wrong(fmt::format("has too few vertices for primitive {} of mesh {} at firstVertex {}", p, m, first));
      }
      set.meshes.push_back({draw, first});
    }
  }

  void corner(const ExtensionValue& group, std::string_view name, glm::vec3& to) {
    const ExtensionValue::List* values = list(group, name);
    const bool are_three =
        values != nullptr && values->size() == 3 && std::ranges::all_of(*values, [](const ExtensionValue& value) {
          return value.number() && std::abs(*value.number()) <= std::numeric_limits<float>::max();
        });
    if (!are_three) return wrong(fmt::format("has a group without '{}', three numbers that fit 32-bit floats", name));
    for (int axis = 0; axis < 3; ++axis) {
      to[axis] = static_cast<float>(*(*values)[static_cast<std::size_t>(axis)].number());
    }
  }

  void add_group(const ExtensionValue& value, MergedInstances& set) {
    MergedGroup group;
    corner(value, "min", group.least);
    corner(value, "max", group.most);
    for (int axis = 0; axis < 3; ++axis) {
      if (group.least[axis] > group.most[axis]) wrong("has a group whose 'min' is above its 'max'");
    }
    group.first_instance = number(value, "firstInstance");
    group.instance_count = number(value, "instanceCount");
    const ExtensionValue::List* draws = list(value, "draws");
    if (draws == nullptr) return wrong("has a group without an array 'draws'");
    for (const ExtensionValue& draw : *draws) {
      set.draws.push_back({static_cast<std::uint32_t>(set.groups.size()), number(draw, "frequency"),
                           number(draw, "firstSlot"), number(draw, "slotCount")});
    }
    set.groups.push_back(group);
  }

  void check_places(const MergedInstances& set) {
    for (const MergedPlace& place : set.places.view()) {
      const Node* node = place.node < scene_.nodes.size() ? &scene_.nodes[place.node] : nullptr;
      const bool is_there = node != nullptr && node->mesh &&
                            place.primitive < scene_.meshes[*node->mesh].draws.size() &&
                            place.instance < std::max<std::size_t>(1, node->instances.size());
      if (!is_there)
        return wrong(
            fmt::format("stands for primitive {} of node {}, which does not exist", place.primitive, place.node));
      places_.push_back(place);
    }
  }

  ExtensionReader& from_;
  const Scene& scene_;
  std::uint64_t bytes_ = 0, most_bytes_;  ///< small ones may be named twice
  std::vector<std::pair<NamedAccessors, std::shared_ptr<const VertexStreams>>> vertices_;
  std::vector<MergedPlace> places_;
  std::string place_, mistake_;
};

}  // namespace

std::variant<MergedDraws, std::string> read_merged_draws(ExtensionReader& from, const Scene& scene) {
  return Reader(from, scene).read();
}

}  // namespace foredraw::processors::merge_instances
