#pragma once
// Parts of one glTF file in another document.

#include "gltf_document.h"

#include <filesystem>
#include <map>
#include <string>

namespace foredraw::bench {

/// Adds parts of a file to a document. Whatever they refer to is added when it is first referred to; of materials,
/// textures, samplers and images, those that the document has with equal content (whatever they are called) are not
/// added again. The document and the file have to live as long as this.
class GltfCopier {
 public:
  /// `folder`: where the file's images lie.
  GltfCopier(GltfDocument& to, const GltfDocument::Opened& from, std::filesystem::path folder)
      : to_(to), from_(from), folder_(std::move(folder)) {}

  /// Each of these gives the number in the document of what has this number in the file. A mesh gets the name that it
  /// is first asked for with.
  std::size_t mesh(std::size_t number, const std::string& name);
  std::size_t accessor(std::size_t number);

  /// Lists the extensions that the file says it uses, as far as what was added does.
  void list_extensions();

 private:
  std::size_t view(std::size_t number);
  std::size_t material(std::size_t number);
  std::size_t texture(std::size_t number);
  std::size_t image(std::size_t number);

  /// "baseColorTexture", "normalTexture" and all others, also those of extensions.
  void replace_textures(GltfDocument::Json& value);

  GltfDocument& to_;
  const GltfDocument::Opened& from_;
  const std::filesystem::path folder_;
  std::map<std::size_t, std::size_t> meshes_, accessors_, views_;
};

}  // namespace foredraw::bench
