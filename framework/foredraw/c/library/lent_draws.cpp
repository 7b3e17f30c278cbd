#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>

namespace foredraw::c {

namespace {

std::uint32_t number_of(Component component) {
  switch (component) {
    case Component::int8: return FOREDRAW_INT8;
    case Component::uint8: return FOREDRAW_UINT8;
    case Component::int16: return FOREDRAW_INT16;
    case Component::uint16: return FOREDRAW_UINT16;
    case Component::uint32: return FOREDRAW_UINT32;
    case Component::float32: return FOREDRAW_FLOAT32;
  }
  return 0;
}

/// What callers see and the scene does not hold like that, made at the first ask.
const HeldScene::Lent& lent_of(const HeldScene& held, std::size_t number) {
  HeldScene::Lent& lent = held.lent[number];
  std::call_once(lent.once, [&] {
    for (const VertexStream& stream : held.scene.draws[number].full().vertices->base) {
      if (stream.semantic == "POSITION") {
        for (const glm::vec3& place : decode_vec3(stream)) {
          lent.positions.insert(lent.positions.end(), {place.x, place.y, place.z});
        }
      } else {
        lent.streams.push_back({stream.semantic.c_str(), stream.bytes.view().data(), stream.format.bytes,
                                number_of(stream.format.component), stream.format.components,
                                stream.format.normalized});
      }
    }
  });
  return lent;
}

}  // namespace

}  // namespace foredraw::c

using namespace foredraw;
using namespace foredraw::c;

uint64_t foredraw_scene_draws(const foredraw_scene* scene) {
  return scene == nullptr ? 0 : scene->held->scene.draws.size();
}

int foredraw_scene_draw(const foredraw_scene* scene, uint64_t number, foredraw_draw* draw) {
  return at_border(nullptr, [&]() -> int {
    if (scene == nullptr || draw == nullptr) return FOREDRAW_NULL_POINTER;
    const HeldScene& held = *scene->held;
    if (draw->size != sizeof *draw || number >= held.scene.draws.size()) return FOREDRAW_MISTAKE;
    const Draw& drawn = held.scene.draws[number];
    if (drawn.topology != Topology::triangles) return FOREDRAW_MISTAKE;
    const HeldScene::Lent& lent = lent_of(held, number);
    const Level& full = drawn.full();
    *draw = {.size = sizeof *draw,
             .vertex_count = full.vertices->count,
             .triangle_count = full.stream().triangle_count(),
             .name = drawn.name.c_str(),
             .indices = full.stream().indices.view().data(),
             .positions = lent.positions.data(),
             .stream_count = static_cast<std::uint32_t>(lent.streams.size()),
             .streams = lent.streams.data()};
    return FOREDRAW_DONE;
  });
}

int foredraw_scene_moves(const foredraw_scene* scene, uint64_t number, const uint32_t** triangles,
                         const uint32_t** vertices, uint64_t* vertex_count) {
  if (scene == nullptr) return FOREDRAW_NULL_POINTER;
  if (number >= scene->held->scene.draws.size()) return FOREDRAW_MISTAKE;
  const Level& full = scene->held->scene.draws[number].full();
  const auto lend = [](const Shared<std::uint32_t>& numbers) {
    return numbers.empty() ? nullptr : numbers.view().data();
  };
  if (triangles != nullptr) *triangles = lend(full.stream().triangle_origin);
  if (vertices != nullptr) *vertices = lend(full.vertex_destination);
  if (vertex_count != nullptr) {
    *vertex_count = full.vertex_destination.empty() ? full.vertices->count : full.vertex_destination.size();
  }
  return FOREDRAW_DONE;
}

foredraw_scene* foredraw_scene_copy(const foredraw_scene* scene) {
  return scene == nullptr ? nullptr : new (std::nothrow) foredraw_scene(*scene);
}

void foredraw_scene_free(foredraw_scene* scene) { delete scene; }
