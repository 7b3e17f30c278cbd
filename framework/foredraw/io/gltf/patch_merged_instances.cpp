// FOREDRAW_merge_instances, written.
#include <foredraw/io/gltf/private/draw_orders.h>
#include <foredraw/io/gltf/private/merged_instances.h>
#include <foredraw/io/gltf/private/write.h>

#include <algorithm>
#include <map>

namespace foredraw::gltf {

namespace {

template <class T>
std::size_t append(AccessorStore& store, const Shared<T>& values, Component component, std::uint8_t components) {
  const Bytes bytes = std::as_bytes(values.view());
  const auto row = static_cast<std::uint16_t>(components * bytes_of(component));
  return store.append({Content::Kind::other, {component, components, false, row}, bytes.size() / row,
                       Shared<std::byte>({bytes.begin(), bytes.end()})});
}

Json attributes_of(const VertexStreams& vertices, AccessorStore& store) {
  Json attributes = Json::object();
  for (const VertexStream& stream : vertices.base) {
    attributes[stream.semantic] = store.append(
        {Content::Kind::vertices, stream.format, vertices.count, stream.bytes, stream.semantic == "POSITION"});
  }
  return attributes;
}

Json groups_of(const MergedInstances& set) {
  Json groups = Json::array();
  for (const MergedGroup& group : set.groups) {
    groups.push_back({{"min", {group.least.x, group.least.y, group.least.z}},
                      {"max", {group.most.x, group.most.y, group.most.z}},
                      {"firstInstance", group.first_instance},
                      {"instanceCount", group.instance_count},
                      {"draws", Json::array()}});
  }
  for (const MergedDraw& draw : set.draws) {
    groups[draw.group]["draws"].push_back(
        {{"frequency", draw.frequency}, {"firstSlot", draw.first_slot}, {"slotCount", draw.slot_count}});
  }
  return groups;
}

Json json_of(const MergedInstances& set, AccessorStore& store) {
  Json json = Json::object();
  if (set.material) json["material"] = *set.material;
  json["attributes"] = attributes_of(*set.vertices, store);
  json["indices"] = append(store, set.indices, Component::uint32, 1);
  json["slots"] = append(store, set.slots, Component::uint32, 2);
  json["transforms"] = append(store, set.transforms, Component::float32, 4);
  json["places"] = append(store, set.places, Component::uint32, 3);
  if (!set.materials.empty()) json["materials"] = append(store, set.materials, Component::uint32, 1);
  json["groups"] = groups_of(set);
  return json;
}

/// Each mesh's primitives, and where their vertices begin. With `may_move` an accessor of theirs becomes a part of the
/// merged one.
Json primitives_of(const Scene& scene, const MergedInstances& set, const Json& attributes, const Json& json, bool may_move,
                   AccessorStore& store) {
  std::map<DrawId, std::uint32_t> first_vertex;
  for (const MergedMesh& mesh : set.meshes) first_vertex.emplace(mesh.draw, mesh.first_vertex);
  Json list = Json::array();
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    for (std::size_t p = 0; p < scene.meshes[m].draws.size(); ++p) {
      const auto first = first_vertex.find(scene.meshes[m].draws[p]);
      if (first == first_vertex.end()) continue;
      list.push_back({{"mesh", m}, {"primitive", p}, {"firstVertex", first->second}});
      for (const auto& [semantic, number] : json["meshes"][m]["primitives"][p]["attributes"].items()) {
        const auto merged = attributes.find(semantic);
        if (!may_move || merged == attributes.end()) continue;
        store.lay_within(number.get<std::size_t>(), merged->get<std::size_t>(), first->second);
      }
    }
  }
  return list;
}

}  // namespace

void patch_merged_instances(const Scene& scene, const Source& source, Json& json, AccessorStore& store) {
  const Document& document = source.document;
  const bool stay = scene.merged == source.as_read.merged;
  std::set<std::size_t> gone = document.let_go;
  if (!stay) gone.merge(used_by_merged(document.json));
  if (!gone.empty()) {
    std::set<std::size_t> others = used_elsewhere(document.json);
    others.merge(used_by_primitives(document.json));
    others.merge(used_by_tables(document.json));
    for (const std::size_t accessor : gone) {
      const bool is_there = accessor < document.accessors.size() && document.accessors[accessor].count > 0;
      if (is_there && !others.contains(accessor)) store.release(accessor);
    }
  }
  if (stay) return;
  const bool may_move = knows_all_extensions(document.json);
  Json sets = Json::array();
  for (const MergedInstances& set : scene.merged) {
    Json made = json_of(set, store);
    made["primitives"] = primitives_of(scene, set, made["attributes"], json, may_move, store);
    sets.push_back(std::move(made));
  }
  take_extension(json, merge_instances);
  if (sets.empty()) return unlist_extension(json, merge_instances);
  json["extensions"][merge_instances]["sets"] = std::move(sets);
  Json& used = json["extensionsUsed"];
  if (std::ranges::find(used, Json(merge_instances)) == used.end()) used.push_back(merge_instances);
}

}  // namespace foredraw::gltf
