// Displaced draws whose map, layout, normals or numbers are not what they should be, through the program: read and
// measured as far as they go, or refused in words; and nothing that is no number comes out.
#include "support/gltf_builder.h"
#include "support/image_builder.h"
#include "support/program.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/scene/triangle_draw.h>

#include <cmath>
#include <functional>
#include <limits>
#include <regex>
#include <span>

namespace foredraw {
namespace {

#ifdef FOREDRAW_PROGRAM
using testing::GltfBuilder;
using testing::GltfJson;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

/// Two strips of squares that meet at x = 2, each laid out in a chart of its own.
struct Parts {
  std::vector<float> positions, uvs, normals;
  std::vector<std::uint16_t> indices;
  GltfJson displacement = {{"displacementGeometryTexture", {{"index", 0}}}, {"displacementGeometryFactor", 0.5}};
  GltfJson sampler = GltfJson::object();
  std::string map = "map.png";

  Parts() {
    for (int half = 0; half < 2; ++half) {
      const auto base = static_cast<std::uint16_t>(positions.size() / 3);
      for (int y = 0; y <= 4; ++y) {
        for (int x = 0; x <= 2; ++x) {
          positions.insert(positions.end(), {float(x + 2 * half), float(y), 0});
          const float u = 0.05f + 0.2f * float(x), v = 0.1f + 0.2f * float(y);
          if (half == 0) uvs.insert(uvs.end(), {u, v});
          if (half == 1) uvs.insert(uvs.end(), {0.95f - 0.4f * v, 0.95f - u});
          normals.insert(normals.end(), {0, 0, 1});
        }
      }
      for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 2; ++x) {
          const auto a = static_cast<std::uint16_t>(base + 3 * y + x);
          for (const int step : {0, 1, 3, 1, 4, 3}) indices.push_back(static_cast<std::uint16_t>(a + step));
        }
      }
    }
  }

  std::string glb() const {
    GltfBuilder file;
    GltfJson attributes{{"POSITION", file.add_values(positions, "VEC3")}};
    if (!uvs.empty()) attributes["TEXCOORD_0"] = file.add_values(uvs, "VEC2");
    if (!normals.empty()) attributes["NORMAL"] = file.add_values(normals, "VEC3");
    file.add_mesh({{"attributes", attributes}, {"indices", file.add_values(indices, "SCALAR")}, {"material", 0}});
    file.add("materials", {{"extensions", {{"KHR_materials_displacement", displacement}}}});
    file.add("images", {{"uri", map}});
    file.add("samplers", sampler);
    file.add("textures", {{"source", 0}, {"sampler", 0}});
    file.json["extensionsUsed"] = {"KHR_materials_displacement", "KHR_texture_transform"};
    const std::vector<std::byte> bytes = file.glb();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::uint16_t> noise(std::size_t count, std::uint32_t bits) {
  std::vector<std::uint16_t> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<std::uint16_t>((i * 2654435761u >> 7) % (1u << bits));
  return values;
}

const std::vector<std::string> pipelines = {
    "displacement-seams, tessellation-levels, vertex-pack", "tessellate(texels=2, levels=3)",
    "tessellate(parts=5, spacing=fractional-even)", "weld, quadric-collapse, levels, crowd-levels"};

/// Says that its values are those of the colour space sRGB: heights are no colours.
std::vector<std::byte> tagged_srgb(std::vector<std::byte> png) {
  constexpr unsigned char chunk[] = {0, 0, 0, 1, 's', 'R', 'G', 'B', 0, 0xAE, 0xCE, 0x1C, 0xE9};
  constexpr std::ptrdiff_t behind_the_header = 8 + 25;
  const auto bytes = std::as_bytes(std::span(chunk));
  png.insert(png.begin() + behind_the_header, bytes.begin(), bytes.end());
  return png;
}

class DisplacedFiles : public testing::InFolder {
 protected:
  DisplacedFiles() { testing::put(folder_ / "map.png", text_of(testing::png_of({32, 32, 1, 16}, noise(1024, 16)))); }

  testing::Ended run(const std::string& command) { return testing::run_program(folder_, command); }

  /// Whole folders at once. Each file comes out, and no figure of it is no number.
  void expect_all_go_through(std::size_t files) {
    const std::regex none(R"((^|[^a-z-])-?(nan|inf)($|[^a-z-]))");
    const auto expect_numbers = [&](const testing::Ended& ended, const std::string& command) {
      EXPECT_EQ(ended.code, 0) << command << '\n' << ended.err;
      for (const std::string* text : {&ended.out, &ended.err}) {
        std::smatch found;
        EXPECT_FALSE(std::regex_search(*text, found, none))
            << command << ": "
            << found.prefix().str().substr(
                   found.prefix().length() > 200 ? static_cast<std::size_t>(found.prefix().length()) - 200 : 0)
            << found.str();
      }
    };
    for (const std::string& stages : pipelines) {
      std::filesystem::remove_all(folder_ / "out");
      const std::string command = "optimize in -o out -p '" + stages + "' --with vertex-cache --threads 2";
      expect_numbers(run(command), command);
      ASSERT_TRUE(std::filesystem::is_directory(folder_ / "out")) << command;
      EXPECT_EQ(static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {})),
                files)
          << command;
      const std::string again = "measure out --with 'seam-gap, vertex-precision, surface-error'";
      expect_numbers(run(again), again + " after " + stages);
    }
  }
};

struct Case {
  const char* name;
  std::function<void(Parts&)> harm;
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

class OddCases : public DisplacedFiles, public ::testing::WithParamInterface<const std::vector<Case>*> {};

TEST_P(OddCases, GoThrough) {
  std::filesystem::create_directory(folder_ / "in");
  for (const Case& one : *GetParam()) {
    Parts parts;
    parts.map = "../map.png";
    one.harm(parts);
    testing::put(folder_ / "in" / (std::string(one.name) + ".glb"), parts.glb());
  }
  expect_all_go_through(GetParam()->size());
}

INSTANTIATE_TEST_SUITE_P(DisplacedFiles, OddCases, ::testing::Values(&layouts, &normals, &numbers));

TEST_F(DisplacedFiles, MapsOfEveryKindMoveTheSurface) {
  const std::vector<float> odd = {0.5f, nan, inf, -inf, -1, 2, 1e-40f, 0.25f};
  const std::vector<std::pair<std::string, std::vector<std::byte>>> maps = {
      {"1x1.png", testing::png_of({1, 1, 1, 16}, {40000})},
      {"64x1.png", testing::png_of({64, 1, 1, 16}, noise(64, 16))},
      {"1x64.png", testing::png_of({1, 64, 1, 8}, noise(64, 8))},
      {"grey8.png", testing::png_of({32, 32, 1, 8}, noise(1024, 8))},
      {"rgba8.png", testing::png_of({32, 32, 4, 8}, noise(4096, 8))},
      {"rgba16.png", testing::png_of({32, 32, 4, 16}, noise(4096, 16))},
      {"rgb8.jpg", testing::jpeg_of({32, 32, 3, 8}, noise(3072, 8))},
      {"float.exr", testing::exr_of({4, 2, 1, 32}, odd, "none")}};
  for (const auto& [name, bytes] : maps) {
    SCOPED_TRACE(name);
    testing::put(folder_ / name, text_of(bytes));
    testing::put(folder_ / "a.glb", Parts().glb());
    const testing::Ended ended = run("optimize a.glb -o b.glb -p 'displacement(map=\"" + name +
                                     "\", factor=0.5), displacement-seams, tessellate(parts=4)' --with vertex-cache");
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err.find("warning"), std::string::npos) << ended.err;
    EXPECT_EQ((ended.out + ended.err).find("5 texels of the map are not numbers from 0 to 1") != std::string::npos,
              name == "float.exr")
        << ended.out << ended.err;
    const std::string made = testing::content(folder_ / "b.glb");
    Diagnostics diagnostics;
    const auto scene = read_gltf(testing::bytes_of(made), "b.glb", {}, diagnostics, {});
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->draws[0].full().stream().triangle_count(), 32u * 24);
    for (const glm::vec3& at : decode_vec3(*scene->draws[0].full().vertices->find("POSITION")))
      EXPECT_TRUE(at.z >= 0 && at.z <= 0.5f) << at.z;
  }
}

TEST_F(DisplacedFiles, TheColourSpaceOfAMapChangesNoHeight) {
  const auto plain = testing::png_of({32, 32, 1, 8}, noise(1024, 8));
  std::vector<std::string> made;
  for (const auto& bytes : {plain, tagged_srgb(plain)}) {
    testing::put(folder_ / "heights.png", text_of(bytes));
    testing::put(folder_ / "a.glb", Parts().glb());
    const testing::Ended ended =
        run("optimize a.glb -o b.glb -p 'displacement(map=\"heights.png\"), tessellate(parts=4)' --with vertex-cache");
    EXPECT_EQ(ended.code, 0) << ended.err;
    made.push_back(testing::content(folder_ / "b.glb"));
  }
  EXPECT_NE(plain, tagged_srgb(plain));
  Diagnostics diagnostics;
  const auto a = read_gltf(testing::bytes_of(made[0]), "a", {}, diagnostics, {});
  const auto b = read_gltf(testing::bytes_of(made[1]), "b", {}, diagnostics, {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(decode_vec3(*a->draws[0].full().vertices->find("POSITION")),
            decode_vec3(*b->draws[0].full().vertices->find("POSITION")));
}

TEST_F(DisplacedFiles, MapsThatCannotBeReadAreTold) {
  const std::string whole = text_of(testing::png_of({32, 32, 1, 16}, noise(1024, 16)));
  const std::vector<std::tuple<std::string, std::string, std::string>> maps = {
      {"missing.png", "", "is missing"},
      {"cut.png", whole.substr(0, whole.size() / 2), "damaged"},
      {"head.png", whole.substr(0, 20), "damaged"},
      {"text.png", "no picture", "is not an image"},
      {"texture.ktx2", std::string("\xABKTX 20\xBB\r\n\x1A\n", 12) + std::string(100, '\0'), "KTX2"}};
  for (const auto& [name, bytes, words] : maps) {
    SCOPED_TRACE(name);
    if (!bytes.empty()) testing::put(folder_ / name, bytes);
    Parts parts;
    parts.map = name;
    testing::put(folder_ / "a.glb", parts.glb());
    // Named by the file, it costs the displacement. Each stage says why it does nothing.
    const testing::Ended kept =
        run("optimize a.glb -o b.glb -p 'displacement-seams, tessellation-levels, tessellate' --with seam-gap");
    EXPECT_EQ(kept.code, 0) << kept.err;
    const std::string all = kept.out + kept.err;
    for (const char* stage :
         {"not repaired: its map cannot be read", "no levels: ", "not tessellated: ", "not measured: "}) {
      const std::size_t at = all.find(stage);
      ASSERT_NE(at, std::string::npos) << stage << '\n' << all;
      const std::string line = all.substr(at, all.find('\n', at) - at);
      EXPECT_NE(line.find(name), std::string::npos) << line;
      EXPECT_NE(line.find(words), std::string::npos) << line;
    }
    EXPECT_EQ(all.find("0 seam edges"), std::string::npos) << "of a layout that nobody looked at";
    EXPECT_EQ(all.find("error of 0"), std::string::npos) << "that nobody measured";
    // Named by an option, it ends the run before anything is written.
    std::filesystem::remove(folder_ / "b.glb");
    const testing::Ended refused = run("optimize a.glb -o b.glb -p 'displacement(map=\"" + name + "\")'");
    EXPECT_EQ(refused.code, 1) << refused.err;
    EXPECT_NE(refused.err.find(name + " cannot be read"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.glb"));
  }
}

TEST_F(DisplacedFiles, OptionsThatAreNoNumbersAreRefused) {
  testing::put(folder_ / "a.glb", Parts().glb());
  for (const char* option :
       {"tessellate.parts", "tessellate.texels", "tessellate.levels", "tessellate.most",
        "tessellation-levels.triangles", "tessellation-levels.error", "displacement.factor", "displacement.offset",
        "displacement.uv", "displacement-seams.bits", "displacement-seams.iterations", "crowd-levels.characters"}) {
    const std::string stage = std::string(option).substr(0, std::string(option).find('.'));
    const std::string name = std::string(option).substr(stage.size() + 1);
    for (const char* wrong : {"nan", "-inf", "1e300", "-1e31", "text"}) {
      const testing::Ended ended = run("plan a.glb -p '" + stage + '(' + name + '=' + wrong + ")'");
      EXPECT_EQ(ended.code, 1) << option << '=' << wrong;
      EXPECT_NE(ended.err.find('\'' + name + '\''), std::string::npos) << ended.err;
    }
  }
  for (const char* option : {"tessellate(parts=0)", "tessellate(parts=65)", "tessellate(levels=0)",
                             "tessellate(levels=8)", "displacement-seams(bits=17)", "crowd-levels(characters=0)"}) {
    const testing::Ended ended = run("plan a.glb -p '" + std::string(option) + '\'');
    EXPECT_EQ(ended.code, 1) << option;
    EXPECT_NE(ended.err.find("but must be"), std::string::npos) << ended.err;
  }
}
#endif

}  // namespace
}  // namespace foredraw
