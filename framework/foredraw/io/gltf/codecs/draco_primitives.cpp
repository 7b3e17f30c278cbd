// What a document says of primitives that are compressed by Draco.
#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/codecs/private/draco_primitives.h>
#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/patch/private/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace foredraw::gltf {

namespace {

/// Looked up each time: a key put into an object moves what it holds.
Json& primitive_at(Json& json, const std::pair<std::size_t, std::size_t>& place) {
  return json["meshes"][place.first]["primitives"][place.second];
}

/// Triangles without area are gone, and vertices that none has or that were there twice.
void correct_counts(Json& json, const DracoTriangles& one) {
  const DracoMesh& mesh = one.coded->decoded;
  for (std::size_t i = 0; i < one.coded->ids.size(); ++i) {
    Json& accessor = json["accessors"][one.accessors[i]];
    accessor["count"] = mesh.points;
    if (!accessor.contains("min") && !accessor.contains("max")) continue;
    const auto format =
        *format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(), false);
    set_range(accessor, {Content::Kind::other, format, mesh.points, Shared<std::byte>(mesh.attributes[i])});
  }
  Json& indices = json["accessors"][one.accessors.back()];
  indices["count"] = mesh.indices.size();
  for (const char* key : {"min", "max"}) indices.erase(key);
  if (mesh.points > 0xfffe) indices["componentType"] = 5125;
  if (mesh.points > 0xfe && indices["componentType"] == 5121) indices["componentType"] = 5123;
}

/// All but the buffers: these have no views yet.
void put_extensions(Json& json, const DracoChoice& choice) {
  for (const DracoTriangles& one : choice.triangles) {
    for (const auto& place : one.primitives) primitive_at(json, place)["extensions"][draco_extension] = one.extension;
    if (!one.coded->keeps_order) correct_counts(json, one);
  }
  for (const std::size_t a : choice.released) {
    for (const char* key : {"bufferView", "byteOffset"}) json["accessors"][a].erase(key);
  }
  if (choice.triangles.empty()) return;
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) list_extension(json, list, draco_extension);
}

/// The views that are plain laid out anew, and behind them the buffers.
void put_views(Json& json, LaidOut& laid_out, const DracoChoice& choice) {
  const std::vector<std::byte> was = std::exchange(laid_out.bytes, {});
  const auto append = [&](Bytes bytes, std::size_t alignment) {
    std::vector<std::byte>& to = laid_out.bytes;
    to.resize(aligned(to.size(), alignment));
    const std::size_t at = to.size();
    to.insert(to.end(), bytes.begin(), bytes.end());
    return at;
  };
  Json& views = json["bufferViews"];
  if (views.is_null()) views = Json::array();
  for (Json& view : views) {
    const auto plain = Bytes(was).subspan(view.value("byteOffset", std::size_t{0}), view["byteLength"]);
    set_place(view, 0, append(plain, 8), plain.size());
  }
  for (const DracoTriangles& one : choice.triangles) {
    Json view = Json::object();
    set_place(view, 0, append(one.coded->bytes, 4), one.coded->bytes.size());
    for (const auto& place : one.primitives)
      primitive_at(json, place)["extensions"][draco_extension]["bufferView"] = views.size();
    views.push_back(std::move(view));
  }
  if (views.empty()) json.erase("bufferViews");
  laid_out.bytes.resize(aligned(laid_out.bytes.size(), 4));
}

void tell(const DracoChoice& choice, bool edgebreaker, const std::string& file, Diagnostics& diagnostics) {
  std::size_t compressed = 0, reordered = 0, loose = 0, left_out = 0;
  for (const DracoTriangles& one : choice.triangles) {
    compressed += one.primitives.size();
    reordered += one.coded->keeps_order ? 0 : one.primitives.size();
    loose += one.coded->loose;
    for (const auto& id : one.coded->ids) left_out += id ? 0 : 1;
  }
  if (compressed < choice.primitives) {
    diagnostics.note(
        {.file = file, .inside = "meshes"}, "draco-left-plain",
        fmt::format("Draco leaves {} of {} plain: it knows lists of triangles alone, and makes small meshes and "
                    "shared vertices longer",
                    counted(choice.primitives - compressed), counted(choice.primitives, "primitive")));
  }
  if (left_out > 0) {
    diagnostics.note(
        {.file = file, .inside = "meshes"}, "draco-left-out",
        fmt::format("Draco leaves {} plain beside compressed ones: it does not give back every bit of matrices "
                    "with gaps, nor of integers of 32 bits that are far apart",
                    counted(left_out, "attribute")));
  }
  if (loose > 0) {
    diagnostics.note(
        {.file = file, .inside = "meshes"}, "draco-keeps-floats",
        fmt::format("Draco makes {} of floats no shorter: no value may be rounded here", counted(loose, "attribute")),
        "put `quantize` into the pipeline, which rounds within an error and tells it");
  }
  if (edgebreaker && reordered < compressed) {
    diagnostics.note(
        {.file = file, .inside = "meshes"}, "draco-keeps-order",
        fmt::format("{} of {} compressed primitives keep their order: a product of the file, morph targets "
                    "or shared vertices need it, or the edgebreaker method is not shorter",
                    compressed - reordered, compressed));
  }
  if (reordered == 0) return;
  diagnostics.warning(
      {.file = file, .inside = "meshes"}, "draco-reorders",
      fmt::format("the edgebreaker method of Draco sorts triangles and vertices: what stages gained by their order "
                  "is gone in {} of {} compressed primitives",
                  reordered, compressed),
      "write it with --compression draco, which keeps all orders");
}

}  // namespace

void compress_primitives(Json& json, LaidOut& laid_out, const DracoOutput& how, const std::string& file,
                         Diagnostics& diagnostics) {
  const DracoChoice choice = chosen_primitives(json, laid_out, how);
  put_extensions(json, choice);
  gather_views(json, laid_out);
  put_views(json, laid_out, choice);
  tell(choice, how.edgebreaker, file, diagnostics);
}

}  // namespace foredraw::gltf
