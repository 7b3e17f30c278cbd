#pragma once
// What a glTF file's URIs say: data in themselves, or a file beside. Private to io.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw::gltf {

struct DataUri {
  std::string media_type;
  std::vector<std::byte> bytes;
};

bool is_data_uri(std::string_view uri);

/// nullopt where the URI is not well-formed.
std::optional<DataUri> decode_data_uri(std::string_view uri);

/// "my%20file.bin" to "my file.bin"; nullopt where a percent sign has no two hexadecimal digits after it.
std::optional<std::string> percent_decoded(std::string_view uri);

/// A relative path as a URI: everything but letters, digits and -._~/ is escaped.
std::string percent_encoded(std::string_view path);

}  // namespace foredraw::gltf
