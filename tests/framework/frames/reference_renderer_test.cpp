#include <foredraw/frames/reference_renderer.h>

#include "support/levelled_field.h"
#include "support/sprite_scenes.h"

#include <foredraw/frames/picture_error.h>
#include <foredraw/frames/surface_shading.h>

#include <gtest/gtest.h>

namespace foredraw::reference_renderer_test {
namespace {

using testing::TestMesh;

constexpr FrameSize size{64, 48};

/// A scene drawn whole, nearest first.
FramePicture drawn(const Scene& scene, const FrameCamera& camera, Rendering rendering = Rendering::full,
                   FrameStyle style = FrameStyle::lit, int samples = 1, FrameWork* work = nullptr,
                   std::uint32_t level = 0, Analyses&& analyses = {}) {
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  std::vector<DrawnObject> objects;
  for (const SeenObject& seen : seen_objects(frames, moment, camera, size)) {
    objects.push_back({seen.object, level, rendering});
  }
  ReferenceRenderer renderer(size, samples);
  renderer.draw(frames, moment, camera, objects, style);
  if (work != nullptr) *work = renderer.work();
  return renderer.picture();
}

glm::vec3 at(const FramePicture& picture, int x, int y) {
  return picture.colours[static_cast<std::size_t>(y * picture.size.width + x)];
}

bool is_sky(const glm::vec3& colour) { return colour == sky_colour; }

std::size_t covered(const FramePicture& picture) {
  return static_cast<std::size_t>(
      std::ranges::count_if(picture.colours, [](const glm::vec3& c) { return !is_sky(c); }));
}

/// A square of side 2 around the origin in the xy plane, seen from z > 0, with the colour; more squares behind it.
Scene square(const glm::vec3& colour = {1, 1, 1}) {
  const TestMesh mesh{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 3}};
  Scene scene = testing::scene_of(mesh);
  Material material;
  material.colour = colour;
  scene.materials.push_back(material);
  scene.draws[0].material = 0;
  return scene;
}

/// With a stream of so many floats a vertex.
void add_stream(Scene& scene, const char* semantic, std::uint8_t components, const std::vector<float>& values) {
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  const auto bytes = std::as_bytes(std::span(values));
  vertices->base.push_back({semantic,
                            {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)},
                            Shared<std::byte>({bytes.begin(), bytes.end()})});
  scene.draws[0].full().vertices = vertices;
}

FrameCamera before_square(double distance) { return looking_at({0, 0, distance}, {0, 0, 0}); }

TEST(ReferenceRenderer, CoversWhatItShould) {
  // At distance d the picture is 2 * d * tan(30) units high.
  const double distance = 4;
  const double side = 2 * size.height / (2 * distance * 0.5773502691896258);
  const FramePicture picture = drawn(square(), before_square(distance));
  EXPECT_NEAR(static_cast<double>(covered(picture)), side * side, 2 * side + 1);
  EXPECT_FALSE(is_sky(at(picture, 32, 24)));
  EXPECT_TRUE(is_sky(at(picture, 1, 1)));
}

TEST(ReferenceRenderer, IsUpright) {
  Scene scene = square();
  scene.nodes[0].transform.translation = {2, 1.2f, 0};  // to the right, and up
  const FramePicture picture = drawn(scene, before_square(5));
  EXPECT_FALSE(is_sky(at(picture, 50, 14)));
  EXPECT_TRUE(is_sky(at(picture, 14, 34)));
}

TEST(ReferenceRenderer, NeighboursShareNoSampleAndLeaveNone) {
  // A curved sheet of many triangles before a camera inside of its hull, cut by the picture's edges and the near plane.
  TestMesh sheet = testing::grid(40, 40);
  float width = 0;
  for (const glm::vec3& p : sheet.positions) width = std::max(width, p.x);
  for (glm::vec3& p : sheet.positions) {
    p = {20 * p.x / width - 10, 20 * p.y / width - 10, -3 + 0.4f * std::sin(40 * p.x / width)};
  }
  FrameWork work;
  Scene scene = testing::scene_of(sheet);
  FrameCamera camera;
  const FramePicture picture = drawn(scene, camera, Rendering::full, FrameStyle::lit, 1, &work);
  EXPECT_EQ(covered(picture), picture.colours.size());
  EXPECT_EQ(work[0].samples, picture.colours.size());  // each is covered once
}

TEST(ReferenceRenderer, CutsWhatReachesBehindTheCamera) {
  // A floor under the camera, in front of it and behind: the lower half of the picture.
  const TestMesh floor{{{-1e4f, -1, -1e4f}, {1e4f, -1, -1e4f}, {1e4f, -1, 1e4f}, {-1e4f, -1, 1e4f}},
                       {0, 2, 1, 0, 3, 2}};
  const FramePicture picture = drawn(testing::scene_of(floor), {});
  for (int x = 0; x < size.width; ++x) {
    EXPECT_TRUE(is_sky(at(picture, x, size.height / 2 - 1)));
    EXPECT_FALSE(is_sky(at(picture, x, size.height / 2 + 1)));
    EXPECT_FALSE(is_sky(at(picture, x, size.height - 1)));
  }
}

TEST(ReferenceRenderer, NearerHidesFarther) {
  Scene scene = square({1, 0, 0});
  scene.draws.push_back(scene.draws[0]);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].colour = {0, 1, 0};
  scene.draws[1].material = 1;
  scene.meshes.push_back({"behind", {1}, {}});
  Node behind;
  behind.mesh = 1;
  behind.transform.translation.z = -1;
  scene.nodes.insert(scene.nodes.begin(), behind);
  const glm::vec3 colour = at(drawn(scene, before_square(5), Rendering::unlit), 32, 24);
  EXPECT_GT(colour.r, 0);
  EXPECT_EQ(colour.g, 0);
}

TEST(ReferenceRenderer, CullsBackFacesUnlessThereAreTwoSides) {
  const FrameCamera from_behind = looking_at({0, 0, -5}, {0, 0, 0});
  Scene scene = square();
  EXPECT_EQ(covered(drawn(scene, from_behind)), 0u);
  scene.materials[0].double_sided = true;
  EXPECT_GT(covered(drawn(scene, from_behind)), 0u);
  scene.materials[0].double_sided = false;
  scene.nodes[0].transform.scale.x = -1;  // mirrored: what was behind is in front
  EXPECT_EQ(covered(drawn(scene, from_behind)), 0u);
  EXPECT_GT(covered(drawn(scene, before_square(5))), 0u);
}

TEST(ReferenceRenderer, MirroredNodesOfMorphedMeshesShowTheirFronts) {
  Scene scene = square();
  auto vertices = std::make_shared<VertexStreams>(*scene.draws[0].full().vertices);
  vertices->morph_targets.emplace_back();
  scene.draws[0].full().vertices = vertices;
  scene.nodes[0].transform.scale.x = -1;
  EXPECT_GT(covered(drawn(scene, before_square(5))), 0u);
  EXPECT_EQ(covered(drawn(scene, looking_at({0, 0, -5}, {0, 0, 0}))), 0u);
}

TEST(ReferenceRenderer, LightsWhatFacesTheSun) {
  Scene up = square(), down = square();
  add_stream(up, "NORMAL", 3, {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0});
  add_stream(down, "NORMAL", 3, {0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0});
  EXPECT_GT(at(drawn(up, before_square(5)), 32, 24).g, 2 * at(drawn(down, before_square(5)), 32, 24).g);
  EXPECT_EQ(at(drawn(up, before_square(5), Rendering::unlit), 32, 24),
            at(drawn(down, before_square(5), Rendering::unlit), 32, 24));
}

/// The square with an image over it, upright.
Scene textured(Image image, bool as_normal_map = false) {
  Scene scene = square();
  add_stream(scene, "TEXCOORD_0", 2, {0, 1, 1, 1, 1, 0, 0, 0});
  scene.images.push_back(std::move(image));
  Texture texture;
  texture.image = 0;
  texture.is_nearest = true;
  (as_normal_map ? scene.materials[0].normal_map : scene.materials[0].base_colour) = texture;
  return scene;
}

FramePicture drawn_with_images(const Scene& scene, Rendering rendering) {
  return drawn(scene, before_square(3), rendering, FrameStyle::lit, 1, nullptr, 0, Analyses(testing::stored_texels()));
}

TEST(ReferenceRenderer, ImagesLieWhereTheirPlacesSay) {
  // Upper row red and green, lower row blue and white.
  const Image image = testing::texel_image({2, 2, 3, 8}, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
  const FramePicture picture = drawn_with_images(textured(image), Rendering::unlit);
  const glm::vec3 upper_left = at(picture, 24, 16), upper_right = at(picture, 40, 16), lower_left = at(picture, 24, 32);
  EXPECT_GT(upper_left.r, 0.5f);
  EXPECT_EQ(upper_left.g, 0);
  EXPECT_GT(upper_right.g, 0.5f);
  EXPECT_EQ(upper_right.r, 0);
  EXPECT_GT(lower_left.b, 0.5f);
  EXPECT_EQ(lower_left.r, 0);
}

TEST(ReferenceRenderer, NormalMapsBendLight) {
  const std::uint16_t half = 128;
  const auto map = [&](std::uint16_t x, std::uint16_t y) { return testing::texel_image({1, 1, 3, 8}, {x, y, 200}); };
  const auto light = [&](const Image& image, Rendering rendering) {
    return at(drawn_with_images(textured(image, true), rendering), 32, 24).g;
  };
  const float flat = light(map(half, half), Rendering::full);
  // The sun stands above and to the right.
  EXPECT_GT(light(map(half, 220), Rendering::full), flat);
  EXPECT_LT(light(map(half, 30), Rendering::full), flat);
  EXPECT_GT(light(map(220, half), Rendering::full), light(map(30, half), Rendering::full));
  EXPECT_EQ(light(map(half, 220), Rendering::without_normal_map), light(map(half, 30), Rendering::without_normal_map));
}

TEST(ReferenceRenderer, MasksLeaveHolesAndBlendsLetThrough) {
  const Image image = testing::texel_image({2, 1, 4, 8}, {255, 255, 255, 255, 255, 255, 255, 0});
  Scene scene = textured(image);
  scene.materials[0].alpha_mode = AlphaMode::mask;
  const FramePicture masked = drawn_with_images(scene, Rendering::unlit);
  EXPECT_FALSE(is_sky(at(masked, 24, 24)));
  EXPECT_TRUE(is_sky(at(masked, 40, 24)));
  Scene blended = square({0, 0, 0});
  blended.materials[0].alpha_mode = AlphaMode::blend;
  blended.materials[0].alpha = 0.5f;
  const glm::vec3 colour = at(drawn(blended, before_square(5), Rendering::unlit), 32, 24);
  EXPECT_NEAR(colour.r, sky_colour.r / 2, 1e-6);
}

TEST(ReferenceRenderer, ShowsLevelsInGrey) {
  Scene scene = testing::scene_of({testing::levelled_sphere(32, 3)});
  const auto grey = [&](std::uint32_t level) {
    return at(drawn(scene, before_square(4), Rendering::full, FrameStyle::levels, 1, nullptr, level), 32, 24);
  };
  EXPECT_EQ(grey(0), glm::vec3(1));
  EXPECT_EQ(grey(1), glm::vec3(0.25f));
  EXPECT_EQ(grey(2), glm::vec3(0));
  EXPECT_EQ(grey(9), glm::vec3(0));
}

TEST(ReferenceRenderer, CountsItsWork) {
  Scene scene = testing::scene_of({testing::levelled_sphere(32, 3)});
  FrameWork work;
  drawn(scene, before_square(4), Rendering::unlit, FrameStyle::lit, 1, &work, 1);
  const Level& level = scene.draws[0].levels[1];
  EXPECT_EQ(work[2].draws, 1u);
  EXPECT_EQ(work[2].triangles, level.stream().triangle_count());
  EXPECT_EQ(work[2].vertices, level.vertices->count);
  EXPECT_GT(work[2].samples, 100u);
  EXPECT_EQ(work[0].draws, 0u);
}

/// The mean of samples at an edge is what of the pixel is covered.
TEST(ReferenceRenderer, SamplesMakeEdgesSmooth) {
  const FramePicture rough = drawn(square({0, 0, 0}), before_square(4.1), Rendering::unlit);
  const FramePicture smooth = drawn(square({0, 0, 0}), before_square(4.1), Rendering::unlit, FrameStyle::lit, 8);
  const auto between = [](const FramePicture& picture) {
    return std::ranges::count_if(picture.colours, [](const glm::vec3& c) { return c.r > 0.01f && c.r < 0.41f; });
  };
  EXPECT_EQ(between(rough), 0);
  EXPECT_GT(between(smooth), 50);
}

TEST(ReferenceRenderer, SurvivesWhatIsNotFinite) {
  TestMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {std::nanf(""), 0, 0}, {INFINITY, 0, 0}, {1e12f, -1e12f, 1e12f}},
                {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5, 0, 0, 0}};
  EXPECT_GT(covered(drawn(testing::scene_of(mesh), before_square(5))), 0u);
}

TEST(ReferenceRenderer, RefusesPicturesOfNothingAndOfTooMuch) {
  EXPECT_THROW(ReferenceRenderer({0, 5}), std::invalid_argument);
  EXPECT_THROW(ReferenceRenderer({4096, 16}, 5), std::invalid_argument);
  EXPECT_NO_THROW(ReferenceRenderer({4096, 16}, 4));
}

TEST(PictureError, IsTheRootOfTheMeanSquare) {
  FramePicture a{{2, 1}, {glm::vec3(0), glm::vec3(0)}}, b = a;
  EXPECT_EQ(picture_error(a, b), 0);
  b.colours[0] = {1, 1, 1};
  EXPECT_NEAR(picture_error(a, b), std::sqrt(0.5), 1e-9);
  b.colours[0] = {0.25f, 0, 0};  // stored as a half
  EXPECT_NEAR(picture_error(a, b), std::sqrt(0.25 / 6), 1e-9);
  EXPECT_EQ(as_rgb(b), (std::vector<std::uint8_t>{128, 0, 0, 0, 0, 0}));
}

TEST(FrameTruth, FloorFallsWithSamples) {
  const Scene scene = testing::levelled_field(4);
  Analyses analyses;
  const Executor executor(1);
  const FrameScene frames(scene, analyses, executor);
  const FrameMoment moment = frame_moment(frames, 0);
  const FrameCamera camera = looking_at({6, 5, 30}, {6, 0, 6});
  const double one = frame_truth(frames, moment, camera, size, 1).floor;
  const double four = frame_truth(frames, moment, camera, size, 4).floor;
  EXPECT_GT(one, 0);
  EXPECT_LT(four, one / 2);
}

}  // namespace
}  // namespace foredraw::reference_renderer_test
