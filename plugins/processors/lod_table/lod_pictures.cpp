#include "lod_pictures.h"

#include <foredraw/frames/picture_losses.h>

#include <algorithm>

namespace foredraw {

namespace {

/// The images that a texture shows, as the scene's only ones.
void keep_image(std::optional<Texture>& texture, const Scene& from, Scene& to) {
  if (!texture || !texture->image || *texture->image >= from.images.size()) return;
  to.images.push_back(from.images[*texture->image]);
  texture->image = static_cast<ImageId>(to.images.size() - 1);
}

/// The draw in full detail, as it is bound, and nothing else.
Scene alone(const Scene& scene, DrawId id) {
  Scene made;
  Draw draw = scene.draws[id];
  draw.levels.resize(1);
  VertexStreams vertices = *draw.full().vertices;
  vertices.morph_targets.clear();
  std::erase_if(vertices.base, [](const VertexStream& stream) {
    return stream.semantic.starts_with("JOINTS_") || stream.semantic.starts_with("WEIGHTS_");
  });
  draw.full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  if (const Material* material = scene.material_of(draw)) {
    made.materials.push_back(*material);
    keep_image(made.materials[0].base_colour, scene, made);
    keep_image(made.materials[0].normal_map, scene, made);
    if (auto& displacement = made.materials[0].displacement) {
      std::optional<Texture> heights = displacement->texture;
      keep_image(heights, scene, made);
      displacement->texture = *heights;
    }
    draw.material = 0;
  }
  made.draws.push_back(std::move(draw));
  made.meshes.push_back({"", {0}, {}});
  made.nodes.push_back({});
  made.nodes[0].mesh = 0;
  return made;
}

}  // namespace

LodPictures lod_pictures(const Scene& scene, DrawId draw, Analyses& analyses, const Executor& executor) {
  const Scene one = alone(scene, draw);
  const FrameScene frames(one, analyses, executor);
  LodPictures pictures;
  if (frames.objects().empty()) return pictures;
  pictures.radius = frames.mesh_of(0).sphere.radius;
  if (!(pictures.radius > 0)) return pictures;
  pictures.coverage = std::clamp(frames.mesh_of(0).fill, 0.0, 1.0);
  pictures.accuracy = rendering_accuracies(frames, frame_moment(frames, 0), 0);
  return pictures;
}

}  // namespace foredraw
