#pragma once
// The check of a glTF file's raw bytes, before any reader relies on them. Everything that a count, an index or a length
// in the file claims is held against what is there. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/private/document.h>

#include <limits>
#include <set>

namespace foredraw::gltf {

/// The document, or nullopt with an error for each mistake (the first twenty).
std::optional<Document> open_document(Shared<std::byte> file, const std::string& name,
                                      const std::filesystem::path& folder, const ProductRows& products,
                                      Diagnostics& diagnostics);

/// What the checks share: the document as far as it was found sound, and where mistakes go.
class Gate {
 public:
  Gate(Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  Document& document() { return document_; }
  const Document& document() const { return document_; }
  const Json& json() const { return document_.json; }
  bool sound() const { return mistakes_ == 0; }

  void error(const std::string& place, std::string code, std::string message, std::string hint = {});
  void warning(const std::string& place, std::string code, std::string message);
  void error_at(std::size_t byte, std::string_view text, std::string code, std::string message, std::string hint = {});
  void note(const std::string& place, std::string code, std::string message);
  void finish();

  /// The top-level array of that name; an empty one where there is none.
  const Json& all(const char* kind) const;
  std::size_t count(const char* kind) const { return all(kind).size(); }

  /// Members of `parent`, which lies at `place`. Absent ones give nothing; wrong ones an error and nothing.
  const Json* array(const Json& parent, const char* key, const std::string& place);
  const Json* object(const Json& parent, const char* key, const std::string& place);
  std::optional<std::string> text(const Json& parent, const char* key, const std::string& place);
  std::optional<bool> boolean(const Json& parent, const char* key, const std::string& place);
  std::optional<std::uint64_t> whole(const Json& parent, const char* key, const std::string& place,
                                     std::uint64_t least = 0,
                                     std::uint64_t most = std::numeric_limits<std::int64_t>::max());
  /// An array of numbers that fit 32-bit floats; `size` 0: any number of them.
  bool numbers(const Json& parent, const char* key, const std::string& place, std::size_t size);
  std::optional<double> number(const Json& parent, const char* key, const std::string& place);

  /// A reference into the top-level array `kind`.
  std::optional<std::size_t> reference(const Json& parent, const char* key, const char* kind, const std::string& place);
  std::optional<std::size_t> reference(const Json& value, const char* kind, const std::string& place);
  void required(const Json& parent, const char* key, const std::string& place);

  /// The accessor's layout; nothing where it was found wrong.
  const Accessor* accessor(std::optional<std::size_t> number) const;

  /// The buffer view; nothing where it was found wrong.
  const BufferView* view(std::optional<std::size_t> number) const;

  std::vector<std::optional<Accessor>> accessors;

  /// Accessors of a type that glTF does not know. Whoever refers to one is refused.
  std::set<std::size_t> unknown_accessors;

 private:
  Document& document_;
  Diagnostics& diagnostics_;
  std::size_t mistakes_ = 0;
  std::size_t warnings_ = 0;
};

/// How many bytes buffer views, or accessors, may claim together. Some overlap is common, as primitives view one
/// stream; but a small file whose parts all lie over one another must not fill the memory.
std::uint64_t most_claimed(const Gate& gate);

std::string at(const std::string& place, std::size_t i);
std::string in(const std::string& place, std::string_view key);

// Each of these looks at one part; they run in this sequence.
struct Container {
  std::string_view json;
  std::optional<Bytes> bin;
};
std::optional<Container> open_container(Gate& gate);
bool parse_json(Gate& gate, std::string_view text);
bool check_structure(Gate& gate);
void check_extensions(Gate& gate);
void check_buffers(Gate& gate, std::optional<Bytes> bin);
void check_views(Gate& gate);
void check_compression(Gate& gate);
void check_accessors(Gate& gate);
void check_images(Gate& gate);
void check_materials(Gate& gate);
void check_meshes(Gate& gate);
void check_nodes(Gate& gate);
void check_instances(Gate& gate);
void check_skins(Gate& gate);
void check_animations(Gate& gate);
void check_finite(Gate& gate);

}  // namespace foredraw::gltf
