// Streams of our own extensions, damaged: what is wrong costs the extension and never the file, and is told.
#include "own_extensions.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

namespace foredraw::damaged_streams_test {
namespace {

using testing::Damaged;
using testing::GltfBuilder;
using testing::GltfJson;
using testing::OwnExtension;

std::set<std::size_t> accessors_of_full_detail(const GltfBuilder& builder) {
  const GltfJson& primitive = builder.json["meshes"][0]["primitives"][0];
  std::set<std::size_t> all{primitive["indices"]};
  for (const auto& [semantic, number] : primitive["attributes"].items()) all.insert(number.get<std::size_t>());
  return all;
}

/// [member of the primitive's extension, or member of a member ...] the accessor that it names.
std::map<std::string, std::size_t> accessors_of(const GltfBuilder& builder, const OwnExtension& extension) {
  const std::set<std::size_t> others = accessors_of_full_detail(builder);
  std::map<std::string, std::size_t> own;
  const std::function<void(const std::string&, const GltfJson&)> add = [&](const std::string& name,
                                                                           const GltfJson& value) {
    const bool is_accessor = value.is_number_unsigned() && value < builder.json["accessors"].size();
    if (is_accessor && !others.contains(value)) own[name] = value;
    if (!value.is_structured()) return;
    for (const auto& [inner, part] : value.items()) add(name + '/' + inner, part);
  };
  if (builder.json.contains("extensions")) add("file", builder.json["extensions"].value(extension.name, GltfJson()));
  const GltfJson& primitive = builder.json["meshes"][0]["primitives"][0];
  if (primitive.contains("extensions")) add("primitive", primitive["extensions"].value(extension.name, GltfJson()));
  return own;
}

/// Views that the damaged extension alone names, compressed, with bytes or words that no decoder takes.
std::vector<Damaged> damaged_compressed_views(const OwnExtension& extension) {
  const GltfBuilder whole = testing::file_with(extension, Compression::ext);
  std::set<std::size_t> own, others;
  const auto view_of = [&](std::size_t accessor) {
    return whole.json["accessors"][accessor]["bufferView"].get<std::size_t>();
  };
  for (const std::size_t accessor : accessors_of_full_detail(whole)) others.insert(view_of(accessor));
  for (const auto& [name, accessor] : accessors_of(whole, extension)) own.insert(view_of(accessor));
  std::vector<Damaged> all;
  for (const std::size_t view : own) {
    const GltfJson& of = whole.json["bufferViews"][view];
    if (others.contains(view) || !of.contains("extensions")) continue;
    const auto put = [&](const char* what, const auto& change) {
      GltfBuilder harmed = whole;
      change(harmed, harmed.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"]);
      all.push_back({"view " + std::to_string(view) + ' ' + what, harmed.glb()});
    };
    put("starts with a byte of no codec", [](GltfBuilder& file, const GltfJson& stream) {
      file.buffer[stream.value("byteOffset", std::size_t{0})] = std::byte{0x55};
    });
    put("ends early", [](GltfBuilder&, GltfJson& stream) { stream["byteLength"] = 1; });
    put("lies behind all bytes", [](GltfBuilder&, GltfJson& stream) { stream["byteOffset"] = 1 << 30; });
    put("lies in no buffer", [](GltfBuilder&, GltfJson& stream) { stream["buffer"] = 7; });
    put("has no count", [](GltfBuilder&, GltfJson& stream) { stream.erase("count"); });
    put("has too many elements", [](GltfBuilder&, GltfJson& stream) { stream["count"] = 1 << 30; });
    put("has a mode of its own", [](GltfBuilder&, GltfJson& stream) { stream["mode"] = "SHELLS"; });
    put("has a filter of its own", [](GltfBuilder&, GltfJson& stream) { stream["filter"] = "COFFEE"; });
    put("is no object", [](GltfBuilder&, GltfJson& stream) { stream = "text"; });
  }
  return all;
}

/// Streams that are a row short, one too long, of another kind, or hold bits that are all set or all different.
std::vector<Damaged> damaged_streams(const OwnExtension& extension) {
  const GltfBuilder whole = testing::file_with(extension);
  std::vector<Damaged> all;
  const auto put = [&](const auto& accessor, const char* what, const auto& change) {
    GltfBuilder harmed = whole;
    change(harmed, harmed.json["accessors"][accessor.second]);
    all.push_back({accessor.first + ' ' + what, harmed.glb()});
  };
  const auto fill = [](GltfBuilder& file, const GltfJson& accessor, const auto& byte) {
    const GltfJson& view = file.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::string type = accessor["type"];
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
    const int component = accessor["componentType"];
    const std::size_t width = component < 5122 ? 1 : component < 5124 ? 2 : 4;
    const std::size_t from = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    const std::size_t size = accessor["count"].get<std::size_t>() * components * width;
    for (std::size_t i = 0; i < size; ++i) file.buffer[from + i] = static_cast<std::byte>(byte(i));
  };
  for (const auto& accessor : accessors_of(whole, extension)) {
    put(accessor, "is a row short", [](GltfBuilder&, GltfJson& of) { of["count"] = of["count"].get<int>() - 1; });
    put(accessor, "is a row too long", [](GltfBuilder&, GltfJson& of) { of["count"] = of["count"].get<int>() + 1; });
    put(accessor, "is of another kind", [](GltfBuilder&, GltfJson& of) { of["componentType"] = 5122; });
    put(accessor, "has all bits set",
        [&](GltfBuilder& file, GltfJson& of) { fill(file, of, [](std::size_t) { return 255; }); });
    put(accessor, "is noise",
        [&](GltfBuilder& file, GltfJson& of) { fill(file, of, [](std::size_t i) { return i * 167 + 13; }); });
    put(accessor, "has no elements", [](GltfBuilder&, GltfJson& of) { of["count"] = 0; });
    put(accessor, "has a type of its own", [](GltfBuilder&, GltfJson& of) { of["type"] = "VEC7"; });
    put(accessor, "lies in no view", [](GltfBuilder&, GltfJson& of) { of["bufferView"] = 9999; });
    put(accessor, "lies in a view that ends before it", [](GltfBuilder& file, GltfJson& of) {
      of["bufferView"] = file.add("bufferViews", {{"buffer", 0}, {"byteLength", 1}});
    });
    put(accessor, "lies in a view behind all bytes", [](GltfBuilder& file, GltfJson& of) {
      of["bufferView"] = file.add("bufferViews", {{"buffer", 0}, {"byteOffset", 1 << 30}, {"byteLength", 1 << 20}});
    });
  }
  return all;
}

class DamagedStreams : public ::testing::TestWithParam<OwnExtension> {};

TEST_P(DamagedStreams, CostTheExtensionAloneAndAreTold) {
  const std::vector<Damaged> all = damaged_streams(GetParam());
  EXPECT_GE(all.size(), 5u);
  for (const Damaged& one : all) testing::expect_to_cost_itself_alone(GetParam(), one);
}

TEST_P(DamagedStreams, CostTheExtensionAloneWhereTheyAreCompressed) {
  const std::vector<Damaged> all = damaged_compressed_views(GetParam());
  for (const Damaged& one : all) testing::expect_to_cost_itself_alone(GetParam(), one);
  const std::string_view name = GetParam().name;
  if (name == "FOREDRAW_levels" || name == "FOREDRAW_geomorph") {
    EXPECT_GE(all.size(), 9u);
  }
}

INSTANTIATE_TEST_SUITE_P(Ours, DamagedStreams, ::testing::ValuesIn(testing::own_extensions_with_streams()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace foredraw::damaged_streams_test
