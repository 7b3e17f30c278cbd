#pragma once
// How elements lie in buffer views: the part of laying out that knows nothing of what they mean. Private to io.

#include <foredraw/io/gltf/layout/private/accessor_store.h>

#include <algorithm>
#include <string>

namespace foredraw::gltf {

/// Who refers to bytes of a view: the object in the JSON that holds "bufferView" and perhaps "byteOffset".
struct Holder {
  Json* object = nullptr;      ///< an accessor or image
  const char* part = nullptr;  ///< "indices" or "values" of an accessor's sparse elements

  /// Looked up each time: a key put into the object moves what it holds.
  Json& json() const { return part == nullptr ? *object : (*object)["sparse"][part]; }
};

struct ViewUser {
  Holder holder;
  std::size_t offset = 0;  ///< in the view as it was
  std::size_t end = 0;
  std::size_t stride = 0;
  std::size_t count = 0;
  std::size_t element = 0;                 ///< bytes; 0: these bytes have no rows
  const Content* content = nullptr;        ///< what it shall hold; none: as it was
  const Shared<std::byte>* raw = nullptr;  ///< new bytes without rows
  bool released = false;

  bool changes() const { return content != nullptr || raw != nullptr || released; }
};

/// Bytes that are placed as one, and who refers to where in them.
struct Block {
  struct Place {
    Holder holder;
    std::size_t offset = 0;
  };
  std::vector<std::byte> bytes;
  std::vector<Place> places;
  std::size_t stride = 0;             ///< that the view must have; 0: none
  std::size_t row = 0;                ///< bytes from one element to the next; 0: unknown
  std::optional<Content::Kind> kind;  ///< none: bytes that stayed as they were
  bool alone = false;                 ///< takes a whole view, as images do
};

/// The users of a view made into blocks. `bytes` is what the view held, `stride` its byteStride. With `keep` the view
/// stays as it is, and only who changes gets a block.
std::vector<Block> blocks_of(std::vector<ViewUser> users, Bytes bytes, std::size_t stride, bool keep);

/// A content as rows of its own. `stride` 0: where rows are tight, the view need not say how far apart they are.
Block block_of(Holder holder, const Content& content, std::size_t stride);

/// Blocks that go into one view.
struct NewView {
  std::vector<Block> blocks;
  std::size_t stride = 0;
  std::optional<std::size_t> number;
  bool is_old = false;              ///< carries on the view that had its number
  bool untouched = false;           ///< and that view's bytes; its one block has none of its own
  std::optional<std::size_t> like;  ///< old view that says how and where this one is compressed

  std::optional<Content::Kind> kind() const {
    const auto told =
        std::find_if(blocks.begin(), blocks.end(), [](const Block& block) { return block.kind.has_value(); });
    return told == blocks.end() ? std::nullopt : told->kind;
  }
};

/// What changes in a document's bytes.
struct Changes {
  const std::map<std::size_t, Content>& contents;  ///< by accessor; those past the document's are new
  const std::map<std::size_t, Part>& parts;        ///< accessors that have no bytes of their own
  const std::set<std::size_t>& released;           ///< accessors
  const std::map<std::size_t, Shared<std::byte>>& images;
  const std::set<std::size_t>& forgotten;  ///< views: gone unless somebody else uses them
};

/// The bytes of the buffers with the changes in them; `json` is made to agree. `compress`: what came in compressed goes
/// out compressed, else nothing does.
LaidOut laid_out(const Document& document, Json& json, const Changes& changes, bool compress);

/// The views, sorted by number, put into buffers. `keep`: the old buffers stay whole, and so do views in them that are
/// untouched.
LaidOut placed(const Document& document, Json& json, const std::vector<NewView>& views, bool keep, bool compress);

/// Where the bytes of a view or a stream lie.
void set_place(Json& json, std::size_t buffer, std::size_t offset, std::size_t length);

inline std::size_t aligned(std::size_t size, std::size_t to) { return (size + to - 1) / to * to; }

/// Whether an extension of ours is anywhere: products name accessors, and the rows alone know where.
bool holds_products(const Json& value);

/// Leaves out accessors that nothing names. Nobody but primitives, skins, animations and instancing may name accessors;
/// a document with products stays as it is.
void leave_out_accessors(Json& json);

/// Whoever names one of several accessors that hold and say the same, but for their names, names the first.
/// Nobody but primitives, skins, animations and instancing may name accessors that should become others.
void join_accessors(Json& json, const LaidOut& laid_out);

/// Takes the plain views of a document that is laid out apart, and puts the rows of all accessors of one kind into one
/// view: what a codec makes short, and text too. Views get new numbers. Nobody but accessors and images may refer to
/// them.
void gather_views(Json& json, LaidOut& laid_out);

/// Compresses the plain views of a document that is laid out, where that is shorter, and moves those that are
/// compressed to this extension, one of meshopt_extensions: with version 1 of the vertex codec for KHR's, version 0 for
/// EXT's. Every byte comes out again, but that with `turns_corners` lists of triangles may go into mode TRIANGLES,
/// where triangles start at any of their corners; else they go into mode INDICES. Nobody but accessors and images may
/// refer to the views.
void compress_views(Json& json, LaidOut& laid_out, const std::string& extension, bool turns_corners);

}  // namespace foredraw::gltf
