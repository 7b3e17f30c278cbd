#pragma once
// The contract of a product: how it is read and written, what it holds on to, what becomes of it, what is told of it.
// The folder of whoever makes the product has its row; readers, writers, runners and hosts are handed rows and know no
// names.

#include <foredraw/scene/extension_value.h>
#include <foredraw/scene/scene.h>

#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <variant>

namespace foredraw {

/// The rows of an accessor, without gaps.
struct AccessorData {
  enum class Use : std::uint8_t { other, vertices, positions };  ///< vertices lie together; positions have bounds

  Format format;
  std::size_t count = 0;
  Shared<std::byte> bytes;
  Use use = Use::other;
};

/// Rows of plain numbers of one component type, such as four 32-bit floats.
template <class T>
AccessorData accessor_data(std::span<const T> values, Component component, std::uint8_t components) {
  const auto bytes = std::as_bytes(values);
  const auto row = static_cast<std::uint16_t>(components * bytes_of(component));
  return {{component, components, false, row}, bytes.size() / row, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// A product's extension as a file has it. Nothing in it is to be trusted.
class ExtensionReader {
 public:
  virtual ~ExtensionReader() = default;
  /// What the file says at its top, or on a draw's primitive; null where it says nothing there.
  virtual const ExtensionValue* of_file() const = 0;
  virtual const ExtensionValue* of_draw(DrawId draw) const = 0;
  /// Whether the draw's primitive has its corners as a list, and not as a strip or fan.
  virtual bool is_list(DrawId draw) const = 0;
  /// That all accessors hold together: what is made of a product should take no more than some times that.
  virtual std::uint64_t bytes() const = 0;
  /// Nothing where there is no such accessor, or it is empty. Asked twice it is the same handle.
  virtual std::optional<AccessorData> accessor(std::size_t number) = 0;
};

/// The accessor that `number` names, as rows of T, whose components are all of one type. Nothing where it names none,
/// or one of another format.
template <class T>
std::optional<Shared<T>> rows_of(ExtensionReader& from, const ExtensionValue* number, Component component) {
  const auto data = number != nullptr && number->whole() ? from.accessor(*number->whole()) : std::nullopt;
  const auto components = static_cast<std::uint8_t>(sizeof(T) / bytes_of(component));
  if (!data || !(data->format == Format{component, components, false, sizeof(T)})) return std::nullopt;
  std::vector<T> rows(data->count);
  std::memcpy(rows.data(), data->bytes.view().data(), data->bytes.size());
  return Shared<T>(std::move(rows));
}

/// A mistake in an extension, as the rest of a sentence; caught where reading began.
struct WrongExtension : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The member, or WrongExtension.
const ExtensionValue& needed_member(const ExtensionValue& of, const char* name);

class ExtensionWriter {
 public:
  virtual ~ExtensionWriter() = default;
  virtual void put_on_file(ExtensionValue value) = 0;
  virtual void put_on_draw(DrawId draw, ExtensionValue value) = 0;
  /// An accessor to name in the extension; equal ones are written once.
  virtual AccessorRef accessor(const AccessorData& data) = 0;
  /// An accessor of indices, as narrow as they allow.
  virtual AccessorRef indices(std::span<const std::uint32_t> indices) = 0;
  /// The draw's vertices, of the attributes by name, are rows of these accessors from `first` on, and need no bytes of
  /// their own.
  virtual void share_vertices(DrawId draw, const std::vector<std::pair<std::string, AccessorRef>>& attributes,
                              std::uint32_t first) = 0;
};

/// A file that engines read beside the scene, or instead of it.
struct SideFileKind {
  std::string extension;    ///< ".json"
  std::string beside = {};  ///< the end of a second file's name, behind the first's: ".bin"; empty: there is none
};

struct SideFile {
  std::variant<std::vector<std::byte>, std::string, ExtensionValue> content;  ///< a value is written as JSON
  int indent = 1;                                                             ///< of JSON; -1: all on one line
  std::vector<std::byte> beside = {};
};

/// What `inspect` shows.
struct ProductText {
  std::string heading;  ///< "merged (beside the nodes that show the same)"
  std::vector<std::string> lines;
  ExtensionValue value;  ///< the same for programs
};

/// What a row says of itself. Names of accessors are paths of members in the extension's object, "*" for each element
/// or member: "sets/*/indices". Whoever reads or drops the extension finds them so, whatever else is wrong with it.
struct ProductCard {
  std::string name;       ///< the product's: "merged-draws"
  std::string title;      ///< "merged draws"
  std::string extension;  ///< "FOREDRAW_merge_instances"
  std::string remedy;     ///< what to do where it was left out
  std::vector<std::string> accessors_of_file = {};
  std::vector<std::string> accessors_of_draw = {};
  std::vector<std::pair<std::string, std::string>> schemas = {};  ///< file name, JSON Schema
  std::vector<SideFileKind> side_files = {};
};

/// Why something can not be, for people: what is wrong, and what to do.
struct Refusal : std::runtime_error {
  Refusal(std::string code, const std::string& message, std::string hint)
      : std::runtime_error(message), code(std::move(code)), hint(std::move(hint)) {}
  std::string code, hint;
};

class ProductRow {
 public:
  explicit ProductRow(ProductCard card) : card_(std::move(card)) {}
  virtual ~ProductRow() = default;
  const ProductCard& card() const { return card_; }

  /// Puts the product, and what of draws belongs to it, into the scene. Answers with what is wrong, as the rest of a
  /// sentence, and leaves the scene anyhow; empty: all of it holds.
  virtual std::string read(ExtensionReader& from, Scene& scene) const = 0;
  virtual void write(const Scene& scene, ExtensionWriter& to) const = 0;
  /// Whether it need not be written again, given that the products are equal: what else it writes is alike too.
  virtual bool is_written_alike(const Scene&, const Scene&) const { return true; }

  /// How the product differs from what the scene shows, as the rest of a sentence; empty: it shows the same. Asked when
  /// it was read, and when a stage made it.
  virtual std::string difference(const Scene&) const { return {}; }
  /// Draws that it refers to by numbers of triangles and vertices and can not follow: stages leave them alone. Rising.
  virtual std::vector<DrawId> held(const Scene&) const { return {}; }
  /// Of the draw's triangles in the order that stands alone: the first of each range, but the first range, that orders
  /// must not cross. Orders and clusters are made within ranges, so that bounds stay where they are; other stages'
  /// changes the product follows itself. Of a scene that has it.
  virtual std::vector<std::uint32_t> bounds(const Scene&, DrawLevel) const { return {}; }
  /// Brings the product up to what a stage made of the draws. Answers with what had to be left out and why, as whole
  /// sentences. Unless a row knows better, the product is left out where it no longer shows the same.
  virtual std::vector<std::string> follow(const Scene& before, Scene& after) const;
  /// Takes the product, and what of draws belongs to it, out of the scene.
  virtual void leave_out(Scene& scene) const { scene.products.erase(card().name); }

  /// Of a scene that has it. Throws Refusal where it can not be said. `beside`: what the file beside it is called,
  /// without folders.
  virtual SideFile side_file(const Scene&, std::string_view extension, const std::string& beside) const;
  virtual ProductText told(const Scene& scene) const = 0;

 protected:
  /// Puts what follow() has left of the product in its place; `is_empty`: none of it.
  template <class Product>
  void put_left(Scene& after, Product left, bool is_empty) const {
    if (is_empty) return leave_out(after);
    after.products.set(std::move(left));
  }

 private:
  ProductCard card_;
};

using ProductRows = std::vector<std::shared_ptr<const ProductRow>>;

/// Where ranges of the draw's triangles begin that products of the scene count on: what their rows' bounds() say,
/// between the first triangle and the last, rising, each once. `but`: a product that is not asked, as who makes it
/// anew.
std::vector<std::uint32_t> bounds_of(const Scene& scene, DrawLevel at, const ProductRows& rows,
                                     std::string_view but = {});

/// Marks the draws that products hold as `extended`.
void mark_held_draws(Scene& scene, const ProductRows& rows);

}  // namespace foredraw
