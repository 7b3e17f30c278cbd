#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/modules/draws_for_c.h>

namespace foredraw::c {

namespace {

/// What callers see and the scene does not hold like that, made at the first ask.
const HeldScene::Lent& lent_of(const HeldScene& held, std::size_t number) {
  HeldScene::Lent& lent = held.lent[number];
  std::call_once(lent.once, [&] {
    const VertexStreams& vertices = *held.scene.draws[number].full().vertices;
    if (const VertexStream* positions = vertices.find("POSITION")) lent.positions = decode_vec3(*positions);
    lent.streams = streams_for_c(vertices);
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
    const IndexStream& stream = drawn.full().stream();
    *draw = draw_for_c(*drawn.full().vertices, stream.indices.view(),
                       lent.positions.empty() ? nullptr : &lent.positions.front().x, lent.streams,
                       stream.clusters ? &*stream.clusters : nullptr);
    draw->name = drawn.name.c_str();
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
