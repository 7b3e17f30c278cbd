#include <foredraw/viewing/shown_scene.h>

#include <foredraw/displaced/displaced_streams.h>
#include <foredraw/viewing/displaced_draw.h>

namespace foredraw {

std::unique_ptr<const Scene> shown_scene(const Scene& scene, Analyses& analyses) {
  std::unique_ptr<Scene> shown;
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const Draw& draw = scene.draws[id];
    if (draw.topology != Topology::triangles) continue;
    const auto displaced = displaced_draw_of(scene, id, analyses);
    if (displaced == nullptr) continue;
    if (shown == nullptr) shown = std::make_unique<Scene>(scene);
    const Material* material = scene.material_of(draw);
    const Level& level = draw.full();
    VertexStreams vertices =
        displaced_streams(*level.vertices, level.stream().indices.view(), displaced->directions, displaced->mesh,
                          displaced->displacements, material != nullptr && material->normal_map.has_value());
    Draw& made = shown->draws[id];
    made.full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
    made.full().orders = {IndexStream{.indices = Shared(std::vector(displaced->mesh.indices))}};
    made.traits.remove(traits::displaced);
  }
  return shown;
}

}  // namespace foredraw
