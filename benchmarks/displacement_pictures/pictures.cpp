#include "pictures.h"

#include <foredraw/io/image/images.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/technique/built_in_plugins.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace foredraw::bench {

Scene after(const std::string& stages, const Scene& scene) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  const auto plan = foredraw::plan(*parse_line(stages, diagnostics), registry, scene, diagnostics);
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  const Executor executor;
  Analyses analyses(image_decoder({}));
  Result result = optimize(*plan, scene, {executor, analyses});
  if (result.failed) throw std::runtime_error(stages + " fails");
  return std::move(result.scene);
}

Placed placed(const Scene& scene) {
  const Executor executor;
  Analyses analyses(image_decoder({}));
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  if (frames.objects().size() != 1) throw std::runtime_error("the scene shows more or less than one object");
  return {moment.world[0], moment.bounds[0].sphere};
}

FramePicture drawn(Scene scene, const FrameCamera& camera, FrameSize size) {
  for (Material& material : scene.materials) material.displacement.reset();  // the triangles as they are
  const Executor executor;
  Analyses analyses(image_decoder({}));
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  std::vector<DrawnObject> objects;
  for (const SeenObject& seen : seen_objects(frames, moment, camera, size)) objects.push_back({seen.object});
  ReferenceRenderer renderer(size, 3);
  renderer.draw(frames, moment, camera, objects);
  return renderer.picture();
}

void write_png(const std::filesystem::path& path, const std::vector<FramePicture>& pictures) {
  int width = 0;
  for (const FramePicture& picture : pictures) width += picture.size.width;
  const int height = pictures.front().size.height;
  Texels texels{{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 3, 8}, {}};
  for (int y = 0; y < height; ++y) {
    for (const FramePicture& picture : pictures) {
      for (int x = 0; x < picture.size.width; ++x) {
        const glm::vec3& colour = picture.colours[static_cast<std::size_t>(y * picture.size.width + x)];
        for (int c = 0; c < 3; ++c)
          texels.bytes.push_back(
              static_cast<std::byte>(std::lround(255 * std::sqrt(std::clamp(colour[c], 0.0f, 1.0f)))));
      }
    }
  }
  const std::vector<std::byte> png = encode_png(texels);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace foredraw::bench
