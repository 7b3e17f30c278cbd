// Meshes that a finder of wires and of closed shells must survive, and files whose wires are not what they should be,
// through the program: each ends, comes out, and shows no figure that is no number.
#include "support/expect_numbers.h"
#include "support/gltf_builder.h"
#include "support/hostile_wires.h"
#include "support/program.h"

#include <algorithm>
#include <functional>

namespace foredraw::wire_files_test {
namespace {

#ifdef FOREDRAW_PROGRAM
using testing::GltfBuilder;
using testing::GltfJson;
using testing::HostileWire;

const std::vector<std::string> pipelines = {"@wires", "second-depth", "wire-radius, second-depth",
                                            "second-depth, wire-radius(as=texcoords), tipsify"};
const std::string evaluators =
    "antialiasing(size=32, views=1, frames=2, truth-samples=16), thin-parts(size=32, views=1)";

/// A file that holds a mesh, with its primitive open to harm.
struct WireFile {
  GltfBuilder file;

  explicit WireFile(const HostileWire& mesh) {
    std::vector<float> positions;
    for (const glm::vec3& at : mesh.positions) positions.insert(positions.end(), {at.x, at.y, at.z});
    file.add_mesh({{"attributes", {{"POSITION", file.add_values(positions, "VEC3")}}},
                   {"indices", file.add_values(mesh.indices, "SCALAR")}});
  }

  GltfJson& primitive() { return file.json["meshes"][0]["primitives"][0]; }
  GltfJson& attributes() { return primitive()["attributes"]; }
  std::size_t vertices() {
    return file.json["accessors"][attributes()["POSITION"].get<std::size_t>()]["count"].get<std::size_t>();
  }

  std::string glb() const {
    const std::vector<std::byte> bytes = file.glb();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

struct Case {
  const char* name;
  std::function<void(WireFile&)> harm;
  const char* says = "";  ///< of the stage wire-radius
};

/// Positions as whole numbers of 16 bits, of which the radius takes two steps.
void quantize(WireFile& of) {
  HostileWire mesh = testing::tube_of_two_steps();
  std::vector<std::uint16_t> steps;
  for (const glm::vec3& at : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) steps.push_back(static_cast<std::uint16_t>(at[axis] + 100));
    steps.push_back(0);  // rows of 8 bytes
  }
  const std::size_t view = of.file.add_view(std::as_bytes(std::span(steps)), 8);
  of.file.json["bufferViews"][view]["target"] = 34962;
  of.attributes()["POSITION"] = of.file.add_accessor(view, 0, 5123, "VEC3", mesh.positions.size());
  of.primitive()["indices"] = of.file.add_values(mesh.indices, "SCALAR");
  of.file.json["extensionsUsed"] = of.file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
}

/// As many vertices as indices of 16 bits can name; the last seven are in no triangle.
void fill_sixteen_bits(WireFile& of) {
  HostileWire mesh;
  mesh.tube(8191, testing::straight, 0.1);
  mesh.positions.resize(65535, glm::vec3(0));
  of = WireFile(mesh);
  of.primitive()["indices"] =
      of.file.add_values(std::vector<std::uint16_t>(mesh.indices.begin(), mesh.indices.end()), "SCALAR");
}

/// In each ring half of the vertices follow another joint.
void skin(WireFile& of) {
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (std::size_t v = 0; v < of.vertices(); ++v) {
    joints.insert(joints.end(), {0, 1, 0, 0});
    const float first = v % 8 < 4 ? 1 : 0.25f;
    weights.insert(weights.end(), {first, 1 - first, 0, 0});
  }
  of.attributes()["JOINTS_0"] = of.file.add_values(joints, "VEC4");
  of.attributes()["WEIGHTS_0"] = of.file.add_values(weights, "VEC4");
  of.file.json["nodes"][0]["skin"] = 0;
  const std::size_t a = of.file.add("nodes", {{"name", "a"}}), b = of.file.add("nodes", {{"name", "b"}});
  of.file.add("skins", {{"joints", {a, b}}});
}

void bend(WireFile& of) {
  std::vector<float> moves(3 * of.vertices(), 0);
  for (std::size_t v = 0; v < of.vertices(); ++v) moves[3 * v + 1] = static_cast<float>(v) * 0.1f;
  of.primitive()["targets"] = {{{"POSITION", of.file.add_values(moves, "VEC3")}}};
}

Case mode(const char* name, int number) {
  return {name, [=](WireFile& of) { of.primitive()["mode"] = number; }};
}

template <class T>
Case stale(const char* name, const char* attribute, const char* type, std::size_t components) {
  return {name, [=](WireFile& of) {
            of.attributes()[attribute] =
                of.file.add_values(std::vector<T>(components * of.vertices(), static_cast<T>(7)), type);
          }};
}

const std::vector<Case> harmed = {
    {"plain", [](WireFile&) {}, "1 tube, 0 ribbons and 0 nets"},
    {"quantized", quantize},
    {"mixed-weights", skin},
    {"bent-by-morphs", bend, "morph"},
    mode("points", 0),
    mode("lines", 1),
    mode("line-loop", 2),
    mode("line-strip", 3),
    mode("strip", 5),
    mode("fan", 6),
    stale<float>("stale-scalar", "_FOREDRAW_WIRE", "SCALAR", 1),
    stale<float>("stale-right-type", "_FOREDRAW_WIRE", "VEC4", 4),
    stale<std::uint8_t>("stale-bytes", "_FOREDRAW_WIRE", "VEC4", 4),
    stale<float>("stale-axis", "_FOREDRAW_WIRE_AXIS", "VEC2", 2),
    {"no-indices", [](WireFile& of) { of.primitive().erase("indices"); }},
    {"node-scale-0",
     [](WireFile& of) {
       of.file.json["nodes"][0]["scale"] = {0, 0, 0};
     }},
    {"node-scale-1e20",
     [](WireFile& of) {
       of.file.json["nodes"][0]["scale"] = {1e20, 1e20, 1e20};
     }},
    {"node-flat",
     [](WireFile& of) {
       of.file.json["nodes"][0]["scale"] = {1, 0, 1};
     }},
    {"node-mirrored",
     [](WireFile& of) {
       of.file.json["nodes"][0]["scale"] = {-1, 5, 1};
     }},
    {"blended",
     [](WireFile& of) {
       of.primitive()["material"] = of.file.add("materials", {{"alphaMode", "BLEND"}});
     }},
};

class WireFiles : public testing::InFolder {
 protected:
  testing::Ended run(const std::string& command) { return testing::run_program(folder_, command); }

  /// What lies in the folder "in" goes through every pipeline and is measured before and behind it.
  void expect_all_go_through() {
    const auto files_in = [&](const char* name) {
      return std::distance(std::filesystem::directory_iterator(folder_ / name), {});
    };
    for (const std::string& stages : pipelines) {
      std::filesystem::remove_all(folder_ / "out");
      const std::string command = "optimize in -o out -p '" + stages + "' --with vertex-cache --threads 2";
      testing::expect_numbers(run(command), command);
      ASSERT_TRUE(std::filesystem::is_directory(folder_ / "out")) << command;
      EXPECT_EQ(files_in("out"), files_in("in")) << command;
      const std::string again = "measure out --with '" + evaluators + "' --threads 2";
      testing::expect_numbers(run(again), again + " after " + stages);
    }
  }
};

TEST_F(WireFiles, MeshesGoThroughEveryPipeline) {
  std::filesystem::create_directory(folder_ / "in");
  for (const auto& [name, mesh] : testing::hostile_wires())
    testing::put(folder_ / "in" / (name + ".glb"), WireFile(mesh).glb());
  expect_all_go_through();
}

TEST_F(WireFiles, FilesGoThroughEveryPipelineAndAreTold) {
  std::filesystem::create_directory(folder_ / "in");
  for (const Case& one : harmed) {
    WireFile file(testing::straight_tube(0.1));
    one.harm(file);
    testing::put(folder_ / "in" / (std::string(one.name) + ".glb"), file.glb());
    if (*one.says == '\0') continue;
    const testing::Ended ended =
        run("optimize in/" + std::string(one.name) + ".glb -o b.glb -p wire-radius --with vertex-cache");
    EXPECT_EQ(ended.code, 0) << one.name << ended.err;
    EXPECT_NE((ended.out + ended.err).find(one.says), std::string::npos) << one.name << '\n' << ended.out << ended.err;
  }
  expect_all_go_through();
}

std::string with_sixteen_bits_full() {
  WireFile file(testing::straight_tube(0.1));
  fill_sixteen_bits(file);
  return file.glb();
}

TEST_F(WireFiles, AsManyVerticesAsSixteenBitsNameGoThrough) {
  testing::put(folder_ / "a.glb", with_sixteen_bits_full());
  const std::string command = "optimize a.glb -o b.glb -p 'wire-radius, second-depth' --with vertex-cache --threads 2";
  testing::expect_numbers(run(command), command);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "b.glb"));
}

TEST_F(WireFiles, AsManyVerticesAsSixteenBitsNameGoThroughEveryPipelineLong) {
  std::filesystem::create_directory(folder_ / "in");
  testing::put(folder_ / "in/a.glb", with_sixteen_bits_full());
  expect_all_go_through();
}

/// A stream with fewer rows than vertices is no glTF: refused with its place.
TEST_F(WireFiles, StreamsOfAnotherLengthAreRefused) {
  WireFile file(testing::straight_tube(0.1));
  file.attributes()["_FOREDRAW_WIRE"] = file.file.add_values(std::vector<float>(4 * (file.vertices() - 1)), "VEC4");
  testing::put(folder_ / "a.glb", file.glb());
  const testing::Ended ended = run("optimize a.glb -o b.glb -p @wires");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_NE(ended.err.find("a.glb: error: "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("_FOREDRAW_WIRE"), std::string::npos) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b.glb"));
}

TEST_F(WireFiles, PipelinesAreCompared) {
  testing::put(folder_ / "a.glb", WireFile(testing::chain_link_net()).glb());
  const std::string command = "compare a.glb -p @wires -p second-depth --with '" + evaluators + "'";
  testing::expect_numbers(run(command), command);
}

TEST_F(WireFiles, OptionsThatMayNotBeAreRefused) {
  testing::put(folder_ / "a.glb", WireFile(testing::straight_tube(0.1)).glb());
  for (const char* stage : {"wire-radius(slender=nan)", "wire-radius(slender=1)", "wire-radius(aspect=0)",
                            "wire-radius(taper=-1)", "wire-radius(decal=inf)", "wire-radius(least-length=-1)",
                            "wire-radius(as=colours)", "wire-radius(ribbons=2)", "second-depth(skinned=perhaps)"}) {
    const testing::Ended ended = run("optimize a.glb -o b.glb -p '" + std::string(stage) + '\'');
    EXPECT_EQ(ended.code, 1) << stage;
    const std::string option = std::string(stage).substr(std::string(stage).find('(') + 1);
    EXPECT_NE(ended.err.find('\'' + option.substr(0, option.find('=')) + '\''), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.glb"));
  }
  for (const char* evaluator :
       {"antialiasing(ways=msaa-3)", "antialiasing(ways=\"\")", "antialiasing(size=0)", "antialiasing(frames=nan)",
        "antialiasing(truth-samples=100)", "antialiasing(step=-1)", "thin-parts(size=1e300)", "thin-parts(views=0)"}) {
    const testing::Ended ended = run("measure a.glb --with '" + std::string(evaluator) + '\'');
    EXPECT_EQ(ended.code, 1) << evaluator << ended.err;
    EXPECT_NE(ended.err.find("error"), std::string::npos) << ended.err;
  }
}
#endif

}  // namespace
}  // namespace foredraw::wire_files_test
