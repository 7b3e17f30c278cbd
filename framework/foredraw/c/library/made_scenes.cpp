#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/image/found_traits.h>
#include <foredraw/scene/triangle_draw.h>

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <stdexcept>

namespace foredraw::c {

namespace {

/// In C's numbers, from FOREDRAW_INT8 on.
constexpr std::array components = {Component::int8,   Component::uint8,  Component::int16,
                                   Component::uint16, Component::uint32, Component::float32};

/// Of what a caller handed over as one draw; std::invalid_argument says what is wrong with it.
class GivenDraw {
 public:
  GivenDraw(const foredraw_draw& given, std::string name) : given_(given), name_(std::move(name)) {}

  Draw draw() const {
    if (given_.size != sizeof(foredraw_draw)) {
      refuse(fmt::format("size is {}, but must be sizeof(foredraw_draw), {}", given_.size, sizeof(foredraw_draw)));
    }
    if (given_.cluster_count > 0) refuse("clusters cannot be given; set cluster_count to 0, and let a stage find them");
    if (given_.indices == nullptr && given_.triangle_count > 0)
      refuse("indices is NULL, but triangle_count is above 0");
    if (given_.positions == nullptr && given_.vertex_count > 0)
      refuse("positions is NULL, but vertex_count is above 0");
    if (given_.streams == nullptr && given_.stream_count > 0) refuse("streams is NULL, but stream_count is above 0");
    if (given_.triangle_count > most_triangles)
      refuse(fmt::format("{} triangles are too many; a draw has at most 2^31", given_.triangle_count));
    std::vector<glm::vec3> positions(given_.vertex_count);
    if (!positions.empty()) std::memcpy(positions.data(), given_.positions, positions.size() * sizeof(glm::vec3));
    std::vector<std::uint32_t> indices(3 * static_cast<std::size_t>(given_.triangle_count));
    if (!indices.empty()) std::memcpy(indices.data(), given_.indices, indices.size() * sizeof(std::uint32_t));
    std::vector<VertexStream> streams;
    for (std::uint32_t i = 0; i < given_.stream_count; ++i) streams.push_back(stream(given_.streams[i]));
    return triangle_draw(name_, positions, std::move(indices), std::move(streams));
  }

 private:
  static constexpr std::uint64_t most_triangles = std::uint64_t{1} << 31;

  [[noreturn]] void refuse(const std::string& what) const { throw std::invalid_argument(name_ + ": " + what); }

  VertexStream stream(const foredraw_stream& given) const {
    if (given.semantic == nullptr) refuse("a stream has no semantic");
    if (given.bytes == nullptr && given_.vertex_count > 0) refuse(fmt::format("{} is NULL", given.semantic));
    if (given.component < FOREDRAW_INT8 || given.component > FOREDRAW_FLOAT32) {
      refuse(fmt::format("{} has component type {}; expected FOREDRAW_INT8 to FOREDRAW_FLOAT32", given.semantic,
                         given.component));
    }
    if (given.components < 1 || given.components > 16) {
      refuse(fmt::format("{} has {} components; there must be 1 to 16", given.semantic, given.components));
    }
    Format format{components[given.component - FOREDRAW_INT8], static_cast<std::uint8_t>(given.components),
                  given.normalized != 0, 0};
    format.bytes = static_cast<std::uint16_t>(bytes_of(format.component) * given.components);
    const std::size_t stride = given.stride == 0 ? format.bytes : given.stride;
    std::vector<std::byte> bytes(std::size_t{given_.vertex_count} * format.bytes);
    for (std::size_t i = 0; i < given_.vertex_count; ++i) {
      std::memcpy(bytes.data() + i * format.bytes, static_cast<const std::byte*>(given.bytes) + i * stride,
                  format.bytes);
    }
    return {given.semantic, format, Shared<std::byte>(std::move(bytes))};
  }

  const foredraw_draw& given_;
  std::string name_;
};

}  // namespace

}  // namespace foredraw::c

using namespace foredraw;
using namespace foredraw::c;

int foredraw_make_scene(foredraw_context* context, const foredraw_draw* draws, uint64_t draw_count,
                        foredraw_scene** scene, foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (scene != nullptr) *scene = nullptr;
    if (context == nullptr || (draws == nullptr && draw_count > 0) || scene == nullptr) return FOREDRAW_NULL_POINTER;
    Scene made;
    try {
      for (std::uint32_t i = 0; i < draw_count; ++i) {
        const std::string name = draws[i].name == nullptr ? fmt::format("draw {}", i) : draws[i].name;
        made.draws.push_back(GivenDraw(draws[i], name).draw());
        made.meshes.push_back({.name = name, .draws = {i}});
        made.nodes.push_back({.name = name, .mesh = i});
      }
    } catch (const std::invalid_argument& wrong) {
      Diagnostics diagnostics;
      diagnostics.error({}, "bad-draw", wrong.what());
      put(diagnostics, problems);
      return FOREDRAW_MISTAKE;
    }
    find_traits(made);
    *scene = new foredraw_scene{std::make_shared<const HeldScene>(std::move(made), FileRecord{})};
    return FOREDRAW_DONE;
  });
}
