// What came out of Draco's buffers becomes accessors with bytes.
#include <foredraw/io/gltf/codecs/private/draco_uses.h>
#include <foredraw/io/gltf/gate/private/decoded_views.h>
#include <foredraw/io/gltf/private/rows.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace foredraw::gltf {

namespace {

class DracoPlacing {
 public:
  DracoPlacing(Gate& gate, const DracoUses& found) : gate_(gate), json_(gate.document().json), found_(found) {}

  void run() {
    Document& document = gate_.document();
    DecodedViews views(document.views.size());
    for (const DracoBuffer& buffer : found_.buffers) {
      for (const DracoClaim::Attribute& attribute : buffer.claim.attributes)
        views.expect_vertices(std::get<DracoMesh>(buffer.held).points, attribute.format.bytes);
    }
    for (const DracoUse& use : found_.uses) {
      const DracoMesh& mesh = std::get<DracoMesh>(found_.buffers[use.buffer].held);
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
          lies->second =
              views.add_vertices(mesh.attributes[attribute.claimed],
                                 found_.buffers[use.buffer].claim.attributes[attribute.claimed].format.bytes);
        }
        primitive["attributes"][attribute.semantic] = placed(attribute.accessor, lies->second, mesh.points);
      }
    }
    FromDraco& told = document.from_draco.emplace();
    for (const DracoBuffer& buffer : found_.buffers) {
      told.views.insert(buffer.view);
      told.coded += document.views[buffer.view].length;
    }
    told.accessors = std::move(filled_);
    told.copies = std::move(copies_);
    told.plain = std::move(views).put(document, document.views[found_.buffers.front().view].buffer);
  }

 private:
  /// What the buffer holds is read, whatever its accessors say; a file is mostly all of one exporter.
  void tell_odd(const DracoUse& use, const DracoMesh& mesh) {
    if (std::exchange(is_odd_, true)) return;
    gate_.warning(use.place, "compressed-count",
                  fmt::format("the accessors claim {} vertices and {} triangles, but the Draco buffer holds {} and {}; "
                              "the buffer is used, here and wherever else they differ",
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
  const DracoUses& found_;
  std::map<std::pair<std::size_t, std::size_t>, Lies> indices_lie_;     ///< by buffer and bytes of an index
  std::map<std::pair<std::size_t, std::size_t>, Lies> attributes_lie_;  ///< by buffer and number in its claim
  std::map<std::pair<std::size_t, Lies>, std::size_t> placed_;          ///< accessors with those elements
  std::set<std::size_t> filled_;                                        ///< accessors that have elements now
  std::set<std::size_t> copies_;
  bool is_odd_ = false;
};

}  // namespace

void place_draco(Gate& gate, const DracoUses& found) { DracoPlacing(gate, found).run(); }

}  // namespace foredraw::gltf
