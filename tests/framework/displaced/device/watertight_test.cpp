// Closed surfaces stay closed, drawn by their shaders on Mesa's software driver: at each of the four samples of each
// pixel as many triangles face the eye as face away. A crack as wide as one sample shows.

#include <foredraw/displaced/seam_table.h>
#include <foredraw/displaced/stored_seams.h>

#include "displaced_on_device.h"

#include <cmath>

namespace foredraw::watertight_test {
namespace {

using namespace testing;
using enum TessellationSpacing;

using Watertight = DisplacedOnDevice;

/// A surface with the normals that its vertices store.
struct ClosedSurface {
  DisplacedSurface surface;
  std::vector<glm::vec3> normals;

  /// What is added to the positions is the direction at a position, whatever its vertices' normals.
  void direct() {
    const DirectedPart part{surface.positions, normals, surface.indices};
    surface.directions = smooth_directions(std::span(&part, 1)).front();
  }
};

glm::vec3 unit(glm::vec3 v) { return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// A torus on a map that repeats. Vertices at both ends of the map lie in the same places, with normals of their own.
ClosedSurface torus_with_seams(std::uint32_t slices, std::uint32_t sides) {
  ClosedSurface closed;
  DisplacedSurface& surface = closed.surface;
  Random random(5);
  surface.heights = {64, 32, {}};
  for (std::uint32_t i = 0; i < 64 * 32; ++i)
    surface.heights.texels.push_back(static_cast<std::uint16_t>(random.below(65536)));
  for (std::uint32_t j = 0; j <= sides; ++j) {
    for (std::uint32_t i = 0; i <= slices; ++i) {
      const double u = 6.283185307179586 * (i % slices) / slices, v = 6.283185307179586 * (j % sides) / sides;
      const glm::dvec3 out(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      surface.positions.emplace_back(glm::dvec3(std::cos(u), std::sin(u), 0) + 0.4 * out);
      const bool is_seam = i % slices == 0 || j % sides == 0;
      const glm::vec3 tilt(i == 0 ? 0.4f : -0.4f, j == 0 ? 0.3f : -0.3f, 0);
      closed.normals.push_back(unit(glm::vec3(out) + (is_seam ? tilt : glm::vec3(0))));
      surface.places.push_back(
          {foredraw_height_place(static_cast<float>(i) / static_cast<float>(slices), surface.heights.width),
           foredraw_height_place(static_cast<float>(j) / static_cast<float>(sides), surface.heights.height)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * (slices + 1) + i; };
  for (std::uint32_t j = 0; j < sides; ++j) {
    for (std::uint32_t i = 0; i < slices; ++i) {
      surface.indices.insert(surface.indices.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      surface.indices.insert(surface.indices.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  surface.shader.factor = 0.25f;
  closed.direct();
  return closed;
}

constexpr int steps = 48;  // texels along an edge of the cube

/// A sphere of a cube's six sides, each a chart of its own that is turned and mirrored at random. Along their edges the
/// charts have the same heights at each `exact_every`th texel, a divisor of `steps`; 0: nowhere.
ClosedSurface sphere_of_charts(int exact_every = 1, int quads = 3) {
  const int texels = steps / quads;
  ClosedSurface closed;
  DisplacedSurface& surface = closed.surface;
  Random random(17);
  surface.heights = {256, 128, std::vector<std::uint16_t>(256 * 128)};
  surface.shader.map.wrap[0] = surface.shader.map.wrap[1] = FOREDRAW_HEIGHT_CLAMPED;
  std::map<std::array<int, 3>, std::uint16_t> heights;  // by where on the cube
  for (int side = 0; side < 6; ++side) {
    const auto cube = [&](int a, int b) {
      std::array<int, 3> at{};
      at[static_cast<std::size_t>(side / 2)] = side % 2 == 0 ? 0 : steps;
      at[static_cast<std::size_t>((side / 2 + 1) % 3)] = side % 2 == 0 ? steps - a : a;
      at[static_cast<std::size_t>((side / 2 + 2) % 3)] = b;
      return at;
    };
    const std::uint64_t turn = random.below(8);
    const auto texel = [&](int a, int b) {
      if ((turn & 1) != 0) a = steps - a;
      if ((turn & 2) != 0) b = steps - b;
      if ((turn & 4) != 0) std::swap(a, b);
      return std::array{64 * (side % 3) + 7 + a, 64 * (side / 3) + 9 + b};
    };
    for (int a = 0; a <= steps; ++a) {
      for (int b = 0; b <= steps; ++b) {
        const auto drawn = static_cast<std::uint16_t>(random.below(65536));
        const auto [x, y] = texel(a, b);
        const bool is_exact = exact_every > 0 && a % exact_every == 0 && b % exact_every == 0;
        const std::uint16_t height = is_exact ? heights.try_emplace(cube(a, b), drawn).first->second : drawn;
        surface.heights.texels[static_cast<std::size_t>(256 * y + x)] = height;
      }
    }
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    for (int a = 0; a <= quads; ++a) {
      for (int b = 0; b <= quads; ++b) {
        const std::array<int, 3> at = cube(texels * a, texels * b);
        const glm::vec3 out = glm::vec3(at[0], at[1], at[2]) * (2.0f / steps) - 1.0f;
        surface.positions.push_back(1.2f * unit(out));
        closed.normals.push_back(unit(out + (side % 2 == 0 ? 0.5f : -0.5f) * glm::vec3(0.3f, -0.2f, 0.7f)));
        const auto [x, y] = texel(texels * a, texels * b);
        surface.places.push_back({256 * x + 128, 256 * y + 128});
      }
    }
    const auto vertex = [&](int a, int b) { return first + static_cast<std::uint32_t>(a * (quads + 1) + b); };
    for (int a = 0; a < quads; ++a) {
      for (int b = 0; b < quads; ++b) {
        const std::array corners = {vertex(a, b), vertex(a + 1, b), vertex(a + 1, b + 1), vertex(a, b + 1)};
        surface.indices.insert(surface.indices.end(), {corners[0], corners[1], corners[2]});
        surface.indices.insert(surface.indices.end(), {corners[0], corners[2], corners[3]});
      }
    }
  }
  surface.shader.factor = 0.3f;
  surface.shader.offset = -0.1f;
  closed.direct();
  return closed;
}

foredraw_cage_map random_map(Random& random, float scale) {
  const auto part = [&] { return 2 * static_cast<float>(random.unit()) - 1; };
  const glm::vec3 x = unit({part(), part(), part()}), other = unit({part(), part(), part()});
  const glm::vec3 z =
      unit({x.y * other.z - x.z * other.y, x.z * other.x - x.x * other.z, x.x * other.y - x.y * other.x});
  const glm::vec3 y = {z.y * x.z - z.z * x.y, z.z * x.x - z.x * x.z, z.x * x.y - z.y * x.x};
  foredraw_cage_map map;
  const glm::vec3 rows[] = {x, y, z};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) map.row[r][c] = scale * rows[r][c];
    map.row[r][3] = 0.1f * part();
  }
  return map;
}

void pose_at_random(DisplacedSurface& surface, std::uint64_t seed) {
  Random random(seed);
  surface.maps = {random_map(random, 1)};
}

/// Between two joints that turn and scale it differently. Vertices at one position have the same joints and weights.
void bend_at_random(DisplacedSurface& surface, std::uint64_t seed, std::size_t instances = 1) {
  Random random(seed);
  surface.shader.joints = 3;
  surface.maps.clear();
  for (std::size_t i = 0; i < instances; ++i) surface.maps.insert(surface.maps.end(), 3, random_map(random, 1));
  for (foredraw_cage_map& map : surface.maps) {
    for (auto& row : map.row) {
      for (float& number : row) number += 0.2f * (2 * static_cast<float>(random.unit()) - 1);
    }
  }
  surface.skin.clear();
  for (const glm::vec3& p : surface.positions) {
    const float along = 0.5f + p.x / 3, rest = (1 - along) * (0.5f + p.y / 4);
    surface.skin.push_back({{0, 1, 2, 0}, {along, rest, 1 - along - rest, 0}});
  }
}

/// From distance 4 of the middle, in perspective.
DisplacedFrame frame() {
  DisplacedFrame frame;
  frame.clip_from_posed = glm::mat4(0);
  frame.clip_from_posed[0][0] = 2;
  frame.clip_from_posed[1][1] = 2;
  frame.clip_from_posed[2] = {0, 0, -0.5f, -1};
  frame.clip_from_posed[3] = {0, 0, 2, 4};
  frame.eye = {0, 0, 4};
  frame.pixels_per_unit = DisplacedDrawing::size;
  return frame;
}

struct Parity {
  std::size_t covered = 0, odd = 0;  ///< samples
  std::size_t partly = 0;            ///< pixels with samples that are covered and others that are not
};

Parity parity(std::span<const DisplacedDrawing::Counts> counts) {
  Parity parity;
  for (const auto& [front, back] : counts) {
    if (front + back > 0) ++parity.covered;
    if (front != back) ++parity.odd;
  }
  for (std::size_t pixel = 0; pixel < counts.size(); pixel += DisplacedDrawing::samples) {
    const auto covered = std::ranges::count_if(counts.subspan(pixel, DisplacedDrawing::samples),
                                               [](const auto& of) { return of.front + of.back > 0; });
    if (covered > 0 && covered < DisplacedDrawing::samples) ++parity.partly;
  }
  return parity;
}

/// As many samples as a surface of that size covers at least.
constexpr std::size_t many = 20000;

void expect_closed_repeated_maps(gpu::Device& device, TessellationSpacing spacing, std::uint64_t seed) {
  DisplacedSurface surface = torus_with_seams(17, 11).surface;
  surface.shader.spacing = spacing;
  surface.shader.pixels_per_part = 3;
  if (seed == 3) {
    bend_at_random(surface, seed);
  } else {
    pose_at_random(surface, seed);
  }
  const Parity found = parity(DisplacedDrawing(device, surface).counted(frame()));
  EXPECT_GT(found.covered, many);
  EXPECT_GT(found.partly, 200u);
  EXPECT_EQ(found.odd, 0u) << "spacing " << static_cast<int>(spacing) << ", pose " << seed;
}

TEST_F(Watertight, RepeatedMapsStayClosedInEverySpacing) {
  expect_closed_repeated_maps(*device_, equal, 1);
  expect_closed_repeated_maps(*device_, fractional_odd, 2);
  expect_closed_repeated_maps(*device_, fractional_even, 3);
}

TEST_F(Watertight, RepeatedMapsStayClosedInEverySpacingAndPoseLong) {
  for (const TessellationSpacing spacing : {equal, fractional_odd, fractional_even}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) expect_closed_repeated_maps(*device_, spacing, seed);
  }
}

void expect_closed_turned_charts(gpu::Device& device, float level, bool is_bent) {
  DisplacedSurface surface = sphere_of_charts().surface;
  surface.shader.levels = DisplacedShader::Levels::constant;
  surface.shader.level = level;
  if (is_bent) {
    bend_at_random(surface, 2);
  } else {
    pose_at_random(surface, 1);
  }
  const Parity found = parity(DisplacedDrawing(device, surface).counted(frame()));
  EXPECT_GT(found.covered, many);
  EXPECT_EQ(found.odd, 0u) << "level " << level << (is_bent ? ", bent" : "");
}

TEST_F(Watertight, TurnedChartsStayClosed) {
  expect_closed_turned_charts(*device_, 1, true);
  expect_closed_turned_charts(*device_, 2, false);
  expect_closed_turned_charts(*device_, 16, true);
}

TEST_F(Watertight, TurnedChartsStayClosedAtTheirLevelsLong) {
  for (const float level : {1.0f, 2.0f, 4.0f, 8.0f, 16.0f, 32.0f, 64.0f}) {
    for (const bool is_bent : {false, true}) expect_closed_turned_charts(*device_, level, is_bent);
  }
}

/// Heights of its seams, apart from its map.
DrawSeams seams_of(const DisplacedSurface& surface) {
  std::vector<glm::vec2> uvs;
  for (const auto& [x, y] : surface.places)
    uvs.emplace_back(x / (256.0f * float(surface.heights.width)), y / (256.0f * float(surface.heights.height)));
  foredraw_height_map map = surface.shader.map;
  map.texels = surface.heights.texels.data();
  map.width = surface.heights.width;
  map.height = surface.heights.height;
  const SeamTable table = seam_table(seam_edges(std::array{UvMesh{surface.positions, uvs, surface.indices}}), map, 1);
  return {0, Shared(table.parts_log2), Shared(table.heights), Shared(table.sides[0])};
}

/// Charts whose maps are equal at the corners of triangles alone, and which read their seams from a table.
DisplacedSurface sphere_with_stored_seams() {
  DisplacedSurface surface = sphere_of_charts(steps, 1).surface;
  const DrawSeams seams = seams_of(surface);
  EXPECT_EQ(seams.sides.size(), 24u);
  surface.seams = seam_words(StoredSeams(seams));
  surface.shader.levels = DisplacedShader::Levels::constant;
  surface.shader.reads_seams = true;
  pose_at_random(surface, 3);
  return surface;
}

void expect_closed_stored_seams(gpu::Device& device, DisplacedSurface& surface, TessellationSpacing spacing,
                                float level) {
  surface.shader.spacing = spacing;
  surface.shader.level = level;
  const Parity found = parity(DisplacedDrawing(device, surface).counted(frame()));
  EXPECT_GT(found.covered, many / 2);
  EXPECT_EQ(found.odd, 0u) << "level " << level << ", spacing " << static_cast<int>(spacing);
}

TEST_F(Watertight, ChartsWithStoredSeamsStayClosedInEverySpacing) {
  DisplacedSurface surface = sphere_with_stored_seams();
  expect_closed_stored_seams(*device_, surface, fractional_odd, 12.3f);
  expect_closed_stored_seams(*device_, surface, fractional_even, 7);
  expect_closed_stored_seams(*device_, surface, equal, 7);
  const auto in_hlsl = DisplacedDrawing(*device_, surface, ShaderLanguage::hlsl).counted(frame());
  EXPECT_TRUE(in_hlsl == DisplacedDrawing(*device_, surface).counted(frame()));
  surface.shader.reads_seams = false;
  EXPECT_GT(parity(DisplacedDrawing(*device_, surface).counted(frame())).odd, 100u) << "the table does it";
}

TEST_F(Watertight, ChartsWithStoredSeamsStayClosedAtAnyLevelInEverySpacingLong) {
  DisplacedSurface surface = sphere_with_stored_seams();
  for (const TessellationSpacing spacing : {equal, fractional_odd, fractional_even}) {
    for (const float level : {1.0f, 2.0f, 7.0f, 12.3f, 64.0f}) {
      expect_closed_stored_seams(*device_, surface, spacing, level);
    }
  }
}

TEST_F(Watertight, ShadersInHlslAndThePosedCageShowTheSame) {
  DisplacedSurface surface = torus_with_seams(13, 9).surface;
  bend_at_random(surface, 5, 4);
  surface.shader.pixels_per_part = 4;
  DisplacedDrawing drawing(*device_, surface), in_hlsl(*device_, surface, ShaderLanguage::hlsl);
  const auto expected = drawing.counted(frame());
  EXPECT_EQ(parity(expected).odd, 0u);
  drawing.computed_cage();
  in_hlsl.computed_cage();
  EXPECT_TRUE(drawing.counted(frame(), DisplacedStage::vertex_of_cage) == expected);
  EXPECT_TRUE(in_hlsl.counted(frame()) == expected);
  EXPECT_TRUE(in_hlsl.counted(frame(), DisplacedStage::vertex_of_cage) == expected);
}

/// What the tests above would miss if they measured nothing.
TEST_F(Watertight, NormalsInsteadOfDirectionsTear) {
  for (ClosedSurface closed : {torus_with_seams(17, 11), sphere_of_charts()}) {
    closed.surface.shader.levels = DisplacedShader::Levels::constant;
    closed.surface.shader.level = 8;
    pose_at_random(closed.surface, 1);
    EXPECT_EQ(parity(DisplacedDrawing(*device_, closed.surface).counted(frame())).odd, 0u);
    closed.surface.directions = closed.normals;
    EXPECT_GT(parity(DisplacedDrawing(*device_, closed.surface).counted(frame())).odd, 100u);
  }
}

TEST_F(Watertight, ChartsWhoseHeightsDifferTear) {
  DisplacedSurface surface = sphere_of_charts(0).surface;
  surface.shader.levels = DisplacedShader::Levels::constant;
  surface.shader.level = 8;
  EXPECT_GT(parity(DisplacedDrawing(*device_, surface).counted(frame())).odd, 100u);
}

TEST_F(Watertight, LevelsOfTrianglesInsteadOfEdgesTear) {
  DisplacedSurface surface = torus_with_seams(17, 11).surface;
  surface.shader.levels = DisplacedShader::Levels::stored;
  for (std::size_t t = 0; t < surface.indices.size() / 3; ++t) {
    const float level = t % 2 == 0 ? 7.0f : 8.0f;
    surface.levels.push_back({{level, level, level}, level});
  }
  EXPECT_GT(parity(DisplacedDrawing(*device_, surface).counted(frame())).odd, 100u);
}

}  // namespace
}  // namespace foredraw::watertight_test
