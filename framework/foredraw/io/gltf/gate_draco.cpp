// Primitives that are compressed by Draco (KHR_draco_mesh_compression). Their buffers are decoded on the way, and what
// follows sees accessors with bytes, and no trace of the extension. What accessors and buffers claim is held against
// each other, and against the bytes that there are.
#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/private/decoded_views.h>
#include <foredraw/io/gltf/private/draco.h>
#include <foredraw/io/gltf/private/gate.h>
#include <foredraw/io/gltf/private/rows.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace foredraw::gltf {

namespace {

constexpr const char* export_again = "export the file again; it was damaged on its way, or its exporter is wrong";

/// One of Draco's buffers, whichever primitives it is for.
struct DracoBuffer {
  std::size_t view = 0;
  std::string place;  ///< of the first primitive's extension
  DracoClaim claim;
  std::variant<DracoMesh, DracoFault> held;
};

/// A primitive that is drawn from one.
struct DracoUse {
  struct Attribute {
    std::size_t accessor = 0;
    std::string semantic;
    std::size_t claimed = 0;  ///< number in the claim
  };
  std::size_t mesh = 0, primitive = 0;
  std::string place;
  std::size_t buffer = 0;
  std::size_t indices = 0;                ///< accessor
  std::size_t index_bytes = 0;            ///< of one, in that accessor
  std::size_t points = 0, triangles = 0;  ///< that the accessors claim
  bool is_strip = false;
  std::vector<Attribute> attributes;
};

class DracoCheck {
 public:
  explicit DracoCheck(Gate& gate) : gate_(gate), json_(gate.document().json) {}

  bool run(const Executor& executor) {
    const bool is_used = find_uses();
    if (!gate_.sound()) return !is_used;
    if (is_used && is_affordable()) {
      executor.for_each(buffers_.size(), [&](std::size_t i) {
        buffers_[i].held = draco_decoded(gate_.document().views[buffers_[i].view].bytes, buffers_[i].claim);
      });
      if (all_decoded()) put();
    }
    unlist_extension(json_, draco_extension);
    return gate_.sound();
  }

 private:
  /// Whether a primitive has the extension.
  bool find_uses() {
    bool is_used = false;
    for (std::size_t m = 0; m < gate_.count("meshes"); ++m) {
      const auto primitives = gate_.all("meshes")[m].find("primitives");
      if (primitives == gate_.all("meshes")[m].end() || !primitives->is_array()) continue;
      for (std::size_t p = 0; p < primitives->size(); ++p) {
        const Json& primitive = (*primitives)[p];
        if (!primitive.is_object() || extension_of(primitive, draco_extension) == nullptr) continue;
        is_used = true;
        const std::string place = at(in(at("meshes", m), "primitives"), p);
        DracoUse use{.mesh = m, .primitive = p, .place = in(in(place, "extensions"), draco_extension)};
        if (find_use(primitive, place, use)) uses_.push_back(std::move(use));
      }
    }
    return is_used;
  }

  /// False, with an error, where something is wrong.
  bool find_use(const Json& primitive, const std::string& place, DracoUse& use) {
    const Json* extension = gate_.object(primitive["extensions"], draco_extension, in(place, "extensions"));
    if (extension == nullptr) return false;
    for (const char* key : {"bufferView", "attributes"}) gate_.required(*extension, key, use.place);
    for (const char* key : {"indices", "attributes"}) gate_.required(primitive, key, place);
    const auto view = gate_.reference(*extension, "bufferView", "bufferViews", use.place);
    const Json* ids = gate_.object(*extension, "attributes", use.place);
    const Json* attributes = gate_.object(primitive, "attributes", place);
    if (gate_.view(view) == nullptr || ids == nullptr || attributes == nullptr || !primitive.contains("indices"))
      return false;
    DracoClaim claim;
    if (!claim_triangles(primitive, place, use, claim)) return false;
    if (!claim_attributes(*ids, *attributes, place, use, claim)) return false;
    use.points = claim.points;
    use.triangles = claim.triangles;
    join(*view, use, std::move(claim));
    return true;
  }

  bool claim_triangles(const Json& primitive, const std::string& place, DracoUse& use, DracoClaim& claim) {
    const auto mode = primitive.find("mode");
    const bool strip = mode != primitive.end() && *mode == 5;
    if (mode != primitive.end() && *mode != 4 && !strip) {
      gate_.error(in(place, "mode"), "out-of-range",
                  fmt::format("is {}, but Draco compresses triangles: expected 4 or 5", mode->dump()));
      return false;
    }
    const auto accessor = claimed(primitive["indices"], in(place, "indices"));
    if (!accessor) return false;
    const Component component = accessor->format.component;
    const bool is_unsigned =
        component == Component::uint8 || component == Component::uint16 || component == Component::uint32;
    if (accessor->format.components != 1 || !is_unsigned) {
      gate_.error(in(place, "indices"), "index-type",
                  fmt::format("accessor {} must be SCALAR of unsigned 8-, 16- or 32-bit integers", accessor->number));
      return false;
    }
    use.indices = accessor->number;
    use.index_bytes = accessor->format.bytes;
    // A strip is unpacked as a list, which has two corners less than triangles at most.
    use.is_strip = strip;
    claim.triangles = strip ? std::max<std::size_t>(accessor->count, 2) - 2 : accessor->count / 3;
    return true;
  }

  bool claim_attributes(const Json& ids, const Json& attributes, const std::string& primitive, DracoUse& use,
                        DracoClaim& claim) {
    const std::string place = in(use.place, "attributes");
    if (ids.empty()) gate_.error(place, "out-of-range", "must not be empty");
    for (const auto& [semantic, value] : ids.items()) {
      const auto id = gate_.whole(ids, semantic.c_str(), place, 0, std::numeric_limits<std::uint32_t>::max());
      const auto number = attributes.find(semantic);
      if (number == attributes.end()) {
        gate_.error(in(place, semantic), "compressed-attribute",
                    fmt::format("the primitive's own attributes lack {}", semantic));
        return false;
      }
      const auto accessor = claimed(*number, in(in(primitive, "attributes"), semantic));
      if (!id || !accessor) return false;
      if (claim.attributes.empty()) claim.points = accessor->count;
      if (accessor->count != claim.points) {
        gate_.error(in(in(primitive, "attributes"), semantic), "unequal-counts",
                    fmt::format("accessor {} has {} elements, but the primitive's others have {}", accessor->number,
                                accessor->count, claim.points));
        return false;
      }
      use.attributes.push_back({accessor->number, semantic, claim.attributes.size()});
      claim.attributes.push_back({static_cast<std::uint32_t>(*id), accessor->format});
    }
    return !ids.empty();
  }

  /// To the other primitives of the same buffer.
  void join(std::size_t view, DracoUse& use, DracoClaim claim) {
    const auto [known, is_new] = buffer_of_view_.try_emplace(view, buffers_.size());
    use.buffer = known->second;
    if (is_new) {
      buffers_.push_back({view, use.place, std::move(claim), {}});
      return;
    }
    DracoClaim& all = buffers_[use.buffer].claim;
    all.points = std::max(all.points, claim.points);
    all.triangles = std::max(all.triangles, claim.triangles);
    for (DracoUse::Attribute& attribute : use.attributes) {
      const DracoClaim::Attribute& wanted = claim.attributes[attribute.claimed];
      const auto same = std::find_if(all.attributes.begin(), all.attributes.end(), [&](const auto& one) {
        return one.id == wanted.id && one.format.component == wanted.format.component &&
               one.format.components == wanted.format.components;
      });
      attribute.claimed = static_cast<std::size_t>(same - all.attributes.begin());
      if (same == all.attributes.end()) all.attributes.push_back(wanted);
    }
  }

  struct Claimed {
    std::size_t number = 0;
    Format format;
    std::size_t count = 0;
  };

  /// What an accessor claims to hold.
  std::optional<Claimed> claimed(const Json& number, const std::string& place) {
    const auto accessor = gate_.reference(number, "accessors", place);
    if (!accessor) return std::nullopt;
    const Json& json = gate_.all("accessors")[*accessor];
    const std::string inside = at("accessors", *accessor);
    for (const char* key : {"componentType", "count", "type"}) gate_.required(json, key, inside);
    const auto component = gate_.whole(json, "componentType", inside);
    const auto type = gate_.text(json, "type", inside);
    const auto count = gate_.whole(json, "count", inside, 1, std::numeric_limits<std::uint32_t>::max());
    if (!component || !type || !count) return std::nullopt;
    if (const auto format = format_of(*type, *component, false))
      return Claimed{*accessor, *format, static_cast<std::size_t>(*count)};
    gate_.error(inside, "accessor-type", fmt::format("glTF has no type '{}' of component type {}", *type, *component));
    return std::nullopt;
  }

  bool is_affordable() {
    const std::uint64_t most = most_claimed(gate_, 256);
    std::uint64_t claimed = 0;
    for (const DracoBuffer& buffer : buffers_) {
      claimed += buffer.claim.bytes();
      if (claimed <= most) continue;
      gate_.error(
          buffer.place, "compressed-count",
          fmt::format("the accessors up to these claim {} bytes, which no so small a file holds", counted(claimed)),
          export_again);
      return false;
    }
    return true;
  }

  bool all_decoded() {
    bool all = true;
    for (const DracoBuffer& buffer : buffers_) {
      const auto* fault = std::get_if<DracoFault>(&buffer.held);
      if (fault == nullptr) continue;
      gate_.error(buffer.place, fault->code, fault->message, export_again);
      all = false;
    }
    return all;
  }

  void put() {
    Document& document = gate_.document();
    DecodedViews views(document.views.size());
    for (const DracoBuffer& buffer : buffers_) {
      for (const DracoClaim::Attribute& attribute : buffer.claim.attributes)
        views.expect_vertices(std::get<DracoMesh>(buffer.held).points, attribute.format.bytes);
    }
    for (const DracoUse& use : uses_) {
      const DracoMesh& mesh = std::get<DracoMesh>(buffers_[use.buffer].held);
      if (use.points != mesh.points || (!use.is_strip && use.triangles != mesh.indices.size() / 3)) tell_odd(use, mesh);
      Json& primitive = json_["meshes"][use.mesh]["primitives"][use.primitive];
      const std::size_t width = std::max(use.index_bytes, index_bytes_for(mesh.indices));
      const auto [indices, new_indices] = indices_lie_.try_emplace({use.buffer, width});
      if (new_indices) indices->second = views.add_indices(narrowed(mesh.indices, width));
      primitive["indices"] = placed(use.indices, indices->second, mesh.indices.size());
      if (width != use.index_bytes)
        json_["accessors"][primitive["indices"].get<std::size_t>()]["componentType"] = width == 2 ? 5123 : 5125;
      if (primitive.contains("mode")) primitive["mode"] = 4;
      take_extension(primitive, draco_extension);
      for (const DracoUse::Attribute& attribute : use.attributes) {
        const auto [lies, is_new] = attributes_lie_.try_emplace({use.buffer, attribute.claimed});
        if (is_new) {
          lies->second = views.add_vertices(mesh.attributes[attribute.claimed],
                                            buffers_[use.buffer].claim.attributes[attribute.claimed].format.bytes);
        }
        primitive["attributes"][attribute.semantic] = placed(attribute.accessor, lies->second, mesh.points);
      }
    }
    FromDraco& told = document.from_draco.emplace();
    for (const DracoBuffer& buffer : buffers_) {
      told.views.insert(buffer.view);
      told.coded += document.views[buffer.view].length;
    }
    told.accessors = std::move(filled_);
    told.copies = std::move(copies_);
    told.plain = std::move(views).put(document, document.views[buffers_.front().view].buffer);
  }

  /// What the buffer holds is read, whatever its accessors say; a file is mostly all of one exporter.
  void tell_odd(const DracoUse& use, const DracoMesh& mesh) {
    if (std::exchange(is_odd_, true)) return;
    gate_.warning(
        use.place, "compressed-count",
        fmt::format("the accessors claim {} vertices and {} triangles, but the Draco buffer holds {} and {}; it is "
                    "believed, here and wherever else they differ",
                    use.points, use.triangles, mesh.points, mesh.indices.size() / 3));
  }

  /// So that the greatest number of the type stays free, as glTF wants.
  static std::size_t index_bytes_for(const std::vector<std::uint32_t>& indices) {
    const std::uint32_t greatest = *std::max_element(indices.begin(), indices.end());
    return greatest < 0xff ? 1 : greatest < 0xffff ? 2 : 4;
  }

  /// The accessor with its elements there: itself, or, where it has others already, a new one like it.
  std::size_t placed(std::size_t accessor, const Lies& lies, std::size_t count) {
    const auto [known, is_new] = placed_.try_emplace({accessor, lies}, accessor);
    if (!is_new) return known->second;
    const bool has_plain_copy =
        json_["accessors"][accessor].contains("bufferView") || json_["accessors"][accessor].contains("sparse");
    if (has_plain_copy) copies_.insert(accessor);
    if (has_plain_copy || filled_.contains(accessor)) {
      known->second = json_["accessors"].size();
      Json like = json_["accessors"][accessor];
      json_["accessors"].push_back(std::move(like));
    }
    filled_.insert(known->second);
    Json& json = json_["accessors"][known->second];
    json["count"] = count;
    json["bufferView"] = lies.view;
    for (const char* key : {"byteOffset", "sparse"}) json.erase(key);
    if (lies.offset != 0) json["byteOffset"] = lies.offset;
    return known->second;
  }

  Gate& gate_;
  Json& json_;
  std::vector<DracoBuffer> buffers_;
  std::map<std::size_t, std::size_t> buffer_of_view_;
  std::vector<DracoUse> uses_;
  std::map<std::pair<std::size_t, std::size_t>, Lies> indices_lie_;     ///< by buffer and bytes of an index
  std::map<std::pair<std::size_t, std::size_t>, Lies> attributes_lie_;  ///< by buffer and number in its claim
  std::map<std::pair<std::size_t, Lies>, std::size_t> placed_;          ///< accessors with those elements
  std::set<std::size_t> filled_;                                        ///< accessors that have elements now
  std::set<std::size_t> copies_;
  bool is_odd_ = false;
};

}  // namespace

bool check_draco(Gate& gate, const Executor& executor) { return DracoCheck(gate).run(executor); }

}  // namespace foredraw::gltf
