// Lengths, counts, offsets and floats that are not what they should be, wherever a file has some.
#include "whole_way.h"

#include "support/gltf_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw::wrong_numbers_test {
namespace {

using testing::GltfBuilder;
using testing::GltfJson;
using testing::go_the_whole_way;

/// As they stand in the text, for no JSON library would write some of them.
const std::vector<std::string> harmful = {"0",
                                          "1",
                                          "2147483648",
                                          "4294967295",
                                          "4294967296",
                                          "9223372036854775808",
                                          "18446744073709551615",
                                          "18446744073709551616",
                                          "-1",
                                          "-9223372036854775809",
                                          "0.5",
                                          "1e308",
                                          "-1e308",
                                          "1e999",
                                          "1e-400",
                                          "\"3\"",
                                          "null",
                                          "true",
                                          "[]",
                                          "{}"};

/// Calls `with` for the JSON's text with each number in turn replaced by the placeholder.
template <class With>
void with_each_number_replaced(GltfJson& value, const GltfJson& whole, const With& with) {
  if (value.is_structured()) {
    for (auto& part : value) with_each_number_replaced(part, whole, with);
  } else if (value.is_number()) {
    const GltfJson kept = value;
    value = "HERE";
    with(whole.dump());
    value = kept;
  }
}

TEST(WrongNumbers, every_number_in_the_json_is_checked) {
  const GltfBuilder puppet = testing::puppet();
  GltfJson json = puppet.json;
  json["buffers"][0]["byteLength"] = puppet.buffer.size();
  int numbers = 0;
  with_each_number_replaced(json, json, [&](std::string text) {
    ++numbers;
    const std::size_t at = text.find("\"HERE\"");
    for (const std::string& harm : harmful) {
      SCOPED_TRACE(text.substr(at > 60 ? at - 60 : 0, 60) + harm);
      go_the_whole_way(testing::glb_of(std::string(text).replace(at, 6, harm), puppet.buffer));
    }
  });
  EXPECT_GT(numbers, 100);
}

TEST(WrongNumbers, every_word_of_header_and_chunks_is_checked) {
  const std::vector<std::byte> whole = testing::puppet().glb();
  std::uint32_t json_length;
  std::memcpy(&json_length, whole.data() + 12, 4);
  for (const std::size_t at : {std::size_t{0}, std::size_t{4}, std::size_t{8}, std::size_t{12}, std::size_t{16},
                               std::size_t{20} + json_length, std::size_t{24} + json_length}) {
    for (const std::uint32_t value : {0u, 1u, 4u, 0x80000000u, 0xfffffffcu, 0xffffffffu}) {
      std::vector<std::byte> file = whole;
      std::memcpy(file.data() + at, &value, 4);
      const auto codes = go_the_whole_way(file);
      // A chunk of a kind of one's own may stand for BIN; then its bytes are missed.
      EXPECT_FALSE(codes.empty()) << "word at " << at << " is " << value;
    }
  }
}

/// Four bytes at a time: positions, texture coordinates, weights, matrices, key times and values, and whatever else.
TEST(WrongNumbers, every_float_may_be_none) {
  const GltfBuilder puppet = testing::puppet();
  const float values[] = {std::numeric_limits<float>::quiet_NaN(),  std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(),  std::numeric_limits<float>::max(),
                          std::numeric_limits<float>::denorm_min(), -0.0f};
  for (std::size_t at = 0; at + 4 <= puppet.buffer.size(); at += 4) {
    for (const float value : values) {
      GltfBuilder harmed = puppet;
      std::memcpy(harmed.buffer.data() + at, &value, 4);
      SCOPED_TRACE("byte " + std::to_string(at) + " is " + std::to_string(value));
      go_the_whole_way(harmed.glb());
    }
  }
}

struct Field {
  const char* name;
  std::size_t accessor;
  bool may_be_none;  ///< vertex data: it is drawn as it is, and moved as it is
};

TEST(WrongNumbers, floats_that_are_no_vertex_data_must_be_finite) {
  const GltfBuilder puppet = testing::puppet();
  for (const Field& field : {Field{"positions", 0, true}, Field{"uvs", 1, true}, Field{"weights", 4, true},
                             Field{"targets", 5, true}, Field{"matrices", 6, false}, Field{"times", 7, false},
                             Field{"turns", 8, false}, Field{"morph weights", 9, false}}) {
    const std::size_t view = puppet.json["accessors"][field.accessor]["bufferView"];
    const std::size_t at = puppet.json["bufferViews"][view]["byteOffset"];
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity()}) {
      GltfBuilder harmed = puppet;
      std::memcpy(harmed.buffer.data() + at, &value, 4);
      EXPECT_EQ(go_the_whole_way(harmed.glb()).empty(), field.may_be_none) << field.name << ' ' << value;
    }
  }
}

TEST(WrongNumbers, json_numbers_beyond_a_float_are_refused_or_left_out) {
  for (const char* number : {"1e39", "-1e39", "1e308"}) {
    const std::string node =
        std::string(R"({"asset":{"version":"2.0"},"nodes":[{"translation":[)") + number + ",0,0]}]}";
    EXPECT_EQ(go_the_whole_way(testing::bytes_of(node)), std::vector<std::string>{"wrong-type"});
    const std::string material =
        std::string(R"({"asset":{"version":"2.0"},"materials":[{"alphaCutoff":)") + number + "}]}";
    EXPECT_TRUE(go_the_whole_way(testing::bytes_of(material)).empty());  // the default counts
  }
}

TEST(WrongNumbers, sparse_elements_must_lie_where_there_are_some) {
  const GltfBuilder puppet = testing::puppet();
  const std::size_t at = puppet.json["bufferViews"][6]["byteOffset"];
  for (const std::vector<std::uint16_t>& indices :
       {std::vector<std::uint16_t>{1, 4, 10}, {1, 1, 9}, {4, 1, 9}, {65535, 65535, 65535}, {0, 1, 65535}}) {
    GltfBuilder harmed = puppet;
    std::memcpy(harmed.buffer.data() + at, indices.data(), 6);
    EXPECT_EQ(go_the_whole_way(harmed.glb()), std::vector<std::string>{"sparse-indices"});
  }
}

}  // namespace
}  // namespace foredraw::wrong_numbers_test
