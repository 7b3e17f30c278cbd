#include <foredraw/frames/reference_machine.h>

#include <foredraw/frames/reference_renderer.h>

#include <ctime>
#include <map>
#include <memory>
#include <tuple>

namespace foredraw {

namespace {

VertexStream stream_of(const char* semantic, const std::vector<float>& values, std::uint8_t components) {
  const auto bytes = std::as_bytes(std::span(values));
  const auto row = static_cast<std::uint16_t>(components * sizeof(float));
  return {semantic, {Component::float32, components, false, row}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// A square from (0, 0) to (1, 1), seen from +Z.
Draw square(std::uint32_t squares, bool shares_vertices, bool is_posed) {
  std::vector<float> positions, normals, places, joints, weights;
  const auto add = [&](std::uint32_t column, std::uint32_t row) {
    const float x = static_cast<float>(column) / static_cast<float>(squares),
                y = static_cast<float>(row) / static_cast<float>(squares);
    positions.insert(positions.end(), {x, y, 0});
    normals.insert(normals.end(), {0, 0, 1});
    places.insert(places.end(), {x, y});
    joints.insert(joints.end(), {0, 1, 2, 3});
    weights.insert(weights.end(), {0.25f, 0.25f, 0.25f, 0.25f});
    return static_cast<std::uint32_t>(positions.size() / 3 - 1);
  };
  if (shares_vertices) {
    for (std::uint32_t row = 0; row <= squares; ++row) {
      for (std::uint32_t column = 0; column <= squares; ++column) add(column, row);
    }
  }
  const auto vertex = [&](std::uint32_t column, std::uint32_t row) {
    return shares_vertices ? row * (squares + 1) + column : add(column, row);
  };
  std::vector<std::uint32_t> indices;
  for (std::uint32_t row = 0; row < squares; ++row) {
    for (std::uint32_t column = 0; column < squares; ++column) {
      for (const auto& [right, up] : {std::pair{0u, 0u}, {1u, 0u}, {1u, 1u}, {0u, 0u}, {1u, 1u}, {0u, 1u}}) {
        indices.push_back(vertex(column + right, row + up));
      }
    }
  }
  VertexStreams vertices;
  vertices.count = static_cast<std::uint32_t>(positions.size() / 3);
  vertices.base = {stream_of("POSITION", positions, 3), stream_of("NORMAL", normals, 3),
                   stream_of("TEXCOORD_0", places, 2)};
  if (is_posed) {
    vertices.base.push_back(stream_of("JOINTS_0", joints, 4));
    vertices.base.push_back(stream_of("WEIGHTS_0", weights, 4));
  }
  Draw draw;
  draw.name = "square";
  draw.material = 0;
  draw.levels.resize(1);
  draw.full().vertices = std::make_shared<const VertexStreams>(std::move(vertices));
  draw.full().orders.resize(1);
  draw.full().stream().indices = Shared<std::uint32_t>(std::move(indices));
  return draw;
}

/// Of 64 x 64 texels of made-up colours, or of normals that lean a little.
Texels texels(const Image& image) {
  constexpr std::uint32_t edge = 64;
  Texels made;
  made.facts = {edge, edge, 3, 8, false};
  for (std::uint32_t i = 0; i < edge * edge; ++i) {
    const std::uint32_t mixed = i * 2654435761u >> 16;
    const std::array<std::uint32_t, 3> colour = {mixed % 200, mixed / 3 % 200, mixed / 7 % 200};
    const std::array<std::uint32_t, 3> normal = {110 + mixed % 36, 110 + mixed / 3 % 36, 250};
    for (const std::uint32_t channel : image.name == "normals" ? normal : colour) {
      made.bytes.push_back(static_cast<std::byte>(channel));
    }
  }
  return made;
}

Image image_called(const std::string& name) {
  Image image;
  image.name = name;
  image.uri = name;
  return image;
}

/// What a frame draws, ready to be drawn again and again.
class Shown {
 public:
  explicit Shown(const CalibrationFrame& frame)
      : analyses_([](const Image& image) { return texels(image); }),
        executor_(1),
        scene_(scene_of(frame)),
        frames_(scene_, analyses_, executor_),
        moment_(frame_moment(frames_, 0)) {
    constexpr double half = calibration_picture / 2.0;
    camera_ = looking_at({half, half, 1000}, {half, half, 0});  // a unit is a pixel
    camera_.half_height = half / 1000;
  }

  FrameSample draw(ReferenceRenderer& renderer, const CalibrationFrame& frame) const {
    std::vector<DrawnObject> objects;
    for (std::uint32_t i = 0; i < frame.objects; ++i) objects.push_back({i, 0, frame.rendering});
    const std::clock_t begin = std::clock();  // of this process alone, whatever else the machine does
    renderer.draw(frames_, moment_, camera_, objects);
    const std::clock_t end = std::clock();
    FrameSample sample;
    sample.nanoseconds = 1e9 * static_cast<double>(end - begin) / CLOCKS_PER_SEC;
    for (const Rendering rendering : all_renderings) {
      const DrawnWork& work = renderer.work()[static_cast<std::size_t>(rendering)];
      if (work.draws == 0) continue;
      sample.drawn.push_back({rendering, static_cast<double>(work.triangles), static_cast<double>(work.vertices),
                              static_cast<double>(work.samples), static_cast<double>(work.draws),
                              frame.is_posed ? static_cast<double>(work.vertices) : 0.0});
    }
    return sample;
  }

 private:
  static Scene scene_of(const CalibrationFrame& frame) {
    Scene scene;
    scene.name = "calibration";
    scene.images = {image_called("colours"), image_called("normals")};
    scene.materials.resize(1);
    scene.materials[0].base_colour.emplace().image = 0;
    scene.materials[0].normal_map.emplace().image = 1;
    scene.draws.push_back(square(frame.squares, frame.shares_vertices, frame.is_posed));
    scene.meshes.push_back({"square", {0}, {}});
    const std::uint32_t in_a_row = calibration_picture / frame.pixels;
    for (std::uint32_t i = 0; i < frame.objects; ++i) {
      Node node;
      node.mesh = 0;
      node.transform.translation = glm::vec3(static_cast<float>(i % in_a_row * frame.pixels),
                                             static_cast<float>(i / in_a_row * frame.pixels), 0);
      node.transform.scale = glm::vec3(static_cast<float>(frame.pixels));
      if (frame.is_posed) node.skin = i;
      scene.nodes.push_back(node);
    }
    for (std::uint32_t i = 0; i < frame.objects && frame.is_posed; ++i) {  // joints stand where the object would
      Skin skin;
      for (int joint = 0; joint < 4; ++joint) {
        Node node = scene.nodes[i];
        node.mesh.reset();
        node.skin.reset();
        skin.joints.push_back(static_cast<NodeId>(scene.nodes.size()));
        skin.inverse_bind_matrices.emplace_back(1);
        scene.nodes.push_back(node);
      }
      scene.skins.push_back(std::move(skin));
    }
    return scene;
  }

  Analyses analyses_;
  Executor executor_;
  Scene scene_;
  FrameScene frames_;
  FrameMoment moment_;
  FrameCamera camera_;
};

class Machine {
 public:
  FrameSample operator()(const CalibrationFrame& frame) {
    const auto key = std::tuple(frame.objects, frame.squares, frame.shares_vertices, frame.pixels, frame.is_posed);
    std::unique_ptr<Shown>& shown = shown_[key];
    if (shown == nullptr) shown = std::make_unique<Shown>(frame);
    return shown->draw(renderer_, frame);
  }

 private:
  ReferenceRenderer renderer_{{calibration_picture, calibration_picture}};
  std::map<std::tuple<std::uint32_t, std::uint32_t, bool, std::uint32_t, bool>, std::unique_ptr<Shown>> shown_;
};

}  // namespace

MeasuredMachine reference_machine() {
  return [machine = std::make_shared<Machine>()](const CalibrationFrame& frame) { return (*machine)(frame); };
}

}  // namespace foredraw
