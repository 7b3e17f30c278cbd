#pragma once
// KHR_draco_mesh_compression put into a document that is laid out plain. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/io/gltf/private/accessor_store.h>

namespace foredraw::gltf {

struct DracoOutput {
  bool may_reorder = false;         ///< by the edgebreaker method, where nothing but the picture counts
  std::set<std::size_t> held = {};  ///< accessors that others than primitives, skins, animations and instances name
};

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
