// What accessors claim of Draco's buffers.
#include <foredraw/io/gltf/codecs/private/draco_uses.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace foredraw::gltf {

namespace {

class UseFinder {
 public:
  explicit UseFinder(Gate& gate) : gate_(gate) {}

  DracoUses run() {
    for (std::size_t m = 0; m < gate_.count("meshes"); ++m) {
      const auto primitives = gate_.all("meshes")[m].find("primitives");
      if (primitives == gate_.all("meshes")[m].end() || !primitives->is_array()) continue;
      for (std::size_t p = 0; p < primitives->size(); ++p) {
        const Json& primitive = (*primitives)[p];
        if (!primitive.is_object() || extension_of(primitive, draco_extension) == nullptr) continue;
        found_.is_used = true;
        const std::string place = at(in(at("meshes", m), "primitives"), p);
        DracoUse use{.mesh = m, .primitive = p, .place = in(in(place, "extensions"), draco_extension)};
        if (find_use(primitive, place, use)) found_.uses.push_back(std::move(use));
      }
    }
    return std::move(found_);
  }

 private:
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
      claim.attributes.push_back({static_cast<std::uint32_t>(*id), accessor->format, semantic});
    }
    return !ids.empty();
  }

  /// To the other primitives of the same buffer.
  void join(std::size_t view, DracoUse& use, DracoClaim claim) {
    const auto [known, is_new] = buffer_of_view_.try_emplace(view, found_.buffers.size());
    use.buffer = known->second;
    if (is_new) {
      found_.buffers.push_back({view, use.place, std::move(claim), {}});
      return;
    }
    DracoClaim& all = found_.buffers[use.buffer].claim;
    all.points = std::max(all.points, claim.points);
    all.triangles = std::max(all.triangles, claim.triangles);
    for (DracoUse::Attribute& attribute : use.attributes) {
      const DracoClaim::Attribute& wanted = claim.attributes[attribute.claimed];
      const auto same = std::find_if(all.attributes.begin(), all.attributes.end(), [&](const auto& one) {
        return one.id == wanted.id && one.semantic == wanted.semantic &&
               one.format.component == wanted.format.component && one.format.components == wanted.format.components;
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

  Gate& gate_;
  DracoUses found_;
  std::map<std::size_t, std::size_t> buffer_of_view_;
};

}  // namespace

DracoUses draco_uses(Gate& gate) { return UseFinder(gate).run(); }

}  // namespace foredraw::gltf
