#pragma once
// What a glTF file's URIs say: data in themselves, or a file beside. Private to io.

#include <cstddef>
#include <filesystem>
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

/// Why a decoded URI may not be opened as a file beside, or in a folder above where it `may_climb`; empty where it may.
std::string why_not_beside(std::string_view path, bool may_climb = false);
inline constexpr std::string_view leads_out = "leads out of the file's folder";

/// Whether the file, all symbolic links followed, lies in the folder.
bool lies_within(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace foredraw::gltf
