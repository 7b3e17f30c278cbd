#pragma once
// Settings of the files that a scene is written as: those of [output] in a pipeline, of the command line, and of
// callers from C and Python. Their words and help are one table, output_words() in pipeline/output_words.h.

namespace foredraw {

/// Compression of the glTF data that is written, whether it was read compressed or plain.
enum class Compression {
  keep,               ///< as it came, as its parts allow: what no stage touched as it was, the rest compressed again
  none,               ///< plain
  ext,                ///< compressed for EXT_meshopt_compression, which most readers know
  khr,                ///< compressed for KHR_meshopt_compression, its successor, whose vertices are shorter
  draco,              ///< by KHR_draco_mesh_compression, where triangles and vertices keep their order, and all bits
  draco_edgebreaker,  ///< by the same, where both go into the codec's own order; a warning says so
};

/// The form in which levels of detail that did not come as MSFT_lod are written.
enum class LevelsAs {
  extension,  ///< FOREDRAW_levels on the primitive
  lod_nodes,  ///< MSFT_lod on the nodes, where it can tell of them
};

struct OutputSettings {
  Compression compression = Compression::keep;
  bool turns_corners = false;  ///< a compressed triangle may start at another of its corners
  LevelsAs levels = LevelsAs::extension;
  bool has_products = true;  ///< products of the scene are written with it
  friend bool operator==(const OutputSettings&, const OutputSettings&) = default;
};

}  // namespace foredraw
