// What shaders make of displaced surfaces, against what the processor makes of them.

#include <foredraw/displaced/seamed_displacements.h>
#include <foredraw/runtime/displaced_surface.h>

#include "displaced_on_device.h"

#include <bit>
#include <set>

namespace foredraw::device_displaced_shader_test {
namespace {

using namespace testing;
using enum TessellationSpacing;

/// Of both triangles at an edge the same, and different from edge to edge.
std::vector<TessellationLevels> random_levels(std::span<const std::uint32_t> indices, std::uint64_t seed) {
  std::vector<TessellationLevels> levels(indices.size() / 3);
  for (std::size_t side = 0; side < indices.size(); ++side) {
    const std::size_t t = side / 3, e = side % 3;
    const std::uint32_t a = indices[3 * t + (e + 1) % 3], b = indices[3 * t + (e + 2) % 3];
    Random random(seed + std::uint64_t{std::min(a, b)} * 65536 + std::max(a, b));
    levels[t].outer[e] = between(random, 0.5f, 20);
  }
  Random random(seed);
  for (TessellationLevels& of : levels) of.inner = between(random, 0.5f, 20);
  return levels;
}

using Place = std::array<std::uint32_t, 3>;  // bits
using Places = std::array<Place, 3>;

Place bits_of(const std::array<float, 3>& position) {
  Place bits;
  for (std::size_t i = 0; i < 3; ++i) bits[i] = std::bit_cast<std::uint32_t>(position[i] + 0.0f);  // of zeros one
  return bits;
}

/// Wherever triangles begin, and in whatever sequence they come.
std::vector<Places> sorted(std::vector<Places> triangles) {
  for (Places& t : triangles) t = std::min({t, Places{t[1], t[2], t[0]}, Places{t[2], t[0], t[1]}});
  std::ranges::sort(triangles);
  return triangles;
}

std::vector<Places> places_of(std::span<const DisplacedDrawing::Triangle> triangles) {
  std::vector<Places> places;
  for (const auto& [a, b, c] : triangles)
    places.push_back({bits_of(a.position), bits_of(b.position), bits_of(c.position)});
  return sorted(std::move(places));
}

/// As the processor has the draw's surface in its first instance, which is not moved.
std::vector<Places> expected_places(const DisplacedSurface& surface, const StoredSeams* seams = nullptr) {
  const auto count = static_cast<std::uint32_t>(surface.positions.size());
  const TessellatedMesh mesh = tessellated_mesh(surface.indices, count, surface.levels, surface.shader.spacing);
  foredraw_height_map map = surface.shader.map;
  map.texels = surface.heights.texels.data();
  map.width = surface.heights.width;
  map.height = surface.heights.height;
  const auto [factor, offset] = std::pair(surface.shader.factor, surface.shader.offset);
  const auto by = seams != nullptr
                      ? seamed_displacements(mesh, surface.indices, surface.places, map, factor, offset, *seams)
                      : displacements(mesh, surface.indices, surface.places, map, factor, offset);
  const auto positions = displaced_positions(mesh, surface.indices, surface.positions, surface.directions, by);
  std::vector<Places> places;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Places& triangle = places.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::vec3& p = positions[mesh.indices[i + c]];
      triangle[c] = bits_of({p.x, p.y, p.z});
    }
  }
  return sorted(std::move(places));
}

/// With which fragment shaders look up what else vertices have.
void expect_numbers_of_vertices(std::span<const DisplacedDrawing::Triangle> captured, const DisplacedSurface& surface) {
  std::set<std::array<std::uint32_t, 3>> patches, found;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3)
    patches.insert({surface.indices[i], surface.indices[i + 1], surface.indices[i + 2]});
  for (const DisplacedDrawing::Triangle& triangle : captured) {
    for (const DisplacedDrawing::Corner& corner : triangle) {
      found.insert(corner.vertices);
      EXPECT_EQ(corner.instance, 0u);
      glm::vec3 plane(0);  // no point is farther from it than heights reach
      for (std::size_t c = 0; c < 3; ++c) plane += corner.weights[c] * surface.positions[corner.vertices[c]];
      const glm::vec3 away = plane - glm::vec3(corner.position[0], corner.position[1], corner.position[2]);
      ASSERT_LE(away.x * away.x + away.y * away.y + away.z * away.z, 0.16f);
    }
  }
  EXPECT_TRUE(found == patches);
}

struct MapCase {
  std::array<std::uint8_t, 2> wrap;
  bool is_nearest;
  VkFormat format;
};

constexpr MapCase map_cases[] = {{{FOREDRAW_HEIGHT_REPEAT, FOREDRAW_HEIGHT_MIRRORED}, false, VK_FORMAT_R16_UNORM},
                                 {{FOREDRAW_HEIGHT_CLAMPED, FOREDRAW_HEIGHT_REPEAT}, false, VK_FORMAT_R8_UNORM},
                                 {{FOREDRAW_HEIGHT_MIRRORED, FOREDRAW_HEIGHT_CLAMPED}, true, VK_FORMAT_R16_UINT}};

void expect_surface_of_processor(gpu::Device& device, TessellationSpacing spacing, const MapCase& of,
                                 std::uint64_t seed) {
  DisplacedSurface surface = torus_on_noise(seed, noise(37, 64, seed, of.format == VK_FORMAT_R8_UNORM ? 257 : 1));
  surface.format = of.format;
  surface.shader.map.wrap[0] = of.wrap[0];
  surface.shader.map.wrap[1] = of.wrap[1];
  surface.shader.map.is_nearest = of.is_nearest;
  surface.shader.spacing = spacing;
  surface.shader.levels = DisplacedShader::Levels::stored;
  surface.levels = random_levels(surface.indices, seed);
  const std::vector<Places> expected = expected_places(surface);
  DisplacedDrawing drawing(device, std::move(surface));
  const std::vector<DisplacedDrawing::Triangle> captured = drawing.captured({}, expected.size() + 1);
  const std::vector<Places> found = places_of(captured);
  EXPECT_GT(expected.size(), 10000u);
  EXPECT_TRUE(found == expected) << found.size() << " triangles, " << expected.size() << " expected";
  expect_numbers_of_vertices(captured, drawing.surface());
}

TEST_F(DisplacedOnDevice, SurfacesAreThoseOfTheProcessorToTheBit) {
  expect_surface_of_processor(*device_, equal, map_cases[0], 2);
  expect_surface_of_processor(*device_, fractional_odd, map_cases[1], 6);
  expect_surface_of_processor(*device_, fractional_even, map_cases[2], 10);
}

TEST_F(DisplacedOnDevice, SurfacesOfEverySpacingAndMapAreThoseOfTheProcessorLong) {
  std::uint64_t seed = 1;
  for (const TessellationSpacing spacing : {equal, fractional_odd, fractional_even}) {
    for (const MapCase& of : map_cases) expect_surface_of_processor(*device_, spacing, of, ++seed);
  }
}

/// Every second edge of a triangle is said to lie on a seam, of one to 64 parts.
DrawSeams random_seams(std::span<const std::uint32_t> indices, std::uint64_t seed) {
  Random random(seed);
  std::vector<foredraw_seam_side> sides;
  std::vector<std::uint8_t> parts;
  std::vector<std::uint16_t> heights;
  for (std::uint32_t side = 0; side < indices.size(); side += 2) {
    sides.push_back({side, static_cast<std::uint32_t>(2 * parts.size() + random.below(2))});
    parts.push_back(static_cast<std::uint8_t>(random.below(7)));
    for (std::uint32_t i = 1; i < 1u << parts.back(); ++i)
      heights.push_back(static_cast<std::uint16_t>(random.below(65536)));
  }
  return {0, Shared(std::move(parts)), Shared(std::move(heights)), Shared(std::move(sides))};
}

TEST_F(DisplacedOnDevice, StoredSeamsAreReadAsTheProcessorReadsThem) {
  for (const TessellationSpacing spacing : {equal, fractional_odd, fractional_even}) {
    // Each triangle has vertices of its own: on the processor, too, each then makes all points of its edges.
    const TestMesh torus = testing::torus(9, 7);
    TestMesh apart;
    for (const std::uint32_t v : torus.indices) {
      apart.indices.push_back(static_cast<std::uint32_t>(apart.positions.size()));
      apart.positions.push_back(torus.positions[v]);
    }
    DisplacedSurface surface = torus_on_noise(31, noise(37, 64, 31), apart);
    surface.shader.spacing = spacing;
    surface.shader.levels = DisplacedShader::Levels::stored;
    surface.shader.reads_seams = true;
    surface.levels = random_levels(surface.indices, 31);
    const DrawSeams seams = random_seams(surface.indices, 32);
    const StoredSeams stored(seams);
    ASSERT_TRUE(stored.is_sound(surface.indices.size() / 3));
    surface.seams = seam_words(stored);
    const std::vector<Places> expected = expected_places(surface, &stored);
    EXPECT_FALSE(expected == expected_places(surface)) << "the table says something else than the map";
    DisplacedDrawing drawing(*device_, std::move(surface));
    EXPECT_TRUE(places_of(drawing.captured({}, expected.size() + 1)) == expected);
  }
}

TEST_F(DisplacedOnDevice, LevelsOfEdgesAreThoseOfTheProcessor) {
  DisplacedSurface surface = torus_on_noise(77, noise(16, 16, 5));
  surface.shader.spacing = fractional_odd;
  surface.shader.pixels_per_part = 5;
  DisplacedFrame frame;
  frame.eye = {0.3f, -0.2f, 2.1f};
  frame.pixels_per_unit = 120;
  DisplacedDrawing drawing(*device_, surface);
  for (std::size_t t = 0; t < surface.indices.size() / 3; ++t) {
    TessellationLevels levels;
    for (std::size_t e = 0; e < 3; ++e) {
      const glm::vec3 &a = surface.positions[surface.indices[3 * t + (e + 1) % 3]],
                      &b = surface.positions[surface.indices[3 * t + (e + 2) % 3]];
      levels.outer[e] = foredraw_edge_level(&a.x, &b.x, &frame.eye.x, frame.pixels_per_unit, 5);
    }
    levels.inner = *std::ranges::max_element(levels.outer);
    surface.levels.push_back(levels);
  }
  const std::vector<Places> expected = expected_places(surface);
  EXPECT_GT(expected.size(), 5000u);
  EXPECT_TRUE(places_of(drawing.captured(frame, expected.size() + 1)) == expected);
}
}  // namespace
}  // namespace foredraw::device_displaced_shader_test
