#pragma once
// KHR_draco_mesh_compression put into a document that is laid out plain. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/codecs/private/draco_encode.h>
#include <foredraw/io/gltf/layout/private/accessor_store.h>

namespace foredraw::gltf {

struct DracoOutput {
  bool edgebreaker = false;         ///< where nothing but the picture counts
  bool holds_products = false;      ///< which may name triangles and vertices
  std::set<std::size_t> held = {};  ///< accessors that others than primitives, skins, animations and instances name
};

/// Primitives of the same triangles: one buffer is for all of them.
struct DracoTriangles {
  std::vector<std::pair<std::size_t, std::size_t>> primitives = {};  ///< mesh, and number in it
  std::vector<std::size_t> accessors = {};                           ///< of attributes by name, and of indices
  bool is_alone = true;                  ///< nobody else has anything to do with the accessors
  std::optional<DracoCoded> coded = {};  ///< with what is decoded where the order is another
  std::size_t plain = 0;                 ///< bytes that come out of it
  Json extension = {};                   ///< without the view
};

struct DracoChoice {
  std::vector<DracoTriangles> triangles = {};  ///< that are compressed
  std::set<std::size_t> released = {};         ///< accessors whose bytes nobody needs any more
  std::size_t primitives = 0;                  ///< that there are, compressed or not
};

/// Encodes all lists of triangles. Those that share rows are compressed together or not at all: where that is shorter.
DracoChoice chosen_primitives(Json& json, const LaidOut& laid_out, const DracoOutput& how);

/// Compresses lists of triangles, and levels, which are primitives here. Primitives that share accessors are compressed
/// together or not at all, whichever is shorter: each would have a copy of its own. All else stays plain, and morph
/// targets do beside compressed vertices, which keep their order for them. Everything comes back to the last bit, which
/// is checked. Notes say what was not compressed or is not shorter, and a warning tells of other orders.
void compress_primitives(Json& json, LaidOut& laid_out, const DracoOutput& how, const std::string& file,
                         Diagnostics& diagnostics);

/// Plain data that lies in groups: accessors whose rows overlap are of one group, which is needed as long as one is.
class SharedRows {
 public:
  explicit SharedRows(const Json& json);

  /// Nothing where the accessor has no plain rows in the first buffer.
  std::optional<std::size_t> group_of(std::size_t accessor) const { return groups_[accessor]; }
  /// That fall away with the group.
  std::size_t bytes_of(std::size_t group) const { return bytes_[group]; }
  std::size_t count() const { return bytes_.size(); }

 private:
  std::vector<std::optional<std::size_t>> groups_;
  std::vector<std::size_t> bytes_;
};

}  // namespace foredraw::gltf
