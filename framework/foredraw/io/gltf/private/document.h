#pragma once
// A glTF file taken apart and found sound: its JSON, its buffers, and where the elements of every accessor lie.
// Private to io: the one kind of header that may name the JSON library.

#include <foredraw/io/gltf/codecs/private/meshopt.h>
#include <foredraw/io/text/private/json_tree.h>
#include <foredraw/scene/product_row.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace foredraw::gltf {

using Bytes = std::span<const std::byte>;

inline constexpr std::uint32_t glb_magic = 0x46546C67;       // "glTF"
inline constexpr std::uint32_t glb_json_chunk = 0x4E4F534A;  // "JSON"
inline constexpr std::uint32_t glb_bin_chunk = 0x004E4942;   // "BIN\0"

struct Chunk {
  std::uint32_t type = 0;
  Bytes bytes;
};

struct Buffer {
  Bytes bytes;             ///< empty: a fallback that is not there, or, while a document is being checked, refused
  std::size_t length = 0;  ///< that it has, or would have; 0: refused
  bool fallback = false;   ///< holds plain copies of compressed views, for whoever can not decompress
  bool is_cut = false;     ///< it states more bytes than there are
};

/// The compressed bytes of a view, which stand for its plain ones.
struct Compressed {
  std::string extension;
  std::size_t buffer = 0;
  std::size_t offset = 0;
  Bytes stream;
  Coding coding;
  bool understood = true;  ///< false: there is no decoder, and the view holds the plain copy
};

struct BufferView {
  std::size_t buffer = 0;
  std::size_t offset = 0;
  std::size_t length = 0;  ///< 0 only while a document is being checked: the view was refused
  std::size_t stride = 0;  ///< 0: elements are tight
  Bytes bytes;             ///< plain
  std::optional<Compressed> compressed;
};

/// Elements at even distances in a buffer.
struct Rows {
  std::size_t view = 0;
  std::size_t offset = 0;  ///< in the view
  std::size_t stride = 0;
};

struct SparseElements {
  std::size_t count = 0;
  Component index = Component::uint32;
  Rows indices;
  Rows values;
};

struct Accessor {
  Format format;
  std::size_t count = 0;
  std::optional<Rows> rows;  ///< none: every element is zero
  std::optional<SparseElements> sparse;

  std::size_t bytes() const { return count * format.bytes; }
};

/// A primitive and those that draw it coarser.
struct Ladder {
  DrawOrigin full;
  std::vector<DrawOrigin> coarser;
  std::vector<float> errors;  ///< of each, or empty
};

inline constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// What came compressed by Draco, and is decoded now.
struct FromDraco {
  std::set<std::size_t> views;      ///< that hold Draco's buffers
  std::set<std::size_t> accessors;  ///< that were decoded; their ranges in the JSON are perhaps not exact
  std::set<std::size_t> copies;     ///< accessors with plain copies, which nobody may need any more
  std::uint64_t coded = 0;          ///< bytes
  std::uint64_t plain = 0;          ///< bytes that they became
};

/// Movable only: the spans lead into `file` and `kept`.
struct Document {
  std::string name;
  std::filesystem::path folder;  ///< empty: there are no files beside it
  bool binary = false;
  Shared<std::byte> file;  ///< as it came
  Json json;
  bool left_out = false;  ///< `json` lacks what the reader took out of it, so that the file can not stay as it came
  std::set<std::size_t>
      let_go;  ///< accessors that this named, where the writer may drop them; perhaps some that are not there
  std::map<std::size_t, std::string> broken;  ///< accessors that only products name, and why they have no bytes
  std::vector<Ladder> ladders;                ///< primitives of `json` that are levels, behind those of their mesh
  std::vector<Chunk> further_chunks;          ///< of a GLB, after JSON and BIN
  std::vector<Buffer> buffers;
  std::vector<std::vector<std::byte>> kept;  ///< buffers that were loaded or decoded, views that were decompressed
  std::vector<BufferView> views;
  std::vector<Accessor> accessors;
  std::optional<FromDraco> from_draco;  ///< then `json` and `views` are as though the file had come without Draco
  ProductRows products;                 ///< whose extensions are known

  /// Whether we know of the extension which members refer to what, so that nothing it points at is lost or moved
  /// unseen.
  bool knows_extension(std::string_view name) const;
  /// Whether we know all of them. Else what was there stays where it was.
  bool knows_all_extensions() const;

  Document() = default;
  Document(Document&&) = default;
  Document& operator=(Document&&) = default;
};

/// All elements without gaps, in the asset's own format, sparse ones put in.
std::vector<std::byte> elements(const Document& document, const Accessor& accessor);

/// As above, decoded; for formats without padding.
std::vector<float> decoded_elements(const Document& document, const Accessor& accessor);

/// The elements of a SCALAR accessor of unsigned integers.
std::vector<std::uint32_t> index_elements(const Document& document, const Accessor& accessor);
std::uint32_t greatest_index(const Document& document, const Accessor& accessor);

/// The greatest number that such indices can hold: it restarts strips, loops and fans.
std::uint32_t restart_of(Component indices);

/// Whether an animation's channel moves a node: scenes hold no others. What aims at no node aims by an extension at
/// something that has no shape.
bool moves_a_node(const Json& channel);

/// "VEC3" and its component type to a format; nullopt where there is none such.
std::optional<Format> format_of(std::string_view type, std::uint64_t component_type, bool normalized);

inline constexpr const char* mesh_gpu_instancing = "EXT_mesh_gpu_instancing";

/// The extension's value in an object; nothing where it has none.
const Json* extension_of(const Json& holder, std::string_view name);

/// The extension's value taken out of an object; null where it has none.
Json take_extension(Json& holder, std::string_view name);

/// Calls visit(primitive), or visit(primitive, mesh, number), for each primitive, whether or not the document was
/// checked.
template <class AnyJson, class Visit>
void each_primitive(AnyJson& json, Visit visit) {
  const auto meshes = json.find("meshes");
  if (meshes == json.end() || !meshes->is_array()) return;
  for (std::size_t m = 0; m < meshes->size(); ++m) {
    auto& mesh = (*meshes)[m];
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) continue;
    for (std::size_t p = 0; p < primitives->size(); ++p) {
      auto& primitive = (*primitives)[p];
      if (!primitive.is_object()) continue;
      if constexpr (std::is_invocable_v<Visit, decltype(primitive)>) {
        visit(primitive);
      } else {
        visit(primitive, m, p);
      }
    }
  }
}

/// Of a file and its primitives: whether one has the extension, and the extension taken out of all. They need not have
/// been checked.
bool has_extension(const Json& json, std::string_view name);
void take_extension_everywhere(Json& json, std::string_view name);

/// The number of what is in the list, or was put into it.
std::size_t listed(Json& list, const Json& value);

/// Puts the name into a list of extensions, where it is not there; takes it out of those that are used and required.
void list_extension(Json& json, const char* list, const std::string& name);
void unlist_extension(Json& json, std::string_view name);

/// The bytes of the file and of the buffers beside it.
std::uint64_t bytes_read(const Document& document);

/// Every name in extensionsUsed, and every key of an object called "extensions" anywhere; sorted, each once.
std::vector<std::string> extensions_in(const Json& json);

}  // namespace foredraw::gltf
