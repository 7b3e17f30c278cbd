// The draws of a scene put back into its document: only what differs from what was read is touched.
#include <foredraw/io/gltf/layout/private/accessor_store.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/gltf/private/rows.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

/// A place in a primitive that names an accessor, and what that accessor shall hold.
struct Request {
  std::size_t mesh = 0;
  std::size_t primitive = 0;
  std::optional<std::size_t> target;    ///< a morph target
  std::string semantic;                 ///< empty: the indices
  std::optional<std::size_t> accessor;  ///< that it named so far
  std::optional<Content> content;       ///< none: as it was
  bool is_named_elsewhere = false;      ///< by a product, which asks for the same content
};

std::optional<std::size_t> number_at(const Json& holder, const std::string& key) {
  const auto found = holder.find(key);
  return found == holder.end() ? std::nullopt : std::optional(found->get<std::size_t>());
}

bool is_each_vertex_in_turn(std::span<const std::uint32_t> indices, std::size_t vertices) {
  if (indices.size() != vertices) return false;
  for (std::size_t i = 0; i < vertices; ++i) {
    if (indices[i] != i) return false;
  }
  return true;
}

int list_mode(Topology topology) { return topology == Topology::points ? 0 : topology == Topology::lines ? 1 : 4; }

std::size_t corners_of(Topology topology) {
  return topology == Topology::points ? 1 : topology == Topology::lines ? 2 : 3;
}

/// Whether glTF allows the format only by KHR_mesh_quantization.
bool is_quantized(const std::string& semantic, const Format& format) {
  if (format.component == Component::float32) return false;
  if (semantic == "POSITION" || semantic == "NORMAL" || semantic == "TANGENT") return true;
  const bool is_unsigned = format.component == Component::uint8 || format.component == Component::uint16;
  return semantic.compare(0, 9, "TEXCOORD_") == 0 && !(is_unsigned && format.normalized);
}

class MeshPatch {
 public:
  MeshPatch(const Scene& scene, const Source& source, const ProductRows& rows, Json& json, AccessorStore& store,
            Diagnostics& diagnostics)
      : scene_(scene), source_(source), rows_(rows), json_(json), store_(store), diagnostics_(diagnostics) {}

  bool run() {
    if (scene_.meshes.size() < source_.as_read.meshes.size()) return fail(scene_.name, "meshes were removed");
    primitives_.resize(scene_.meshes.size());
    for (std::size_t m = 0; m < scene_.meshes.size(); ++m) {
      if (!mesh(m)) return false;
    }
    resolve();
    for (std::size_t m = 0; m < primitives_.size(); ++m) {
      Json& made = json_["meshes"][m]["primitives"] = Json::array();
      for (Json& primitive : primitives_[m]) made.push_back(std::move(primitive));
    }
    return true;
  }

 private:
  bool fail(const std::string& what, const std::string& why) {
    diagnostics_.error({.file = source_.document.name, .inside = what}, "cannot-express",
                       why + "; this cannot be written back", "leave out the stage that did it");
    return false;
  }

  bool mesh(std::size_t m) {
    const Mesh& now = scene_.meshes[m];
    if (now.draws.empty()) return fail(now.name, "the mesh has no draw left");
    if (m >= source_.as_read.meshes.size()) {
      Json& made = json_["meshes"][m] = Json::object();
      if (!now.name.empty()) made["name"] = now.name;
      made["primitives"] = Json::array();
      if (!now.weights.empty()) made["weights"] = now.weights;
    } else {
      const Mesh& was = source_.as_read.meshes[m];
      if (now.name != was.name) json_["meshes"][m]["name"] = now.name;
      if (now.weights != was.weights) json_["meshes"][m]["weights"] = now.weights;
    }
    for (DrawId id : now.draws) {
      if (id >= scene_.draws.size()) return fail(now.name, fmt::format("draw {} does not exist", id));
      if (!draw(scene_.draws[id], m)) return false;
    }
    return true;
  }

  const Draw* original(const Draw& draw) const {
    if (!draw.origin || draw.origin->mesh >= source_.as_read.meshes.size()) return nullptr;
    const Mesh& mesh = source_.as_read.meshes[draw.origin->mesh];
    return draw.origin->primitive < mesh.draws.size() ? &source_.as_read.draws[mesh.draws[draw.origin->primitive]]
                                                      : nullptr;
  }

  bool draw(const Draw& now, std::size_t m) {
    if (now.levels.empty() || now.full().orders.empty() || !now.full().vertices) {
      return fail(now.name, "the draw has neither vertices nor triangles");
    }
    const Draw* was = original(now);
    mesh_ = m;
    primitive_ = primitives_[m].size();
    primitives_[m].push_back(
        was == nullptr ? Json::object()
                       : source_.document.json["meshes"][now.origin->mesh]["primitives"][now.origin->primitive]);
    Json& json = primitives_[m].back();
    if (was == nullptr) json["attributes"] = Json::object();
    if (!vertices(now, was, json)) return false;
    corners(now, was, json);
    further_orders(now, was, json);
    const std::optional<MaterialId> old_material = was == nullptr ? std::nullopt : was->material;
    if (now.material != old_material && now.material) json["material"] = *now.material;
    if (now.material != old_material && !now.material) json.erase("material");
    return true;
  }

  bool vertices(const Draw& now, const Draw* was, Json& json) {
    const VertexStreams& streams = *now.full().vertices;
    const VertexStreams* old = was == nullptr ? nullptr : was->full().vertices.get();
    const bool had_none = old != nullptr && old->find("POSITION") == nullptr;
    if ((streams.find("POSITION") == nullptr && !had_none) || streams.count == 0) {
      return fail(now.name, "the draw has no positions");
    }
    const auto one = [&](const std::vector<VertexStream>& list, const std::vector<VertexStream>* old_list, Json& names,
                         std::optional<std::size_t> target) {
      for (const VertexStream& stream : list) {
        if (stream.count() != streams.count) {
          return fail(now.name, fmt::format("{} has {} elements for {} vertices", stream.semantic, stream.count(),
                                            streams.count));
        }
        const VertexStream* before = nullptr;
        for (std::size_t i = 0; old_list != nullptr && i < old_list->size(); ++i) {
          if ((*old_list)[i].semantic == stream.semantic) before = &(*old_list)[i];
        }
        const bool same = before != nullptr && before->format == stream.format && before->bytes == stream.bytes;
        Request request{mesh_, primitive_, target, stream.semantic, number_at(names, stream.semantic), std::nullopt};
        if (!same && is_quantized(stream.semantic, stream.format)) {
          for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
            list_extension(json_, list, "KHR_mesh_quantization");
          }
        }
        if (!same) {
          request.content = Content{Content::Kind::vertices, stream.format, streams.count, stream.bytes,
                                    stream.semantic == "POSITION"};
        }
        requests_.push_back(std::move(request));
      }
      std::vector<std::string> gone;
      for (const auto& [semantic, number] : names.items()) {
        const std::string& name = semantic;  // clang 14 captures no structured binding
        if (std::none_of(list.begin(), list.end(), [&](const auto& s) { return s.semantic == name; }))
          gone.push_back(name);
      }
      for (const std::string& semantic : gone) names.erase(semantic);
      return true;
    };
    if (!one(streams.base, old == nullptr ? nullptr : &old->base, json["attributes"], std::nullopt)) return false;
    if (streams.morph_targets.empty()) {
      json.erase("targets");
      return true;
    }
    Json& targets = json["targets"];
    if (!targets.is_array()) targets = Json::array();
    while (targets.size() > streams.morph_targets.size()) targets.erase(targets.size() - 1);
    while (targets.size() < streams.morph_targets.size()) targets.push_back(Json::object());
    for (std::size_t t = 0; t < streams.morph_targets.size(); ++t) {
      const bool known = old != nullptr && t < old->morph_targets.size();
      if (!one(streams.morph_targets[t], known ? &old->morph_targets[t] : nullptr, targets[t], t)) return false;
    }
    return true;
  }

  /// Indices and mode. Strips, fans and unindexed draws stay what they were until their triangles change.
  void corners(const Draw& now, const Draw* was, Json& json) {
    Shared<std::uint32_t> indices = now.full().stream().indices;
    const std::size_t count = now.full().vertices->count;
    // What has several orders is a plain list, so that all of them are.
    const bool is_one_of_several = now.full().orders.size() > 1;
    const bool is_list = json.contains("indices") && json.value("mode", 4) == list_mode(now.topology);
    const bool same = was != nullptr && was->topology == now.topology && indices == was->full().stream().indices &&
                      (is_list || !is_one_of_several);
    // glTF has no empty primitive: one that covers nothing stands for it.
    if (indices.empty()) indices = Shared<std::uint32_t>(std::vector<std::uint32_t>(corners_of(now.topology), 0));

    Request request{mesh_, primitive_, std::nullopt, {}, number_at(json, "indices"), std::nullopt};
    const bool same_vertices = same && was->full().vertices->count == count;
    // Corners left over, which no draw holds, may name vertices that are no longer there.
    const int old_mode = json.value("mode", 4);
    const bool left_over = request.accessor && (old_mode == 1 || old_mode == 4) && was != nullptr &&
                           was->full().vertices != now.full().vertices &&
                           source_.document.accessors[*request.accessor].count != indices.size();
    if (request.accessor ? same && !left_over : same_vertices) {
      if (request.accessor) requests_.push_back(std::move(request));
      return;
    }
    const int mode = list_mode(now.topology);
    if (json.value("mode", 4) != mode) json["mode"] = mode;
    if (!request.accessor && !is_one_of_several && is_each_vertex_in_turn(indices.view(), count)) return;
    Component component = Component::uint16;
    if (request.accessor) component = source_.document.accessors[*request.accessor].format.component;
    request.content = index_content(indices.view(), component);
    requests_.push_back(std::move(request));
  }

  /// Orders that a draw did not have stand behind its other accessors; a product names them.
  void further_orders(const Draw& now, const Draw* was, Json& json) {
    const std::vector<IndexStream>& orders = now.full().orders;
    if (orders.size() == 1 || scene_.products.empty()) return;
    json["extensions"];
    if (was != nullptr && was->full().orders.size() > 1) return;
    for (std::size_t order = 1; order < orders.size(); ++order) {
      Request request{mesh_, primitive_, std::nullopt, {}, std::nullopt, std::nullopt, true};
      request.content = index_content(never_empty(orders[order].indices.view()), Component::uint16);
      requests_.push_back(std::move(request));
    }
  }

  /// An accessor that everybody wants to hold the same takes it on in place; where wishes differ, new ones are added.
  void resolve() {
    std::set<std::size_t> elsewhere = used_elsewhere(source_.document);
    elsewhere.merge(used_by_products(source_.document.json, rows_));
    std::map<std::size_t, std::vector<const Request*>> wishes;
    for (const Request& request : requests_) {
      if (request.accessor) wishes[*request.accessor].push_back(&request);
    }
    for (std::size_t accessor : used_by_primitives(source_.document.json)) {
      if (!wishes.contains(accessor) && !elsewhere.contains(accessor)) store_.release(accessor);
    }
    std::map<std::size_t, const Content*> taken;
    for (const auto& [accessor, by] : wishes) {
      const bool stays =
          elsewhere.contains(accessor) || std::any_of(by.begin(), by.end(), [](auto* r) { return !r->content; });
      if (stays) continue;
      store_.redefine(accessor, *by.front()->content);
      taken[accessor] = &*by.front()->content;
    }
    for (const Request& request : requests_) {
      if (!request.content) continue;
      const Content& content = *request.content;
      if (request.accessor && taken.contains(*request.accessor) && same_content(*taken[*request.accessor], content))
        continue;
      const std::size_t number = store_.append(content, request.accessor);
      if (request.is_named_elsewhere) continue;
      Json& json = primitives_[request.mesh][request.primitive];
      if (request.semantic.empty()) {
        json["indices"] = number;
      } else {
        (request.target ? json["targets"][*request.target] : json["attributes"])[request.semantic] = number;
      }
    }
  }

  const Scene& scene_;
  const Source& source_;
  const ProductRows& rows_;
  Json& json_;
  AccessorStore& store_;
  Diagnostics& diagnostics_;
  std::vector<Json::array_t> primitives_;
  std::vector<Request> requests_;
  std::size_t mesh_ = 0;
  std::size_t primitive_ = 0;
};

}  // namespace

Content index_content(std::span<const std::uint32_t> indices, Component was) {
  const std::uint32_t most = greatest(std::as_bytes(indices), 4);
  Component component = was;
  if (component == Component::uint8 && most >= 0xff) component = Component::uint16;
  if (component == Component::uint16 && most >= 0xffff) component = Component::uint32;
  const std::size_t width = foredraw::bytes_of(component);
  return {Content::Kind::indices,
          {component, 1, false, static_cast<std::uint16_t>(width)},
          indices.size(),
          Shared<std::byte>(narrowed(indices, width)),
          false};
}

std::span<const std::uint32_t> never_empty(std::span<const std::uint32_t> triangles) {
  static constexpr std::uint32_t nothing[3] = {};
  return triangles.empty() ? std::span(nothing) : triangles;
}

bool patch_meshes(const Scene& scene, const Source& source, const ProductRows& rows, Json& json, AccessorStore& store,
                  Diagnostics& diagnostics) {
  return MeshPatch(scene, source, rows, json, store, diagnostics).run();
}

}  // namespace foredraw::gltf
