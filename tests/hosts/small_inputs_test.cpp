// What files hold at the edges of what they may hold, through the program: it writes a small file that shows the same
// within the errors that it promises, or says in one line why not.
#include "support/gltf_builder.h"
#include "support/program.h"

#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace foredraw::small_inputs_test {
namespace {

using testing::Ended;
using testing::GltfBuilder;
using testing::GltfJson;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::size_t squares = 40;
constexpr std::size_t vertices = 2 * squares + 2;

/// One value for each component of each vertex.
template <class T>
std::vector<T> filled(std::size_t components, const std::function<double(std::size_t v, std::size_t c)>& value) {
  std::vector<T> values;
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t c = 0; c < components; ++c) values.push_back(static_cast<T>(value(v, c)));
  }
  return values;
}

/// An attribute of a ribbon, of any type. Rows are padded to 4 bytes, as glTF wants them.
template <class T>
void put(GltfBuilder& builder, const std::string& name, std::size_t components,
         const std::function<double(std::size_t v, std::size_t c)>& value, bool is_normalized = false) {
  const std::size_t row = (components * sizeof(T) + 3) / 4 * 4;
  const std::vector<T> values = filled<T>(components, value);
  std::vector<std::byte> bytes(vertices * row);
  double least[4], most[4];
  for (std::size_t c = 0; c < components; ++c) least[c] = infinite, most[c] = -infinite;
  for (std::size_t v = 0; v < vertices; ++v) {
    std::memcpy(bytes.data() + v * row, &values[v * components], components * sizeof(T));
    for (std::size_t c = 0; c < components; ++c) {
      const double one = static_cast<double>(values[v * components + c]);
      if (std::isfinite(one)) least[c] = std::min(least[c], one), most[c] = std::max(most[c], one);
    }
  }
  constexpr int component = std::is_same_v<T, float>           ? 5126
                            : std::is_same_v<T, std::int8_t>   ? 5120
                            : std::is_same_v<T, std::uint8_t>  ? 5121
                            : std::is_same_v<T, std::int16_t>  ? 5122
                            : std::is_same_v<T, std::uint16_t> ? 5123
                                                               : 5125;
  const std::size_t view = builder.add_view(bytes, row);
  const std::size_t number = builder.add_accessor(view, 0, component, "VEC" + std::to_string(components), vertices);
  GltfJson& accessor = builder.json["accessors"][number];
  if (is_normalized) accessor["normalized"] = true;
  if (name == "POSITION") {
    for (std::size_t c = 0; c < components; ++c) {
      const bool any = std::isfinite(least[c]);
      accessor["min"].push_back(any ? least[c] : 0);
      accessor["max"].push_back(any ? most[c] : 0);
    }
    if (component != 5126) {
      builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    }
  }
  builder.json["meshes"][0]["primitives"][0]["attributes"][name] = number;
}

double along(std::size_t v, std::size_t c) { return c == 0 ? static_cast<double>(v / 2) : c == 1 ? v % 2 : 0; }

/// Every value as it is in the ribbon, but for one vertex.
auto but_for(double odd, std::size_t where = 7) {
  return [=](std::size_t v, std::size_t c) { return v == where && c == 0 ? odd : along(v, c); };
}

struct Case {
  std::string name;
  std::function<void(GltfBuilder&)> change;
  bool keeps_shape = true;  ///< all values are numbers that can be compared
};

void add_material(GltfBuilder& builder) {
  builder.add("images", {{"uri", "none.png"}});
  builder.add("textures", {{"source", 0}});
  builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
}

void add_skin(GltfBuilder& builder) {
  builder.json["nodes"][0]["skin"] = 0;
  builder.add("nodes", {{"name", "hip"}, {"children", {2}}});
  builder.add("nodes", {{"name", "knee"}, {"translation", {0, 1, 0}}});
  builder.add("skins", {{"joints", {1, 2}}});
}

void add_animation(GltfBuilder& builder, const std::vector<float>& times, const std::vector<float>& values) {
  const std::size_t input = builder.add_values(times, "SCALAR"), output = builder.add_values(values, "VEC3");
  builder.json["accessors"][input]["min"] = {*std::ranges::min_element(times)};
  builder.json["accessors"][input]["max"] = {*std::ranges::max_element(times)};
  builder.add("animations", {{"samplers", {{{"input", input}, {"output", output}}}},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"plain", [](GltfBuilder&) {}},
      {"a position is no number", [](auto& b) { put<float>(b, "POSITION", 3, but_for(nan)); }, false},
      {"a position is infinite", [](auto& b) { put<float>(b, "POSITION", 3, but_for(infinite)); }, false},
      {"a position is 1e30", [](auto& b) { put<float>(b, "POSITION", 3, but_for(1e30)); }},
      {"all positions are 1e30 and beyond",
       [](auto& b) { put<float>(b, "POSITION", 3, [](auto v, auto c) { return 1e30 * (1 + along(v, c)); }); }},
      {"positions are denormal",
       [](auto& b) { put<float>(b, "POSITION", 3, [](auto v, auto c) { return 1e-42 * along(v, c); }); }},
      {"positions are tiny",
       [](auto& b) { put<float>(b, "POSITION", 3, [](auto v, auto c) { return 1e-33 * along(v, c); }); }},
      {"positions are far away",
       [](auto& b) { put<float>(b, "POSITION", 3, [](auto v, auto c) { return 1e7 + along(v, c); }); }},
      {"all positions are one", [](auto& b) { put<float>(b, "POSITION", 3, [](auto, auto) { return .1; }); }},
      {"positions of 8 bits", [](auto& b) { put<std::int8_t>(b, "POSITION", 3, along); }},
      {"positions of 8 bits without a sign", [](auto& b) { put<std::uint8_t>(b, "POSITION", 3, along); }},
      {"positions of 16 bits, parts of 1", [](auto& b) { put<std::int16_t>(b, "POSITION", 3, along, true); }},
      {"positions of 16 bits without a sign", [](auto& b) { put<std::uint16_t>(b, "POSITION", 3, along); }},
      {"texture coordinates of 1,000 tiles",
       [](auto& b) {
         add_material(b);
         put<float>(b, "TEXCOORD_0", 2, [](auto v, auto c) { return 25.0123 * along(v, c) - 500; });
       }},
      {"texture coordinates that are no number",
       [](auto& b) {
         add_material(b);
         put<float>(b, "TEXCOORD_0", 2, but_for(nan));
       },
       false},
      {"texture coordinates of 16 bits",
       [](auto& b) {
         add_material(b);
         put<std::uint16_t>(
             b, "TEXCOORD_0", 2, [](auto v, auto c) { return 1500 * along(v, c); }, true);
       }},
      {"texture coordinates of 8 bits",
       [](auto& b) {
         add_material(b);
         put<std::uint8_t>(
             b, "TEXCOORD_0", 2, [](auto v, auto c) { return 6 * along(v, c); }, true);
       }},
      {"normals of no length", [](auto& b) { put<float>(b, "NORMAL", 3, [](auto, auto) { return 0; }); }, false},
      {"normals that are no number", [](auto& b) { put<float>(b, "NORMAL", 3, but_for(nan)); }, false},
      {"normals of any length",
       [](auto& b) { put<float>(b, "NORMAL", 3, [](auto v, auto c) { return c == v % 3 ? 1e-20 * (v + 1.) : 0; }); },
       false},
      {"colours beyond 1",
       [](auto& b) { put<float>(b, "COLOR_0", 3, [](auto v, auto c) { return .37 * along(v, c); }); }},
      {"colours below 0", [](auto& b) { put<float>(b, "COLOR_0", 4, but_for(-3)); }},
      {"colours that are no number", [](auto& b) { put<float>(b, "COLOR_0", 4, but_for(nan)); }, false},
      {"colours of 8 bits",
       [](auto& b) {
         put<std::uint8_t>(
             b, "COLOR_0", 3, [](auto v, auto c) { return 6 * along(v, c); }, true);
       }},
      {"colours of 16 bits",
       [](auto& b) {
         put<std::uint16_t>(
             b, "COLOR_0", 4, [](auto v, auto c) { return 1501 * along(v, c); }, true);
       }},
      {"an attribute of its own that is no number",
       [](auto& b) { put<float>(b, "_HEAT", 3, [](auto, auto) { return nan; }); }, false},
      {"a skin without weights", [](auto& b) { add_skin(b); }},
      {"joints without weights",
       [](auto& b) {
         add_skin(b);
         put<std::uint8_t>(b, "JOINTS_0", 4, [](auto, auto) { return 1; });
       }},
      {"weights of 0",
       [](auto& b) {
         add_skin(b);
         put<std::uint8_t>(b, "JOINTS_0", 4, [](auto v, auto c) { return c == 0 ? v % 2 : 0; });
         put<float>(b, "WEIGHTS_0", 4, [](auto, auto) { return 0; });
       }},
      {"weights that are no number",
       [](auto& b) {
         add_skin(b);
         put<std::uint8_t>(b, "JOINTS_0", 4, [](auto, auto) { return 1; });
         put<float>(b, "WEIGHTS_0", 4, but_for(nan));
       },
       false},
      {"weights of 16 bits",
       [](auto& b) {
         add_skin(b);
         put<std::uint16_t>(b, "JOINTS_0", 4, [](auto v, auto c) { return c == 0 ? v % 2 : 0; });
         put<std::uint16_t>(
             b, "WEIGHTS_0", 4, [](auto, auto c) { return c == 0 ? 65535 : 0; }, true);
       }},
      {"an animation whose keys are equal",
       [](auto& b) {
         add_animation(b, {0, 1, 2, 3}, {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3});
       }},
      {"an animation whose keys are at one time",
       [](auto& b) {
         add_animation(b, {1, 1, 1}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
       }},
      {"an animation of one key",
       [](auto& b) {
         add_animation(b, {0}, {1, 2, 3});
       }},
      {"an animation that is no number",
       [](auto& b) {
         add_animation(b, {0, 1}, {nan, 2, 3, 1, 2, 1e30f});
       }},
      {"one vertex",
       [](auto& b) {
         const std::size_t one = b.add_values(std::vector<float>{1, 2, 3}, "VEC3");
         b.json["accessors"][one]["min"] = b.json["accessors"][one]["max"] = {1, 2, 3};
         b.json["meshes"][0]["primitives"][0] = {
             {"attributes", {{"POSITION", one}}},
             {"indices", b.add_values(std::vector<std::uint16_t>{0, 0, 0}, "SCALAR")}};
       }},
      {"one point",
       [](auto& b) {
         const std::size_t one = b.add_values(std::vector<float>{1, 2, 3}, "VEC3");
         b.json["accessors"][one]["min"] = b.json["accessors"][one]["max"] = {1, 2, 3};
         b.json["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", one}}}, {"mode", 0}};
       }},
  };
  return all;
}

double diagonal_of(const VertexStreams& streams) {
  glm::dvec3 least(infinite), most(-infinite);
  for (const glm::dvec3 p : decode_vec3(*streams.find("POSITION"))) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  return std::sqrt(glm::dot(most - least, most - least));
}

/// How far each attribute may be off with the usual options, component by component.
double promised(const std::string& semantic, double diagonal) {
  if (semantic == "POSITION") return 3e-5 * diagonal;
  if (semantic.starts_with("TEXCOORD_")) return .5 / 4096;
  return semantic.starts_with("COLOR_") ? .002 : infinite;
}

/// Whether each vertex that a triangle uses is one of the others', within what is promised.
void expect_near(const Draw& is, const Draw& was) {
  const VertexStreams &now = *is.full().vertices, &before = *was.full().vertices;
  const double diagonal = diagonal_of(before);
  for (const std::uint32_t v : is.full().stream().indices.view()) {
    bool any = false;
    for (std::size_t w = 0; w < before.count && !any; ++w) {
      any = std::ranges::all_of(now.base, [&](const VertexStream& stream) {
        const VertexStream* old = before.find(stream.semantic);
        for (std::size_t c = 0; c < stream.format.components; ++c) {
          const double off = double{decode_component(stream, v, c)} - double{decode_component(*old, w, c)};
          if (std::abs(off) > promised(stream.semantic, diagonal) * 1.000001) return false;
        }
        return true;
      });
    }
    ASSERT_TRUE(any) << "vertex " << v;
  }
}

class SmallInputs : public testing::InFolder {};

TEST_F(SmallInputs, AreWrittenWithinTheirErrorsOrRefusedInOneLine) {
  for (const Case& one : cases()) {
    GltfBuilder builder = testing::ribbon(squares);
    one.change(builder);
    const auto bytes = builder.glb();
    testing::put(folder_ / "in.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    Diagnostics diagnostics;
    const auto before = read_gltf(folder_ / "in.glb", diagnostics);
    for (const std::string options : {"@small", "@game", "@small --compression ext-meshopt", "@small --corners keep"}) {
      SCOPED_TRACE(one.name + ", " + options);
      std::filesystem::remove(folder_ / "out.glb");
      const Ended ended = testing::run_program(folder_, "optimize in.glb -o out.glb --with vertex-cache -p " + options);
      if (!before) {
        EXPECT_EQ(ended.code, 2);
        EXPECT_NE(ended.err.find("in.glb"), std::string::npos) << ended.err;
        continue;
      }
      ASSERT_EQ(ended.code, 0) << ended.err;
      Diagnostics found;
      const auto after = read_gltf(folder_ / "out.glb", found);
      ASSERT_TRUE(after) << to_text(found);
      ASSERT_EQ(after->draws.size(), before->draws.size());
      EXPECT_EQ(after->animations.size(), before->animations.size());
      const Draw &is = after->draws[0], &was = before->draws[0];
      EXPECT_EQ(is.full().stream().indices.size(), was.full().stream().indices.size());
      if (one.keeps_shape) expect_near(is, was);
    }
  }
}

/// A height field of 10 million vertices.
TEST_F(SmallInputs, OfTenMillionVerticesAreWrittenLong) {
  constexpr std::uint32_t side = 3163;
  GltfBuilder builder;
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  positions.reserve(std::size_t{3} * side * side);
  indices.reserve(std::size_t{6} * side * side);
  for (std::uint32_t v = 0; v < side * side; ++v) {
    const std::uint32_t x = v % side, y = v / side;
    positions.insert(positions.end(),
                     {static_cast<float>(x), static_cast<float>(y), static_cast<float>(v * 7919 % 64)});
    if (x + 1 < side && y + 1 < side)
      indices.insert(indices.end(), {v, v + 1, v + side, v + side, v + 1, v + side + 1});
  }
  const std::size_t position = builder.add_values(positions, "VEC3");
  builder.json["accessors"][position]["min"] = {0, 0, 0};
  builder.json["accessors"][position]["max"] = {side - 1, side - 1, 63};
  builder.add_mesh({{"attributes", {{"POSITION", position}}}, {"indices", builder.add_values(indices, "SCALAR")}});
  const auto bytes = builder.glb();
  testing::put(folder_ / "in.glb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const Ended ended = testing::run_program(folder_, "optimize in.glb -o out.glb --with vertex-cache -p @small");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_LT(std::filesystem::file_size(folder_ / "out.glb"), bytes.size() / 4);
}

}  // namespace
}  // namespace foredraw::small_inputs_test
