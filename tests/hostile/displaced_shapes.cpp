#include "displaced_cases.h"

#include <cmath>
#include <numbers>

namespace foredraw::testing {

namespace {

/// Fifty triangles around one position, each with a corner of its own there.
void fan_of_fifty(Parts& of, float apart) {
  of.clear();
  for (int k = 0; k < 50; ++k) {
    const float u = 0.01f + apart * float(k % 8), v = 0.01f + apart * float(k / 8);
    const auto around = [](int i) {
      const double angle = 2 * std::numbers::pi * (i % 50) / 50;
      return std::array{float(std::cos(angle)), float(std::sin(angle)), 0.f};
    };
    of.add_vertex({0, 0, 0}, {u, v});
    of.add_vertex(around(k), {u + 0.8f * apart, v});
    of.add_vertex(around(k + 1), {u, v + 0.8f * apart});
    for (int i = 0; i < 3; ++i) of.indices.push_back(static_cast<std::uint16_t>(3 * k + i));
  }
}

void tangents(Parts& of, const std::array<float, 4>& each) {
  for (std::size_t v = 0; v < of.vertices(); ++v) of.tangents.insert(of.tangents.end(), each.begin(), each.end());
}

/// The first strip follows one joint, and the second one another.
void weigh(Parts& of, std::array<float, 2> first, std::array<float, 2> second) {
  for (std::size_t v = 0; v < of.vertices(); ++v) {
    const auto& weights = v < of.vertices() / 2 ? first : second;
    of.weights.insert(of.weights.end(), weights.begin(), weights.end());
  }
}

}  // namespace

const std::vector<DisplacedCase>& displaced_shapes() {
  static const std::vector<DisplacedCase> all = {
      {"fold",
       [](Parts& of) {
         of.become_sheet(8, 4, [](int x, int y) {
           return std::array{float(x <= 4 ? x : 8 - x), float(y), x <= 4 ? 0 : 0.02f};
         });
       },
       "displacement(factor=2)", "the surface passes through itself"},
      {"pleats",
       [](Parts& of) {
         of.become_sheet(12, 4, [](int x, int y) {
           return std::array{0.3f * float(x % 2), float(y), 0.2f * float(x)};
         });
       },
       "tessellate(parts=4)", "the surface passes through itself"},
      {"larger-than-the-mesh",
       [](Parts& of) {
         of.become_sheet(12, 4, [](int x, int y) {
           return std::array{0.3f * float(x % 2), float(y), 0.2f * float(x)};
         });
         of.displacement["displacementGeometryFactor"] = 1000;
       },
       "tessellate(parts=4)", "which the stored ones do not; a smaller factor helps"},
      {"fifty-uvs", [](Parts& of) { fan_of_fifty(of, 0.12f); }, "displacement-seams",
       "50 seam edges; of 101 points on them 101 were unequal before, and 0 are now"},
      {"fifty-uvs-in-a-texel", [](Parts& of) { fan_of_fifty(of, 0.001f); }, "displacement-seams",
       "50 seam edges; of 51 points on them 51 were unequal before, and 0 are now"},
      {"slivers",
       [](Parts& of) {
         for (std::size_t i = 0; i < of.positions.size(); i += 3) of.positions[i] *= 1e6f;
       }},
      {"slivers-in-the-layout",
       [](Parts& of) {
         for (std::size_t i = 0; i < of.uvs.size(); i += 2) of.uvs[i] *= 1e-6f;
       }},
      {"a-line", [](Parts& of) { of.become_sheet(4, 4, [](int x, int) {
                                   return std::array{float(x), 0.f, 0.f};
                                 }); },
       "@crowd", "not measured: it has no area"},
      {"translation-1e6",
       [](Parts& of) {
         for (float& at : of.positions) at += 1e6f;
       }},
      {"scale-1e20",
       [](Parts& of) {
         for (float& at : of.positions) at *= 1e20f;
       },
       "@crowd", "its size or its error is not finite"},
      {"scale-1e-20",
       [](Parts& of) {
         for (float& at : of.positions) at *= 1e-20f;
       }},
      {"node-scale-0",
       [](Parts& of) {
         of.node["scale"] = {0, 0, 0};
       }},
      {"node-scale-1e20",
       [](Parts& of) {
         of.node["scale"] = {1e20, 1e20, 1e20};
       }},
      {"node-mirrored",
       [](Parts& of) {
         of.node["scale"] = {-1, 1, 1};
       }},
      {"second-layout",
       [](Parts& of) {
         of.uv_set = 1;
         of.displacement["displacementGeometryTexture"]["texCoord"] = 1;
       },
       "displacement-seams", "4 seam edges; of 5 points on them 5 were unequal before, and 0 are now"},
  };
  return all;
}

const std::vector<DisplacedCase>& displaced_vertices() {
  static const std::vector<DisplacedCase> all = {
      {"tangent-along-the-normal",
       [](Parts& of) {
         tangents(of, {0, 0, 1, 1});
       },
       "vertex-pack", "vertices whose normal or tangent has no direction, so that a default is packed: 30"},
      {"tangent-of-no-hand",
       [](Parts& of) {
         tangents(of, {1, 0, 0, 0});
       }},
      {"tangent-zero",
       [](Parts& of) {
         tangents(of, {0, 0, 0, 1});
       },
       "vertex-pack", "a default is packed: 30"},
      {"tangent-no-number",
       [](Parts& of) {
         tangents(of, {NAN, 0, 1, NAN});
       },
       "vertex-pack", "a default is packed: 30"},
      {"weights-unequal",
       [](Parts& of) {
         weigh(of, {1, 0}, {0, 1});
       },
       "@displaced",
       "at 5 of 5 positions vertices follow joints by different weights: the surface tears there in poses"},
      {"weights-zero",
       [](Parts& of) {
         weigh(of, {0, 0}, {0, 0});
       }},
      {"weights-no-numbers",
       [](Parts& of) {
         weigh(of, {NAN, NAN}, {NAN, NAN});
       },
       "vertex-pack", "in no pose is any of its positions finite"},
      {"weights-1e30",
       [](Parts& of) {
         weigh(of, {1e30f, 1}, {1, 1e30f});
       }},
  };
  return all;
}

}  // namespace foredraw::testing
