#pragma once
#include <map>
#include <string>
#include <string_view>

namespace foredraw {

/// The JSON form of a report of the same work under other names: files by the paths that they have now, and the
/// pipeline as it is written now.
std::string readdressed(std::string_view report, const std::map<std::string, std::string>& paths,
                        const std::string& pipeline);

}  // namespace foredraw
