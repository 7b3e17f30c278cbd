// The shaders' functions and cages, against the runtime's headers.

#include <foredraw/runtime/displaced_surface.h>

#include "displaced_on_device.h"

#include <bit>

namespace foredraw::displaced_functions_test {
namespace {

using namespace testing;

/// Everything that can be asked of a point of a map, in whole numbers and bits.
struct Question {
  std::array<foredraw_cage_vertex, 3> corners;
  std::array<float, 3> weights;
  float uv = 0;
};
struct Answer {
  std::int32_t place = 0, x = 0, y = 0;
  std::uint32_t sum = 0, displacement = 0;
  std::array<std::uint32_t, 3> point{};
  friend bool operator==(const Answer&, const Answer&) = default;
};

constexpr std::string_view questions_in_glsl = R"(
layout(local_size_x = 64) in;
struct Question { DisplacedVertex a, b, c; vec3 weights; float uv; };
struct Answer { int place, x, y; uint sum; uint displacement, point_x, point_y, point_z; };
layout(std430, set = 0, binding = 0) readonly buffer Questions { Question questions[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };
void main() {
  Question q = questions[gl_GlobalInvocationID.x];
  uvec3 w = displaced_height_weights(q.weights);
  Answer answer;
  answer.place = displaced_height_place(q.uv, displaced_size.x);
  answer.x = displaced_height_between(ivec3(q.a.x, q.b.x, q.c.x), w);
  answer.y = displaced_height_between(ivec3(q.a.y, q.b.y, q.c.y), w);
  answer.sum = displaced_height_sum(ivec2(answer.x, answer.y));
  float by = displaced_displacement(displaced_point_height(q.a, q.b, q.c, displaced_height_weights(q.weights)));
  vec3 point = displaced_point(q.a, q.b, q.c, q.weights, by);
  answer.displacement = floatBitsToUint(by);
  answer.point_x = floatBitsToUint(point.x);
  answer.point_y = floatBitsToUint(point.y);
  answer.point_z = floatBitsToUint(point.z);
  answers[gl_GlobalInvocationID.x] = answer;
}
)";
constexpr std::string_view questions_in_hlsl = R"(
struct Question { DisplacedVertex a, b, c; float3 weights; float uv; };
struct Answer { int place, x, y; uint sum; uint displacement, point_x, point_y, point_z; };
StructuredBuffer<Question> questions : register(t0, space0);
RWStructuredBuffer<Answer> answers : register(u1, space0);
[numthreads(64, 1, 1)]
void main(uint3 number : SV_DispatchThreadID) {
  Question q = questions[number.x];
  uint3 w = displaced_height_weights(q.weights);
  Answer answer;
  answer.place = displaced_height_place(q.uv, displaced_size.x);
  answer.x = displaced_height_between(int3(q.a.x, q.b.x, q.c.x), w);
  answer.y = displaced_height_between(int3(q.a.y, q.b.y, q.c.y), w);
  answer.sum = displaced_height_sum(int2(answer.x, answer.y));
  float by = displaced_displacement(displaced_point_height(q.a, q.b, q.c, displaced_height_weights(q.weights)));
  float3 at = displaced_point(q.a, q.b, q.c, q.weights, by);
  answer.displacement = asuint(by);
  answer.point_x = asuint(at.x);
  answer.point_y = asuint(at.y);
  answer.point_z = asuint(at.z);
  answers[number.x] = answer;
}
)";

Answer answer_of(const Question& question, const foredraw_height_map& map, const DisplacedShader& shader) {
  std::uint32_t weights[3];
  foredraw_height_weights(question.weights.data(), weights);
  std::int32_t x[3], y[3];
  float position[3][3], direction[3][3], point[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const foredraw_cage_vertex& corner = question.corners[c];
    x[c] = corner.x;
    y[c] = corner.y;
    std::ranges::copy(corner.position, position[c]);
    std::ranges::copy(corner.direction, direction[c]);
  }
  Answer answer;
  answer.place = foredraw_height_place(question.uv, map.width);
  answer.x = foredraw_height_between(x, weights);
  answer.y = foredraw_height_between(y, weights);
  answer.sum = foredraw_height_sum(&map, answer.x, answer.y);
  const std::uint32_t height = foredraw_displaced_height(&map, answer.x, answer.y, shader.bits);
  const float by = shader.offset + shader.factor * foredraw_height_part(height, shader.bits);
  foredraw_displaced_point(position, direction, question.weights.data(), by, point);
  answer.displacement = std::bit_cast<std::uint32_t>(by);
  for (std::size_t i = 0; i < 3; ++i) answer.point[i] = std::bit_cast<std::uint32_t>(point[i]);
  return answer;
}

std::vector<Question> questions(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Question> result(count);
  for (Question& question : result) {
    // Near the map, around it, or as far away as places go.
    const float far = std::array{1.5f, 100.0f, 1e7f}[random.below(3)];
    for (foredraw_cage_vertex& corner : question.corners) {
      for (float& p : corner.position) p = between(random, -10, 10);
      for (float& d : corner.direction) d = random.below(9) == 0 ? 0.0f : between(random, -1, 1);
      corner.x = foredraw_height_place(between(random, -far, far), 64);
      corner.y = foredraw_height_place(between(random, -far, far), 64);
    }
    const auto u = static_cast<std::uint32_t>(random.below(65537)),
               v = static_cast<std::uint32_t>(random.below(65537 - u));
    question.weights = TessellationPoint{u, random.below(4) == 0 ? 0 : v}.coordinates();
    if (random.below(4) == 0) {  // no tessellator's
      for (float& w : question.weights) w = between(random, -0.1f, 1.1f);
    }
    question.uv = between(random, -far, far);
  }
  return result;
}

TEST_F(DisplacedOnDevice, FunctionsGiveTheBitsOfTheRuntimesHeaders) {
  constexpr std::uint32_t count = 1 << 18;
  struct Case {
    ShaderLanguage language;
    std::uint8_t u, v;
    bool is_nearest;
    std::uint32_t width, height, bits;
  };
  constexpr auto glsl = ShaderLanguage::glsl, hlsl = ShaderLanguage::hlsl;
  std::uint64_t seed = 100;
  for (const Case& of :
       {Case{glsl, 0, 1, false, 61, 32, 14}, Case{glsl, 2, 0, false, 1, 300, 16}, Case{glsl, 1, 2, true, 7, 9, 12},
        Case{glsl, 7, 1, false, 1024, 3, 1}, Case{hlsl, 0, 1, false, 61, 32, 14}, Case{hlsl, 2, 0, false, 1, 300, 16},
        Case{hlsl, 1, 2, true, 7, 9, 12}, Case{hlsl, 7, 1, false, 1024, 3, 1}}) {
    ++seed;
    DisplacedSurface surface = torus_on_noise(seed, noise(of.width, of.height, seed));
    surface.shader.map = {nullptr, of.width, of.height, {of.u, of.v}, of.is_nearest};
    surface.shader.bits = of.bits;
    const std::vector<Question> asked = questions(count, seed);
    const std::string text(of.language == glsl ? questions_in_glsl : questions_in_hlsl);
    const auto given = DisplacedDrawing(*device_, surface, of.language).answered<Answer>(text, asked);
    foredraw_height_map map = surface.shader.map;
    map.texels = surface.heights.texels.data();
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!(given[i] == answer_of(asked[i], map, surface.shader))) ++wrong;
    }
    EXPECT_EQ(wrong, 0u) << seed;
  }
}

/// Two bones that bend and stretch.
DisplacedSurface skinned_torus(std::uint32_t instances) {
  DisplacedSurface surface = torus_on_noise(3, noise(32, 32, 3), torus(20, 11));
  Random random(9);
  surface.shader.joints = 5;
  for (std::uint32_t i = 0; i < 5 * instances; ++i) {
    foredraw_cage_map& map = surface.maps.emplace_back();
    for (auto& row : map.row) {
      for (float& number : row) number = between(random, -1, 1);
    }
  }
  surface.maps.erase(surface.maps.begin());
  for (const glm::vec3& p : surface.positions) {
    const float x = 0.5f + p.x / 3, y = 0.25f + p.y / 6;
    surface.skin.push_back({{0, 3, 1, 4}, {x * y, x * (1 - y), (1 - x) * y, (1 - x) * (1 - y)}});
  }
  return surface;
}

std::vector<foredraw_cage_vertex> posed_cage(const DisplacedSurface& surface) {
  const auto rest = cage_vertices(surface.positions, surface.directions, surface.places);
  const std::size_t joints = std::max(surface.shader.joints, 1u);
  std::vector<foredraw_cage_vertex> cage;
  for (std::size_t i = 0; i < surface.maps.size() / joints; ++i) {
    for (std::size_t v = 0; v < rest.size(); ++v) {
      foredraw_cage_map map = surface.maps[joints * i];
      if (surface.shader.joints > 0) {
        map = foredraw_cage_blended(&surface.maps[joints * i], surface.skin[v].joint, surface.skin[v].weight);
      }
      cage.push_back(foredraw_cage_posed(&rest[v], &map));
    }
  }
  return cage;
}

bool are_equal(std::span<const foredraw_cage_vertex> a, std::span<const foredraw_cage_vertex> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

TEST_F(DisplacedOnDevice, CagesAreThoseOfTheRuntimesHeaderToTheBit) {
  DisplacedSurface rigid = torus_on_noise(4, noise(32, 32, 3));
  rigid.maps = skinned_torus(7).maps;
  for (const DisplacedSurface& surface : {skinned_torus(3), rigid}) {
    const auto expected = posed_cage(surface);
    for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::hlsl}) {
      DisplacedDrawing drawing(*device_, surface, language);
      EXPECT_TRUE(are_equal(drawing.computed_cage(), expected));
      if (language == ShaderLanguage::hlsl) continue;
      EXPECT_TRUE(are_equal(drawing.captured_cage(), expected));
    }
  }
}

}  // namespace
}  // namespace foredraw::displaced_functions_test
