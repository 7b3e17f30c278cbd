// The outermost layer, and hostile bytes: whatever comes is read or refused in words.
#include <foredraw/base/random.h>
#include <foredraw/io/gltf/gltf.h>

#include <gtest/gtest.h>

#include "support/gltf_builder.h"
#include "support/meshes.h"

namespace foredraw::container_test {
namespace {

using testing::bytes_of;

const std::string least = R"({"asset":{"version":"2.0"}})";

std::string code_of(std::span<const std::byte> bytes) {
  Diagnostics diagnostics;
  const auto scene = read_gltf({bytes.begin(), bytes.end()}, "file", {}, diagnostics);
  EXPECT_EQ(scene.has_value(), !diagnostics.has_errors());
  return diagnostics.empty() ? "" : diagnostics.all().front().code;
}

void set_word(std::vector<std::byte>& file, std::size_t at, std::uint32_t value) {
  std::memcpy(file.data() + at, &value, 4);
}

TEST(GltfContainer, least_file_is_a_scene) {
  EXPECT_EQ(code_of(bytes_of(least)), "");
  EXPECT_EQ(code_of(testing::glb_of(least, {})), "");
}

TEST(GltfContainer, other_formats_are_named_so) {
  for (const char* text : {"", "solid cube", "ply\n", "[1]", "\x89PNG", "glT", "   "}) {
    EXPECT_EQ(code_of(bytes_of(text)), "not-gltf") << text;
  }
}

TEST(GltfContainer, header_and_chunks_must_agree_with_the_bytes) {
  const std::vector<std::byte> good = testing::ribbon(2).glb();
  const auto with = [&](std::size_t at, std::uint32_t value) {
    std::vector<std::byte> file = good;
    set_word(file, at, value);
    return code_of(file);
  };
  ASSERT_EQ(code_of(good), "");
  EXPECT_EQ(with(4, 1), "gltf-version");
  EXPECT_EQ(with(8, 11), "glb-length");
  EXPECT_EQ(with(8, 0xffffffff), "glb-length");
  EXPECT_EQ(with(12, 0xfffffffc), "glb-chunk");
  EXPECT_EQ(with(12, 0), "glb-chunk");
  EXPECT_EQ(with(16, 0x004E4942), "glb-chunk");
}

TEST(GltfContainer, chunks_have_their_sequence) {
  std::vector<std::byte> twice = testing::glb_of(least, {});
  const std::vector<std::byte> chunk(twice.begin() + 12, twice.end());
  twice.insert(twice.end(), chunk.begin(), chunk.end());
  set_word(twice, 8, static_cast<std::uint32_t>(twice.size()));
  EXPECT_EQ(code_of(twice), "glb-chunk");
  set_word(twice, 12 + chunk.size() + 4, 0x31323334);  // a kind of one's own may follow
  EXPECT_EQ(code_of(twice), "");
}

TEST(GltfContainer, json_mistakes_have_line_and_column) {
  Diagnostics diagnostics;
  read_gltf(bytes_of("{\n  \"asset\": {\n    \"version\" \"2.0\"\n  }\n}"), "file.gltf", {}, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "json-syntax");
  EXPECT_EQ(diagnostics.all()[0].where.line, 3);
  EXPECT_GE(diagnostics.all()[0].where.column, 15);
}

TEST(GltfContainer, json_that_readers_take_differently_is_refused) {
  EXPECT_EQ(code_of(bytes_of(R"({"asset":{"version":"2.0","version":"2.1"}})")), "json-duplicate-key");
  EXPECT_EQ(code_of(bytes_of(R"({"asset":{"version":"2.0"},"extras":1e999})")), "json-syntax");
  EXPECT_EQ(code_of(bytes_of("{\"asset\":{\"version\":\"2.0\"},\"extras\":\"\xff\"}")), "json-syntax");
}

TEST(GltfContainer, depth_is_bounded_before_anything_is_parsed) {
  const auto nested = [](std::size_t depth) {
    return bytes_of(R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') + std::string(depth, ']') +
                    "}");
  };
  EXPECT_EQ(code_of(nested(63)), "");
  EXPECT_EQ(code_of(nested(64)), "json-nesting");
  EXPECT_EQ(code_of(nested(2'000'000)), "json-nesting");
  EXPECT_EQ(code_of(bytes_of(R"({"asset":{"version":"2.0"},"extras":")" + std::string(100, '[') + "\\\"[\"}")), "");
}

/// Reads what may be broken, and where it is read, writes and reads it again.
void try_out(std::span<const std::byte> bytes) {
  Diagnostics diagnostics;
  const auto scene = read_gltf({bytes.begin(), bytes.end()}, "file", {}, diagnostics);
  ASSERT_EQ(scene.has_value(), !diagnostics.has_errors()) << to_text(diagnostics);
  if (!scene) return;
  const auto files = encode_gltf(*scene, "out.gltf", diagnostics);
  EXPECT_TRUE(files) << to_text(diagnostics);
}

TEST(GltfContainer, truncated_files_are_refused) {
  const std::vector<std::byte> good = testing::puppet().glb();
  for (std::size_t length = 0; length < good.size(); length += 97) {
    EXPECT_NE(code_of(std::span(good).first(length)), "") << length;
  }
  // The same with a header that knows of it, so that what lies deeper is reached.
  for (std::size_t length = 12; length < good.size(); length += 4) {
    std::vector<std::byte> file(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length));
    set_word(file, 8, static_cast<std::uint32_t>(length));
    try_out(file);
  }
}

TEST(GltfContainer, mutated_bytes_are_read_or_refused) {
  const std::vector<std::byte> good = testing::puppet().glb();
  Random random(1);
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::byte> file = good;
    for (std::uint64_t n = random.below(3) + 1; n > 0; --n) {
      file[random.below(file.size())] = static_cast<std::byte>(random.below(256));
    }
    try_out(file);
  }
}

/// Every number in the JSON is replaced by numbers that do harm.
void mutate_numbers(testing::GltfJson& value, const testing::GltfBuilder& whole) {
  if (value.is_structured()) {
    for (auto& part : value) mutate_numbers(part, whole);
  } else if (value.is_number()) {
    const testing::GltfJson kept = value;
    for (const testing::GltfJson& harm :
         std::initializer_list<testing::GltfJson>{-1, 0, 1, 2, 7, 255, 65536, 4294967295u, std::int64_t{1} << 40,
                                                  18446744073709551615ull, 1e30, "x", nullptr}) {
      value = harm;
      try_out(whole.glb());
    }
    value = kept;
  }
}

TEST(GltfContainer, mutated_numbers_are_read_or_refused) {
  testing::GltfBuilder builder = testing::puppet();
  mutate_numbers(builder.json, builder);
}

/// Every member is left out in turn, or becomes a value of another type.
void mutate_members(testing::GltfJson& value, const testing::GltfBuilder& whole) {
  if (!value.is_structured()) return;
  for (auto& part : value) {
    mutate_members(part, whole);
    const testing::GltfJson kept = part;
    for (const testing::GltfJson& other : {testing::GltfJson(), testing::GltfJson::object(), testing::GltfJson::array(),
                                           testing::GltfJson("text"), testing::GltfJson(3), testing::GltfJson(true)}) {
      part = other;
      try_out(whole.glb());
    }
    part = kept;
  }
  if (!value.is_object()) return;
  const testing::GltfJson kept = value;
  for (const auto& [key, part] : kept.items()) {
    value.erase(key);
    try_out(whole.glb());
    value = kept;
  }
}

TEST(GltfContainer, members_of_another_type_are_read_or_refused) {
  testing::GltfBuilder builder = testing::puppet();
  mutate_members(builder.json, builder);
}

}  // namespace
}  // namespace foredraw::container_test
