#pragma once
// Files with each extension that only Foredraw reads, and what has to hold where one is damaged.

#include <foredraw/io/gltf/gltf.h>

#include "support/gltf_builder.h"

#include <ostream>
#include <string>
#include <vector>

namespace foredraw::testing {

/// An extension, and what makes it.
struct OwnExtension {
  const char* name;
  const char* stages;
  const char* harmless = "";  ///< damages after which it still says something; a regular expression
  Scene (*scene)();
};

void PrintTo(const OwnExtension& extension, std::ostream* out);

std::vector<OwnExtension> own_extensions();

/// Those who name accessors.
std::vector<OwnExtension> own_extensions_with_streams();

GltfBuilder file_with(const OwnExtension& extension, Compression compression = Compression::none);

struct Damaged {
  std::string what;  ///< "primitive/radius is -1"
  std::vector<std::byte> glb;
};

bool is_harmless(const OwnExtension& extension, const Damaged& damaged);

/// The extension is left out where the damage does harm, in one warning that names it, and the file is whole else.
/// Strict reading refuses just those.
void expect_to_cost_itself_alone(const OwnExtension& extension, const Damaged& one);

}  // namespace foredraw::testing
