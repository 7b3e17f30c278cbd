// STL written back: its triangles' records change places, byte for byte.
#include <foredraw/io/mesh/private/source.h>
#include <foredraw/io/mesh/private/stl.h>

namespace foredraw::mesh_files {

namespace {

/// From each "facet" to its "endfacet".
std::vector<std::string_view> facets(std::string_view text) {
  std::vector<std::string_view> found;
  std::string_view rest = without_mark(text);
  const char* begin = nullptr;
  for (std::string_view word = take_token(rest); !word.empty(); word = take_token(rest)) {
    const std::string lower = lower_case(word);
    if (lower == "solid" || lower == "endsolid") take_solid_name(rest);
    if (lower == "facet") {
      begin = word.data();
      for (int i = 0; i < 4; ++i) take_token(rest);  // the normal, which is read over, whatever it is
    }
    if (lower == "endfacet") found.emplace_back(begin, static_cast<std::size_t>(word.data() + word.size() - begin));
  }
  return found;
}

std::vector<std::string_view> records(std::string_view text, std::size_t count) {
  std::vector<std::string_view> found;
  for (std::size_t i = 0; i < count; ++i) found.push_back(text.substr(stl_header + i * stl_record, stl_record));
  return found;
}

}  // namespace

std::optional<std::string> reordered_stl(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  std::size_t count = 0;
  for (const DrawRecords& draw : source.records) {
    for (std::uint32_t face : draw.faces) count = std::max(count, std::size_t{face} + 1);
  }
  const auto places = is_binary_stl(text) ? records(text, count) : facets(text);
  if (places.size() < count) {
    diagnostics.error({.file = source.as_read.name}, "cannot-express", "its facets cannot be found again in the text",
                      "give the output the extension .glb");
    return std::nullopt;
  }
  const auto order = order_of(scene, source, {.faces = places.size()}, diagnostics);
  if (!order) return std::nullopt;
  std::string result;
  result.reserve(text.size());
  const char* done = text.data();
  for (std::size_t place = 0; place < places.size(); ++place) {
    result.append(done, places[place].data());
    result += places[order->faces[place]];
    done = places[place].data() + places[place].size();
  }
  return result.append(done, text.data() + text.size());
}

}  // namespace foredraw::mesh_files
