#pragma once
// New contents of accessors put into a document, and its bytes laid out again. Private to io.

#include <foredraw/io/gltf/private/document.h>

#include <map>
#include <set>
#include <tuple>

namespace foredraw::gltf {

/// What an accessor shall hold. The bytes are tight.
struct Content {
  /// Each in buffer views of its own.
  enum class Kind { vertices, indices, inverse_bind_matrices, other };

  Kind kind = Kind::other;
  Format format;
  std::size_t count = 0;
  Shared<std::byte> bytes;
  bool wants_range = false;  ///< min and max must be there: of positions
};

bool same_content(const Content& a, const Content& b);
/// Writes the least and greatest of the finite values of each component as min and max. A number that says the same in
/// fewer digits stays.
void set_range(Json& accessor, const Content& content);

/// A buffer of plain copies of compressed views.
struct Fallback {
  Json json;
  std::size_t length = 0;
  bool there = false;            ///< else readers are told of its length alone
  std::vector<std::byte> bytes;  ///< empty unless it is there
};

/// Bytes of one kind, in the input and in the output.
struct Sizes {
  std::string what;
  std::uint64_t before = 0;
  std::uint64_t after = 0;
};

/// A part of another accessor's rows.
struct Part {
  std::size_t of = 0;
  std::size_t first = 0;  ///< row
};

struct LaidOut {
  std::vector<std::byte> bytes;     ///< of buffer 0
  std::vector<Fallback> fallbacks;  ///< buffers 1 and on
  std::vector<Sizes> sizes;         ///< of what did not stay as it was
};

/// Collects the changes, then lays out the bytes. Accessors keep their numbers, and so do buffer views unless one falls
/// away. Views that nobody changes keep their bytes; a changed one is laid out anew in the old sequence, so that what
/// was side by side or interleaved stays so, and what nobody refers to any more is gone.
class AccessorStore {
 public:
  /// `json` is the document's, to be changed; both must outlive the store.
  AccessorStore(const Document& document, Json& json);

  void redefine(std::size_t accessor, const Content& content);
  /// Where the accessor keeps its elements, its min and max become exact, if it has them.
  void correct_range(std::size_t accessor);
  /// The number of a new accessor, or of one that was appended before with the same content. `like`: the accessor whose
  /// type it keeps, and whose min and max where these are the same.
  std::size_t append(const Content& content, std::optional<std::size_t> like = std::nullopt);
  /// The number that append() gave this content; nothing where it was not appended.
  std::optional<std::size_t> appended(const Content& content) const;
  /// Nobody refers to it any more: it keeps its number, but no bytes.
  void release(std::size_t accessor);
  /// The accessor's bytes become a part of those of another one, which was appended, from its row `first` on. False,
  /// and nothing changes, where these are others or it is a part already.
  bool lay_within(std::size_t accessor, std::size_t of, std::size_t first);
  void set_image(std::size_t image, Shared<std::byte> bytes);

  /// Images got other numbers: those past the end are gone.
  void move_images(const std::vector<std::size_t>& to);
  /// Whether the accessor was redefined or appended.
  bool is_new(std::size_t accessor) const { return contents_.contains(accessor); }

  /// Who knew of the buffer view is gone; it goes too unless an accessor or image uses it.
  void forget_view(std::size_t view) { forgotten_.insert(view); }

  bool changed() const { return !contents_.empty() || !released_.empty() || !images_.empty(); }

  /// The bytes of the buffers; sets bufferViews, buffers, and whatever refers to views in the JSON. Views that came in
  /// compressed stay so with `compress`.
  LaidOut lay_out(bool compress);

 private:
  void describe(std::size_t accessor, const Content& content);

  const Document& document_;
  Json& json_;
  std::map<std::size_t, Content> contents_;
  using Key = std::tuple<Stamp, Content::Kind, Component, int, bool, bool>;
  static Key key_of(const Content& content);
  std::map<Key, std::size_t> appended_;
  std::map<std::size_t, Part> parts_;
  std::set<std::size_t> wholes_;  ///< that others are parts of; never a part itself
  std::set<std::size_t> released_;
  std::map<std::size_t, Shared<std::byte>> images_;
  std::set<std::size_t> forgotten_;
};

}  // namespace foredraw::gltf
