// Displaced draws whose layout, shape, normals, weights or numbers are not what they should be, through the program:
// read and measured as far as they go, and told; and nothing that is no number comes out.
#include "displaced_parts.h"

#include "support/expect_numbers.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace foredraw {
namespace {

#ifdef FOREDRAW_PROGRAM
using testing::GltfJson;
using testing::Parts;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

const std::vector<std::string> pipelines = {
    "@displaced' --with 'seam-gap, vertex-precision",
    "@crowd",
    "displacement-seams(table=true), tessellation-levels, vertex-pack' --with 'vertex-cache",
    "displacement-seams(method=average), tessellate(texels=2, levels=3)' --with 'vertex-cache",
    "tessellate(parts=5, spacing=fractional-even)' --with 'vertex-cache",
    "displacement(factor=2), weld, quadric-collapse, levels, crowd-levels' --with 'crowd-cost(frames=3)"};

struct Case {
  const char* name;
  std::function<void(Parts&)> harm;
  const char* pipeline = "";  ///< that tells what is wrong
  const char* says = "";
};

void each(std::vector<float>& rows, std::size_t width, std::size_t step, const std::vector<float>& value) {
  for (std::size_t i = 0; i < rows.size(); i += width * step)
    std::copy(value.begin(), value.end(), rows.begin() + std::ptrdiff_t(i));
}

void scale(std::vector<float>& values, float by) {
  for (float& value : values) value *= by;
}

GltfJson& transform(Parts& of) {
  return of.displacement["displacementGeometryTexture"]["extensions"]["KHR_texture_transform"];
}

const std::vector<Case> layouts = {
    {"uv-no-number",
     [](Parts& of) {
       each(of.uvs, 2, 3, {nan, 0.5f});
     }},
    {"uv-no-numbers",
     [](Parts& of) {
       each(of.uvs, 2, 1, {nan, nan});
     }},
    {"uv-infinite",
     [](Parts& of) {
       each(of.uvs, 2, 4, {inf, -inf});
     }},
    {"uv-1e30",
     [](Parts& of) {
       each(of.uvs, 2, 4, {1e30f, -1e30f});
     }},
    {"uv-negative",
     [](Parts& of) {
       for (float& uv : of.uvs) uv -= 7;
     }},
    {"uv-tiled", [](Parts& of) { scale(of.uvs, 40); }},
    {"uv-point",
     [](Parts& of) {
       each(of.uvs, 2, 1, {0.5f, 0.5f});
     }},
    {"uv-line",
     [](Parts& of) {
       for (std::size_t i = 1; i < of.uvs.size(); i += 2) of.uvs[i] = 0.5f;
     }},
    {"uv-none", [](Parts& of) { of.uvs.clear(); }},
    {"second-uv-none", [](Parts& of) { of.displacement["displacementGeometryTexture"]["texCoord"] = 1; }},
    {"nearest", [](Parts& of) { of.sampler["magFilter"] = 9728; }},
    {"mirrored",
     [](Parts& of) {
       of.sampler["wrapS"] = of.sampler["wrapT"] = 33648;
       scale(of.uvs, -3);
     }},
    {"transform",
     [](Parts& of) {
       transform(of) = {{"offset", {0.5, 3}}, {"scale", {1e20, 0}}, {"rotation", 1}};
     }},
};

const std::vector<Case> normals = {
    {"none", [](Parts& of) { of.normals.clear(); }},
    {"zero", [](Parts& of) { scale(of.normals, 0); }},
    {"no-number",
     [](Parts& of) {
       each(of.normals, 3, 3, {nan, 0, 1});
     }},
    {"long", [](Parts& of) { scale(of.normals, 1e38f); }},
    {"opposite",
     [](Parts& of) {
       for (std::size_t i = of.normals.size() / 2; i < of.normals.size(); ++i) of.normals[i] *= -1;
     }},
    {"position-no-number",
     [](Parts& of) {
       each(of.positions, 3, 7, {nan, 0, 0});
     }},
    {"position-1e30", [](Parts& of) { scale(of.positions, 1e30f); }},
    {"position-1e-30", [](Parts& of) { scale(of.positions, 1e-30f); }},
    {"position-point",
     [](Parts& of) {
       each(of.positions, 3, 1, {1, 1, 1});
     }},
    {"degenerate",
     [](Parts& of) {
       of.indices.insert(of.indices.begin(), {0, 0, 0, 1, 1, 2});
     }},
    {"three-at-an-edge",
     [](Parts& of) {
       of.indices.insert(of.indices.end(), {0, 1, 20, 1, 0, 25});
     }},
    {"twice",
     [](Parts& of) {
       const auto once = of.indices;
       of.indices.insert(of.indices.end(), once.begin(), once.end());
     }},
};

Case number(const char* name, const char* member, const GltfJson& value) {
  return {name, [=](Parts& of) { of.displacement[std::string("displacementGeometry") + member] = value; }};
}

const std::vector<Case> numbers = {
    number("factor-0", "Factor", 0),
    number("factor-negative", "Factor", -2),
    number("factor-1e30", "Factor", 1e30),
    number("factor-1e-40", "Factor", 1e-40),
    number("factor-text", "Factor", "1"),
    number("factor-1e300", "Factor", 1e300),
    number("offset-1e30", "Offset", 1e30),
    number("offset-negative", "Offset", -0.5),
    number("offset-list", "Offset", {1}),
    number("texture-9", "Texture", {{"index", 9}}),
    number("no-texture", "Texture", nullptr),
    {"beyond-floats",
     [](Parts& of) {
       of.displacement["displacementGeometryFactor"] = of.displacement["displacementGeometryOffset"] = 3e38;
     }},
};

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

const std::vector<Case> shapes = {
    {"fold",
     [](Parts& of) {
       of.become_sheet(8, 4, [](int x, int y) {
         return std::array{float(x <= 4 ? x : 8 - x), float(y), x <= 4 ? 0 : 0.02f};
       });
     },
     "displacement(factor=2)", "the surface passes through itself"},
    {"pleats",
     [](Parts& of) {
       of.become_sheet(12, 4, [](int x, int y) { return std::array{0.3f * float(x % 2), float(y), 0.2f * float(x)}; });
     },
     "tessellate(parts=4)", "the surface passes through itself"},
    {"larger-than-the-mesh",
     [](Parts& of) {
       of.become_sheet(12, 4, [](int x, int y) { return std::array{0.3f * float(x % 2), float(y), 0.2f * float(x)}; });
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

const std::vector<Case> vertices = {
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
       tangents(of, {nan, 0, 1, nan});
     },
     "vertex-pack", "a default is packed: 30"},
    {"weights-unequal",
     [](Parts& of) {
       weigh(of, {1, 0}, {0, 1});
     },
     "@displaced", "at 5 of 5 positions vertices follow joints by different weights: the surface tears there in poses"},
    {"weights-zero",
     [](Parts& of) {
       weigh(of, {0, 0}, {0, 0});
     }},
    {"weights-no-numbers",
     [](Parts& of) {
       weigh(of, {nan, nan}, {nan, nan});
     },
     "vertex-pack", "in no pose is any of its positions finite"},
    {"weights-1e30",
     [](Parts& of) {
       weigh(of, {1e30f, 1}, {1, 1e30f});
     }},
};

class DisplacedFiles : public testing::InFolder, public ::testing::WithParamInterface<const std::vector<Case>*> {
 protected:
  testing::Ended run(const std::string& command) { return testing::run_program(folder_, command); }
};

/// Whole folders at once. Each file comes out, and no figure of it is no number.
TEST_P(DisplacedFiles, GoThroughEveryPipeline) {
  std::filesystem::create_directory(folder_ / "in");
  for (const Case& one : *GetParam()) {
    Parts parts;
    one.harm(parts);
    testing::put(folder_ / "in" / (std::string(one.name) + ".glb"), parts.glb());
  }
  for (const std::string& stages : pipelines) {
    std::filesystem::remove_all(folder_ / "out");
    const std::string command = "optimize in -o out -p '" + stages + "' --threads 2";
    testing::expect_numbers(run(command), command);
    ASSERT_TRUE(std::filesystem::is_directory(folder_ / "out")) << command;
    EXPECT_EQ(static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {})),
              GetParam()->size())
        << command;
    const std::string again =
        "measure out --with 'seam-gap, vertex-precision, surface-error, crowd-cost(frames=3)' --threads 2";
    testing::expect_numbers(run(again), again + " after " + stages);
  }
}

TEST_P(DisplacedFiles, AreTold) {
  for (const Case& one : *GetParam()) {
    if (*one.says == '\0') continue;
    SCOPED_TRACE(one.name);
    Parts parts;
    one.harm(parts);
    testing::put(folder_ / "a.glb", parts.glb());
    const testing::Ended ended = run("optimize a.glb -o b.glb -p '" + std::string(one.pipeline) + '\'');
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE((ended.out + ended.err).find(one.says), std::string::npos) << ended.out << ended.err;
  }
}

/// Pipelines beside one another.
TEST_P(DisplacedFiles, AreCompared) {
  const Case& one = GetParam()->front();
  Parts parts;
  one.harm(parts);
  testing::put(folder_ / "a.glb", parts.glb());
  const std::string command = "compare a.glb -p @displaced -p @crowd -p 'tessellate(parts=3)'";
  testing::expect_numbers(run(command), command);
}

INSTANTIATE_TEST_SUITE_P(Cases, DisplacedFiles, ::testing::Values(&layouts, &normals, &numbers, &shapes, &vertices));
#endif

}  // namespace
}  // namespace foredraw
