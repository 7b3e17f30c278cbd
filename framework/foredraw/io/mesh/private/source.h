#pragma once
// What the mesh readers keep for the writers. Private to io.

#include <foredraw/io/gltf/private/source.h>
#include <foredraw/io/mesh/mesh_files.h>
#include <foredraw/io/mesh/private/polygon_mesh.h>
#include <foredraw/io/mesh/private/text.h>

namespace foredraw::mesh_files {

class MeshSource final : public SceneSource {
 public:
  MeshKind kind = MeshKind::obj;
  Shared<std::byte> file;                    ///< as it came
  Scene as_read;                             ///< its own source is empty
  std::vector<DrawRecords> records;          ///< [draw]
  std::shared_ptr<const gltf::Source> gltf;  ///< what a glTF file is to hold besides the draws

  std::uint64_t bytes() const override { return file.size(); }

  std::string_view text() const {
    const auto bytes = file.view();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

/// Where faces and records go. Faces move within their draw alone.
struct MeshOrder {
  std::vector<std::uint32_t> faces;      ///< [place] = number of the face that stands there now
  std::vector<std::uint32_t> positions;  ///< [old number] = rank; empty: they stay where they are
  std::vector<std::uint32_t> texcoords, normals;
  bool moved = false;
};

/// How many there are of what a file numbers.
struct RecordCounts {
  std::size_t faces = 0, positions = 0, texcoords = 0, normals = 0;
};

/// What became of a file's order; ranks put records in the sequence in which the scene's vertices use them, those that
/// no vertex uses last. nullopt, with an error, where more than the order was changed.
std::optional<MeshOrder> order_of(const Scene& scene, const MeshSource& source, const RecordCounts& counts,
                                  Diagnostics& diagnostics);

// Each writes its kind of file anew, in that order. The text is one that the reader has read.
std::optional<std::string> reordered_obj(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics);
std::optional<std::string> reordered_ply(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics);
std::optional<std::string> reordered_off(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics);
std::optional<std::string> reordered_stl(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics);

}  // namespace foredraw::mesh_files
