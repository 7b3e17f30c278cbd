// Ways against jagged edges: how far from the truth, how much they flicker, what of wires is broken and how much ink is
// drawn, on scenes made for them and on models after pipelines.
//
//   antialiasing-bench [--frames=12] [--views=12] [--truth=256] [--step=0.43] [--unlit] [--pictures=FOLDER]
//                      [SCENE...]
//                      [MODEL.glb PIPELINE]...
//
// SCENE is a part of a scene's name; without any, and without models, all scenes are measured. PIPELINE may be "-".
// Models are lit, or, with --unlit, of one colour a surface. Steps are pixels from frame to frame. Tab-separated. With
// a folder, a strip of pictures is written for each scene: none, four samples, what is made for it, and the truth; 64 x
// 64 pixels of each, three times as large.

#include "support/meshes.h"
#include "support/thin_scenes.h"

#include <evaluators/antialiasing/antialiasing.h>
#include <foredraw/frames/picture_error.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/image/picture.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/shells/second_depth.h>
#include <foredraw/technique/built_in_plugins.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::bench {
namespace {

using testing::ThinMesh;

struct Settings {
  int frames = 12, views = 12, truth = 256;
  bool is_unlit = false;  ///< models, of one colour a surface
  double step = 0.43;     ///< pixels
  std::string pictures;
};

constexpr FrameSize size{256, 256};
constexpr glm::dvec2 slide{0.849, 0.528};  ///< of length 1

/// A scene of one colour, so that nothing is told but how edges are drawn.
struct Case {
  std::string name;
  std::function<ThinMesh()> mesh;
  bool has_wires = false;
  bool is_closed = false;
  bool is_lit = false;
  FrameCamera camera = testing::pixel_camera(size);
  double step = 1;  ///< units that the camera slides for a pixel
};

ThinMesh thin(const testing::TestMesh& mesh) {
  return {mesh.positions, mesh.indices, std::vector<glm::vec4>(mesh.positions.size(), glm::vec4(0)),
          std::vector<glm::vec4>(mesh.positions.size(), glm::vec4(0))};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const float radius : {0.02f, 0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.7f, 1.0f}) {
    all.push_back(
        {fmt::format("lines r {:.2f}", radius), [=] { return testing::lines_at_all_angles(radius, size); }, true});
  }
  for (const float radius : {0.1f, 0.35f, 0.7f}) {
    all.push_back({fmt::format("lit lines r {:.2f}", radius),
                   [=] { return testing::lines_at_all_angles(radius, size); }, true, false, true});
  }
  for (const float breadth : {0.05f, 0.2f}) {
    all.push_back({fmt::format("ribbons b {:.2f}", breadth),
                   [=] { return testing::ribbons_at_all_angles(breadth, size); }, true});
  }
  all.push_back({"road", [] { return testing::road_wires(0.01f); }, true, false, false, testing::road_camera(),
                 1 / testing::road_camera().pixels_a_unit(40, size)});
  for (const float radius : {0.05f, 0.2f}) {
    all.push_back(
        {fmt::format("crossing r {:.2f}", radius), [=] { return testing::crossing_wires(radius, 90); }, true});
  }
  for (const float edge : {70.0f, 40.0f, 16.0f}) {
    all.push_back({fmt::format("box {:.0f}", edge), [=] { return testing::turned_box(edge); }, false, true});
  }
  for (const float width : {1.0f, 2.0f, 3.0f, 4.0f, 6.0f}) {
    all.push_back({fmt::format("bars {:.0f}", width), [=] { return testing::bars(width, size); }, false, true});
  }
  for (const int sides : {12, 96}) {
    all.push_back(
        {fmt::format("cylinder {} sides", sides), [=] { return testing::cylinder(30, sides, 120); }, false, true});
  }
  for (const std::uint32_t stacks : {24u, 48u}) {
    all.push_back({fmt::format("sphere {}x{}", stacks, 2 * stacks),
                   [=] {
                     return thin(testing::sphere(2 * stacks, stacks, 40, {0.3f, -0.2f, 0}));
                   },
                   false, true});
  }
  all.push_back({"grass cards", [] { return testing::grass_cards(60, 5, size); }});
  return all;
}

/// The middle of each picture, magnified, one beside the other.
void write_strip(const std::string& folder, const std::string& name, const Antialiasing& found) {
  using enum evaluators::antialiasing::Way;
  constexpr int crop = 64, times = 3, gap = 6, edge = crop * times;
  std::vector<const FramePicture*> pictures;
  for (const evaluators::antialiasing::Way way : {none, msaa_4, second_depth, wire_clamp_msaa_4, wire_coverage}) {
    const auto of = std::ranges::find(found.ways, way, &Antialiasing::OfWay::way);
    if (of != found.ways.end() && (way != second_depth || !found.has_wires)) pictures.push_back(&of->picture);
  }
  pictures.push_back(&found.truth);
  const int width = static_cast<int>(pictures.size()) * (edge + gap) - gap;
  std::vector<std::uint8_t> strip(static_cast<std::size_t>(3 * width * edge), 255);
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    const std::vector<std::uint8_t> from = as_rgb(*pictures[p]);
    const FrameSize whole = pictures[p]->size;
    for (int y = 0; y < edge; ++y) {
      for (int x = 0; x < edge; ++x) {
        const int row = (whole.height - crop) / 2 + y / times, column = (whole.width - crop) / 2 + x / times;
        const int to = y * width + static_cast<int>(p) * (edge + gap) + x;
        std::copy_n(&from[static_cast<std::size_t>(3 * (row * whole.width + column))], 3,
                    &strip[static_cast<std::size_t>(3 * to)]);
      }
    }
  }
  std::string file = name.substr(0, name.find(", "));
  std::ranges::replace_if(
      file, [](char c) { return c == ' ' || c == '.'; }, '-');
  const std::vector<std::byte> png = images::png_of_pixels(width, edge, strip);
  std::ofstream(folder + "/" + file + ".png", std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
}

void print(const std::string& name, const Antialiasing& found, const Settings& settings) {
  if (!settings.pictures.empty()) write_strip(settings.pictures, name, found);
  for (const Antialiasing::OfWay& of : found.ways) {
    fmt::print("{}\t{}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.1f}\t{:+.1f}\t{:.4f}\n", name, to_text(of.way),
               of.rmse.value, of.rmse.error, of.flicker.value, of.flicker.error, 100 * of.broken.value,
               100 * of.ink.value, found.floor.value);
  }
  std::fflush(stdout);
}

/// Every frame is a view of its own for the errors, but for flicker, which needs two.
SlidingViews in_pairs(const std::vector<FrameCamera>& frames) {
  SlidingViews views;
  for (std::size_t f = 0; f + 1 < frames.size(); f += 2) views.push_back({frames[f], frames[f + 1]});
  return views;
}

std::vector<std::uint32_t> all_triangles(const Scene& scene) {
  std::vector<std::uint32_t> closed;
  for (const Draw& draw : scene.draws)
    closed.push_back(static_cast<std::uint32_t>(draw.full().stream().triangle_count()));
  return closed;
}

void measure(const Case& of, const Settings& settings, const Executor& executor) {
  const Scene scene =
      testing::scene_of(of.mesh(), of.is_lit ? glm::vec3(0.8f) : glm::vec3(0.05f, 0.04f, 0.03f), of.has_wires);
  Analyses analyses;
  const FrameScene frames(scene, analyses, executor);
  const std::vector<std::uint32_t> closed =
      of.is_closed ? all_triangles(scene) : std::vector<std::uint32_t>(scene.draws.size());
  // Wires of one colour; bodies are lit, or no inner edge of them would show.
  AntialiasingOptions options{.size = size,
                              .truth_samples = settings.truth,
                              .rendering = of.has_wires && !of.is_lit ? Rendering::unlit : Rendering::full,
                              .closed = &closed};
  SlidingViews views;
  if (of.has_wires) {
    views = in_pairs(testing::sliding(of.camera, settings.frames, slide * (settings.step * of.step)));
  } else {
    for (const FrameCamera& camera : testing::pixel_cameras_around(size, settings.views)) {
      views.push_back(testing::sliding(camera, 2, slide * settings.step));
    }
  }
  print(of.name, *antialiasing(frames, frame_moment(frames, 0), views, options, executor), settings);
}

/// The scene after the pipeline, or as it is read where that is "-".
Scene made(const std::string& model, const std::string& line, const Executor& executor) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(model, diagnostics);
  if (!scene) throw std::runtime_error(to_text(diagnostics));
  if (line == "-") return *scene;
  Registry registry;
  add_built_in_plugins(registry);
  auto pipeline = load_pipeline(line, diagnostics);
  if (pipeline) pipeline->measure.clear();
  const auto plan = pipeline ? foredraw::plan(*pipeline, registry, *scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  Analyses analyses(image_decoder({}));
  return optimize(*plan, *scene, {executor, analyses}).scene;
}

void measure_model(const std::string& model, const std::string& line, const Settings& settings,
                   const Executor& executor) {
  const Scene scene = made(model, line, executor);
  Analyses analyses(image_decoder({}));
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  const std::string name = model.substr(model.rfind('/') + 1);
  std::vector<std::uint32_t> closed(scene.draws.size());
  const auto* product = scene.products.find<SecondDepth>();
  if (product != nullptr) {
    for (const SecondDepth::OfDraw& of : product->draws) closed[of.draw] = of.triangles;
  }
  for (const double across : {205.0, 66.0}) {
    const int edge = static_cast<int>(across * 1.25);
    AntialiasingOptions options{.size = {edge, edge},
                                .truth_samples = settings.truth,
                                .rendering = settings.is_unlit ? Rendering::unlit : Rendering::full,
                                .closed = product != nullptr ? &closed : nullptr};
    const auto views = sliding_views(frames, moment, options.size, across, settings.views, 3, settings.step, 20260101);
    print(fmt::format("{} {:.0f} px, {}", name, across, line), *antialiasing(frames, moment, views, options, executor),
          settings);
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int count, char** arguments) {
  using namespace foredraw;
  bench::Settings settings;
  std::vector<std::string> words;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto value = [&] { return std::stoi(word.substr(word.find('=') + 1)); };
    if (word.starts_with("--frames="))
      settings.frames = value();
    else if (word.starts_with("--views="))
      settings.views = value();
    else if (word.starts_with("--truth="))
      settings.truth = value();
    else if (word.starts_with("--step="))
      settings.step = std::stod(word.substr(word.find('=') + 1));
    else if (word == "--unlit")
      settings.is_unlit = true;
    else if (word.starts_with("--pictures="))
      settings.pictures = word.substr(word.find('=') + 1);
    else
      words.push_back(word);
  }
  const Executor executor;
  fmt::print("scene\tway\trmse\t±\tflicker\t±\tbroken %\tink %\tfloor\n");
  for (const bench::Case& of : bench::cases()) {
    const bool is_named =
        std::ranges::any_of(words, [&](const std::string& word) { return of.name.find(word) != std::string::npos; });
    if (words.empty() || is_named) bench::measure(of, settings, executor);
  }
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i].ends_with(".glb")) bench::measure_model(words[i], words[i + 1], settings, executor);
  }
}
