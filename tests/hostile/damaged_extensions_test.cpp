// Our own extensions, damaged member by member: what is wrong costs the extension and never the file, and is told.
#include "own_extensions.h"

#include "support/program.h"

#include <span>

namespace foredraw::damaged_extensions_test {
namespace {

using testing::Damaged;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::OwnExtension;

const std::vector<GltfJson>& wrong_values() {
  static const std::vector<GltfJson> all = {"text",
                                            -1,
                                            1e300,
                                            std::int64_t{1} << 32,
                                            GltfJson(),
                                            GltfJson::array(),
                                            GltfJson::object(),
                                            GltfJson::array({-1, "text"})};
  return all;
}

/// Each part below `value`, which is a part of `whole`, in turn missing or something else.
void damage(GltfJson& value, const std::string& place, const GltfBuilder& whole, std::vector<Damaged>& all) {
  if (!value.is_structured()) return;
  const GltfJson kept = value;
  for (const auto& [key, part] : kept.items()) {
    const std::string member = place + '/' + key;
    GltfJson& here = kept.is_array() ? value[std::stoul(key)] : value[key];
    damage(here, member, whole, all);
    for (const GltfJson& wrong : wrong_values()) {
      if (wrong == part || (wrong.is_string() && part.is_string())) continue;  // a name is a name
      here = wrong;
      all.push_back({member + " is " + wrong.dump(), whole.glb()});
    }
    if (kept.is_array()) {
      value.erase(std::stoul(key));
    } else {
      value.erase(key);
    }
    all.push_back({member + " is missing", whole.glb()});
    value = kept;
  }
}

/// Wherever the file has the extension.
std::vector<Damaged> damaged(const OwnExtension& extension) {
  GltfBuilder builder = testing::file_with(extension);
  std::vector<Damaged> all;
  const auto damage_in = [&](GltfJson& owner, const std::string& place) {
    if (!owner.contains("extensions") || !owner["extensions"].contains(extension.name)) return;
    GltfJson& value = owner["extensions"][extension.name];
    damage(value, place, builder, all);
    const GltfJson kept = value;
    for (const GltfJson& wrong : wrong_values()) {
      value = wrong;
      all.push_back({place + " is " + wrong.dump(), builder.glb()});
    }
    value = kept;
  };
  damage_in(builder.json, "file");
  damage_in(builder.json["meshes"][0]["primitives"][0], "primitive");
  return all;
}

class DamagedExtension : public testing::InFolder, public ::testing::WithParamInterface<OwnExtension> {};

TEST_P(DamagedExtension, CostsItselfAloneAndIsTold) {
  const std::vector<Damaged> all = damaged(GetParam());
  EXPECT_GT(all.size(), 8u);
  for (const Damaged& one : all) testing::expect_to_cost_itself_alone(GetParam(), one);
}

#ifdef FOREDRAW_PROGRAM
TEST_P(DamagedExtension, GoesThroughTheProgram) {
  constexpr std::size_t most_files = 60;
  const std::vector<Damaged> all = damaged(GetParam());
  const std::size_t step = (all.size() + most_files - 1) / most_files;
  std::filesystem::create_directory(folder_ / "in");
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < all.size(); i += step) {
    numbers.push_back(i);
    testing::put(folder_ / "in" / (std::to_string(i) + ".glb"),
                 {reinterpret_cast<const char*>(all[i].glb.data()), all[i].glb.size()});
  }
  const auto expect_told = [&](const std::string& command, std::span<const std::size_t> of) {
    const testing::Ended ended = testing::run_program(folder_, command);
    EXPECT_EQ(ended.code, 0) << command << '\n' << ended.err.substr(0, 2000);
    for (const std::size_t i : of) {
      const bool is_told = ended.err.find("in/" + std::to_string(i) + ".glb: warning: ") != std::string::npos;
      EXPECT_NE(is_told, testing::is_harmless(GetParam(), all[i])) << command << ": " << all[i].what;
    }
  };
  expect_told("measure in --with vertex-cache", numbers);
  expect_told("optimize in -o out -p 'weld, tipsify, vertex-fetch' --threads 2", numbers);
  EXPECT_EQ(static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {})),
            numbers.size());
  for (std::size_t i = 0; i < numbers.size(); i += 10) {
    expect_told("inspect in/" + std::to_string(numbers[i]) + ".glb", std::span(numbers).subspan(i, 1));
  }
}
#endif

INSTANTIATE_TEST_SUITE_P(Ours, DamagedExtension, ::testing::ValuesIn(testing::own_extensions()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace foredraw::damaged_extensions_test
