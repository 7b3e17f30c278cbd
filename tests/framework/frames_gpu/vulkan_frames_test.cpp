#include <foredraw/frames_gpu/vulkan_frames.h>

#include "support/levelled_field.h"
#include "support/on_device.h"
#include "support/sprite_scenes.h"

#include <foredraw/base/random.h>
#include <foredraw/frames/picture_error.h>
#include <foredraw/frames/surface_shading.h>
#include <foredraw/frames_gpu/private/uploaded_scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw::vulkan_frames_test {
namespace {

using testing::TestMesh;

constexpr FrameSize size{160, 120};

/// A scene with its frames, and how its objects are drawn: all that are seen, the nearest first.
struct Frame {
  Scene scene;
  Analyses analyses{testing::stored_texels()};
  Executor executor{1};
  FrameScene frames;
  FrameMoment moment;
  FrameCamera camera;
  std::vector<DrawnObject> objects;

  Frame(Scene of, const FrameCamera& from)
      : scene(std::move(of)), frames(scene, analyses, executor), moment(frame_moment(frames, 0)), camera(from) {
    for (const SeenObject& seen : seen_objects(frames, moment, camera, size)) objects.push_back({seen.object});
  }

  void draw_as(Rendering rendering) {
    for (DrawnObject& object : objects) object.rendering = rendering;
  }

  FramePicture reference(int samples = 1) const {
    ReferenceRenderer renderer(size, samples);
    renderer.draw(frames, moment, camera, objects);
    return renderer.picture();
  }
};

float stored(float linear) { return std::sqrt(std::clamp(linear, 0.0f, 1.0f)); }

/// Pixels of which a channel is more than two of 255 steps off.
std::size_t pixels_off(const FramePicture& a, const FramePicture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.colours.size(); ++i) {
    float most = 0;
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(stored(a.colours[i][c]) - stored(b.colours[i][c])));
    count += most > 2 / 255.0f ? 1 : 0;
  }
  return count;
}

std::size_t covered(const FramePicture& picture) {
  return static_cast<std::size_t>(
      std::ranges::count_if(picture.colours, [](const glm::vec3& c) { return glm::length(c - sky_colour) > 0.01f; }));
}

class VulkanFramesTest : public testing::OnDevice {
 protected:
  /// How far pictures may be from the reference's: in so many pixels, at edges and between mip levels; and in the root
  /// of the mean square.
  struct Allowed {
    std::size_t pixels = 20;
    double error = 0.002;  // half a step of 255
  };

  /// Draws by all renderings, and expects what the reference shows.
  void expect_the_same(Frame& frame, const Allowed& allowed) {
    VulkanFrames device(choice(), frame.frames, size);
    for (const Rendering rendering : all_renderings) {
      SCOPED_TRACE(std::string(to_text(rendering)));
      frame.draw_as(rendering);
      expect_the_same(device, frame, allowed);
    }
  }
  void expect_the_same(Frame& frame) { expect_the_same(frame, Allowed{}); }

  static void expect_the_same(VulkanFrames& device, const Frame& frame, const Allowed& allowed) {
    EXPECT_GT(device.draw(frame.moment, frame.camera, frame.objects), 0);
    const FramePicture drawn = device.picture(), reference = frame.reference();
    ASSERT_EQ(drawn.size, size);
    ASSERT_EQ(drawn.colours.size(), reference.colours.size());
    EXPECT_GT(covered(reference), 2000u);
    EXPECT_LE(pixels_off(drawn, reference), allowed.pixels);
    EXPECT_LT(picture_error(drawn, reference), allowed.error);
  }
};

template <class T>
Shared<std::byte> bytes_of(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return Shared<std::byte>({bytes.begin(), bytes.end()});
}

void change_vertices(Scene& scene, const std::function<void(VertexStreams&, const std::vector<glm::vec3>&)>& change) {
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  change(*vertices, decode_vec3(*vertices->find("POSITION")));
  scene.draws[0].full().vertices = vertices;
}

void add_normals(Scene& scene, const std::function<glm::vec3(const glm::vec3&)>& of) {
  change_vertices(scene, [&](VertexStreams& vertices, const std::vector<glm::vec3>& positions) {
    std::vector<glm::vec3> normals;
    for (const glm::vec3& p : positions) normals.push_back(of(p));
    vertices.base.push_back({"NORMAL", {Component::float32, 3, false, 12}, bytes_of(normals)});
  });
}

void add_places(Scene& scene, const std::function<glm::vec2(const glm::vec3&)>& of) {
  change_vertices(scene, [&](VertexStreams& vertices, const std::vector<glm::vec3>& positions) {
    std::vector<glm::vec2> places;
    for (const glm::vec3& p : positions) places.push_back(of(p));
    vertices.base.push_back({"TEXCOORD_0", {Component::float32, 2, false, 8}, bytes_of(places)});
  });
}

/// Of smooth colours around the middle, with an alpha that runs from one side to the other.
Image clouds(std::uint32_t width, std::uint32_t height, std::uint64_t seed, bool is_normal_map = false) {
  Random random(seed);
  std::vector<std::uint16_t> values;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double middle =
            is_normal_map ? (c < 2 ? 128 : 220) : 150 + 60 * std::sin(0.7 * x + c) * std::cos(0.5 * y);
        values.push_back(static_cast<std::uint16_t>(middle + 30 * (random.unit() - 0.5)));
      }
      values.push_back(static_cast<std::uint16_t>(255 * x / (width - 1)));
    }
  }
  return testing::texel_image({width, height, 4, 8}, values);
}

Texture texture_of(ImageId image, Wrap u = Wrap::repeat, Wrap v = Wrap::repeat) {
  Texture texture;
  texture.image = image;
  texture.wrap = {u, v};
  return texture;
}

/// A sheet of side 2 around the origin in the xy plane, of many triangles, that shows two images.
Scene sheet(float repeated = 1) {
  TestMesh mesh = testing::grid(24, 24);
  float width = 0;
  for (const glm::vec3& p : mesh.positions) width = std::max(width, p.x);
  for (glm::vec3& p : mesh.positions) p = {2 * p.x / width - 1, 2 * p.y / width - 1, 0};
  Scene scene = testing::scene_of(mesh);
  add_normals(scene, [](const glm::vec3& p) { return glm::vec3(0.3f * p.x, 0.3f * p.y, 1); });
  add_places(scene, [=](const glm::vec3& p) { return repeated * glm::vec2(0.5f + 0.5f * p.x, 0.5f - 0.5f * p.y); });
  scene.images = {clouds(20, 12, 1), clouds(16, 16, 2, true)};
  Material material;
  material.colour = {0.9f, 0.8f, 0.7f};
  material.base_colour = texture_of(0);
  material.normal_map = texture_of(1);
  material.normal_scale = 0.8f;
  scene.materials.push_back(material);
  scene.draws[0].material = 0;
  return scene;
}

const FrameCamera before = looking_at({0.3, 0.2, 2.2}, {0, 0, 0});

TEST_F(VulkanFramesTest, LevelsAndRenderings) {
  Frame frame(testing::levelled_field(6, 48, 4), looking_at({11, 6, 32}, {10, 0, 10}));
  ASSERT_GT(frame.objects.size(), 20u);
  VulkanFrames device(choice(), frame.frames, size);
  for (std::size_t i = 0; i < frame.objects.size(); ++i) {
    frame.objects[i].level = static_cast<std::uint32_t>(i % 6);  // the last ones are the coarsest
    frame.objects[i].rendering = all_renderings[i % all_renderings.size()];
  }
  expect_the_same(device, frame, {});
  const FramePicture mixed = device.picture();
  for (DrawnObject& object : frame.objects) object.level = 9;
  expect_the_same(device, frame, {});
  EXPECT_GT(picture_error(device.picture(), mixed), 0.01);
}

TEST_F(VulkanFramesTest, TexturesAndNormalMaps) {
  Frame frame(sheet(), before);
  expect_the_same(frame);
  frame.draw_as(Rendering::full);
  const FramePicture full = frame.reference();
  frame.draw_as(Rendering::without_normal_map);
  EXPECT_GT(picture_error(full, frame.reference()), 0.01);  // so that it is seen
}

TEST_F(VulkanFramesTest, MipLevelsFarAwayAndWhatLiesBeyondEdges) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored, Wrap::clamped}) {
    SCOPED_TRACE(static_cast<int>(wrap));
    Scene scene = sheet(wrap == Wrap::clamped ? 2 : 9);
    scene.materials[0].base_colour = texture_of(0, wrap, Wrap::mirrored);
    Frame frame(std::move(scene), before);
    expect_the_same(frame, {150, 0.003});  // the reference has a mip level for each triangle
  }
}

TEST_F(VulkanFramesTest, NearestTexels) {
  Scene scene = sheet();
  scene.materials[0].base_colour->is_nearest = true;
  Frame frame(std::move(scene), before);
  expect_the_same(frame);
}

TEST_F(VulkanFramesTest, Masks) {
  Scene scene = sheet(3);
  scene.materials[0].alpha_mode = AlphaMode::mask;
  scene.materials[0].alpha_cutoff = 0.4f;
  Node behind;
  behind.mesh = 0;
  behind.transform.translation = {0.2f, 0, -0.5f};
  scene.nodes.push_back(behind);
  Frame frame(std::move(scene), before);
  expect_the_same(frame, {40, 0.015});
}

TEST_F(VulkanFramesTest, BlendsTheFarthestFirst) {
  Scene scene = sheet();
  scene.materials[0].alpha_mode = AlphaMode::blend;
  scene.materials[0].alpha = 0.8f;
  for (int i = 1; i < 4; ++i) {
    Node behind;
    behind.mesh = 0;
    behind.transform.translation = {0.2f * static_cast<float>(i), 0, -0.5f * static_cast<float>(i)};
    scene.nodes.push_back(behind);
  }
  Frame frame(std::move(scene), before);
  ASSERT_EQ(frame.objects.size(), 4u);
  expect_the_same(frame);
  const FramePicture right = frame.reference();
  std::ranges::reverse(frame.objects);
  EXPECT_GT(picture_error(right, frame.reference()), 0.01);  // so that the sequence is seen
}

TEST_F(VulkanFramesTest, SidesAndMirrors) {
  for (const bool is_double_sided : {false, true}) {
    for (const float mirrored : {1.0f, -1.0f}) {
      for (const double side : {1.0, -1.0}) {
        SCOPED_TRACE(std::to_string(is_double_sided) + std::to_string(mirrored) + std::to_string(side));
        Scene scene = sheet();
        scene.materials[0].double_sided = is_double_sided;
        scene.nodes[0].transform.scale = {mirrored, 1.2f, 1};
        Frame frame(std::move(scene), looking_at({0.3, 0.2, side * 2.2}, {0, 0, 0}));
        if (is_double_sided || side > 0) {
          expect_the_same(frame);
        } else {
          VulkanFrames device(choice(), frame.frames, size);
          device.draw(frame.moment, frame.camera, frame.objects);
          EXPECT_EQ(covered(device.picture()), 0u);
          EXPECT_EQ(covered(frame.reference()), 0u);
        }
      }
    }
  }
}

/// The sheet, whose upper half a joint turns; a morph target bends it.
Scene posed_sheet(bool with_skin) {
  Scene scene = sheet();
  change_vertices(scene, [&](VertexStreams& vertices, const std::vector<glm::vec3>& positions) {
    std::vector<glm::vec3> offsets;
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    for (const glm::vec3& p : positions) {
      offsets.emplace_back(0, 0, 0.4f * p.x * p.x);
      joints.insert(joints.end(), {0, 1, 0, 0});
      const float upper = std::clamp(0.5f + p.y, 0.0f, 1.0f);
      weights.insert(weights.end(), {1 - upper, upper, 0, 0});
    }
    vertices.morph_targets = {{{"POSITION", {Component::float32, 3, false, 12}, bytes_of(offsets)}}};
    if (!with_skin) return;
    vertices.base.push_back({"JOINTS_0", {Component::uint8, 4, false, 4}, bytes_of(joints)});
    vertices.base.push_back({"WEIGHTS_0", {Component::float32, 4, false, 16}, bytes_of(weights)});
  });
  scene.nodes[0].weights = {0.9f};
  if (!with_skin) return scene;
  scene.nodes.resize(3);
  scene.nodes[0].skin = 0;
  scene.nodes[2].transform.translation = {0.4f, 0.1f, 0.3f};
  scene.skins.push_back({"skin", {1, 2}, {glm::mat4(1), glm::mat4(1)}});
  return scene;
}

TEST_F(VulkanFramesTest, VerticesInPose) {
  Frame skinned(posed_sheet(true), before), morphed(posed_sheet(false), before), at_rest(sheet(), before);
  expect_the_same(skinned);
  expect_the_same(morphed);
  EXPECT_GT(picture_error(skinned.reference(), at_rest.reference()), 0.02);
  EXPECT_GT(picture_error(morphed.reference(), at_rest.reference()), 0.02);
  EXPECT_GT(picture_error(skinned.reference(), morphed.reference()), 0.02);
}

TEST_F(VulkanFramesTest, VerticesInPoseOfMirroredNodes) {
  Scene scene = posed_sheet(false);
  scene.nodes[0].transform.scale.x = -1;
  Frame frame(std::move(scene), before);
  expect_the_same(frame);
}

TEST_F(VulkanFramesTest, NothingBeforeTheNearPlane) {
  // In the ring's tube, which reaches behind the camera.
  FrameCamera camera = looking_at({1, 0.1, 0}, {1, 0, 1});
  Scene scene = testing::scene_of(testing::torus(40, 20));
  scene.materials.emplace_back().double_sided = true;
  scene.draws[0].material = 0;
  Frame near(scene, camera);
  camera.near = 0.6;
  Frame far(scene, camera);
  expect_the_same(near);
  expect_the_same(far, {200, 0.025});  // the reference cuts a hundredth behind the plane
  EXPECT_GT(picture_error(near.reference(), far.reference()), 0.04);
}

TEST_F(VulkanFramesTest, FarFromTheOrigin) {
  Scene scene = sheet();
  scene.nodes[0].transform.translation = {4000, -300, 7000};
  Frame frame(std::move(scene), looking_at({4000.3, -299.8, 7002.2}, {4000, -300, 7000}));
  expect_the_same(frame);
}

TEST_F(VulkanFramesTest, SamplesMakeEdgesSmooth) {
  Frame frame(testing::scene_of(testing::sphere(32, 16)), before);
  VulkanFrames device(choice(), frame.frames, size, 4);
  device.draw(frame.moment, frame.camera, frame.objects);
  EXPECT_LT(picture_error(device.picture(), frame.reference(4)), 0.004);
  EXPECT_GT(picture_error(device.picture(), frame.reference(1)), 0.008);
}

TEST_F(VulkanFramesTest, EmptyFramesShowTheSky) {
  Frame frame(sheet(), before);
  VulkanFrames device(choice(), frame.frames, size);
  const std::vector<glm::vec3> sky(static_cast<std::size_t>(size.width * size.height), sky_colour);
  const auto is_sky = [&] { return pixels_off(device.picture(), {size, sky}) == 0; };
  EXPECT_TRUE(is_sky());
  device.draw(frame.moment, frame.camera, frame.objects);
  EXPECT_FALSE(is_sky());
  EXPECT_GT(device.draw(frame.moment, frame.camera, {}), 0);
  EXPECT_TRUE(is_sky());
  Frame nothing{Scene(), before};
  VulkanFrames empty(choice(), nothing.frames, size);
  empty.draw(nothing.moment, nothing.camera, {});
  EXPECT_EQ(covered(empty.picture()), 0u);
}

TEST_F(VulkanFramesTest, NamesTheDeviceAndTellsItsTime) {
  Frame frame(testing::levelled_field(2), looking_at({11, 6, 32}, {10, 0, 10}));
  VulkanFrames device(choice(), frame.frames, size);
  EXPECT_GT(device.draw(frame.moment, frame.camera, frame.objects), 0);
  EXPECT_FALSE(device.device_name().empty());
}

TEST_F(VulkanFramesTest, WhatIsNotFiniteIsLeftOut) {
  const TestMesh mesh{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {std::nanf(""), 0, 0}, {INFINITY, 0, 0}},
                      {0, 1, 3, 0, 1, 2, 0, 4, 2}};
  Frame frame(testing::scene_of(mesh), before);
  expect_the_same(frame);
  // Some devices leave it out by themselves, others show anything.
  gpu::Device device(choice());
  const gpu::OwnedSetLayout layout = gpu::texture_layout(device, 2);
  const UploadedScene uploaded(device, frame.frames, layout.get());
  EXPECT_EQ(uploaded.draws_of(0)[0].levels[0].index_count, 3u);
}

TEST_F(VulkanFramesTest, PicturesAreNotTooLarge) {
  const Frame frame(sheet(), before);
  for (const FrameSize wrong : {FrameSize{1 << 20, 16}, FrameSize{16, 1 << 20}, FrameSize{0, 16}, FrameSize{16, -1}}) {
    try {
      VulkanFrames(choice(), frame.frames, wrong);
      ADD_FAILURE() << wrong.width << " x " << wrong.height;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("another size"), std::string::npos) << error.what();
    }
  }
}

TEST(VulkanFramesDevice, HasToBeThere) {
  const Frame frame(sheet(), before);
  try {
    VulkanFrames(gpu::DeviceChoice{.device = "abacus"}, frame.frames, size);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), gpu::why_no_device({.device = "abacus"}));
  }
}

}  // namespace
}  // namespace foredraw::vulkan_frames_test
