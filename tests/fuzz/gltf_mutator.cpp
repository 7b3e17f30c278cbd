#include "gltf_mutator.h"

#include <foredraw/base/random.h>

#include <cstring>
#include <string>
#include <vector>

#include "support/gltf_builder.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace foredraw {
namespace {

using Json = testing::GltfJson;

struct Parts {
  Json json;
  std::vector<std::byte> bin;
};

std::uint32_t word(const std::uint8_t* data, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, data + at, 4);
  return value;
}

/// Nothing where it is not a GLB whose JSON can be read.
std::vector<Parts> parts_of(const std::uint8_t* data, std::size_t size) {
  if (size < 20 || word(data, 0) != 0x46546C67 || word(data, 12) > size - 20) return {};
  const std::size_t end = 20 + std::size_t{word(data, 12)};
  Parts parts{Json::parse(data + 20, data + end, nullptr, false), {}};
  if (!parts.json.is_object()) return {};
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  if (size >= end + 8) parts.bin.assign(bytes + end + 8, bytes + size);
  return {std::move(parts)};
}

void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  if (!value.is_structured()) return;
  for (Json& part : value) collect(part, all);
}

Json harmful(Random& random) {
  const Json values[] = {
      0,   1,    2,           3,      5121,     5123,   5126, 65535,   4294967295u,   std::int64_t{1} << 40, -1,
      0.5, 1e30, "TRIANGLES", "VEC3", "SCALAR", "MAT4", true, nullptr, Json::array(), Json::object()};
  return values[random.below(std::size(values))];
}

void change_tree(Json& json, Random& random) {
  std::vector<Json*> all;
  collect(json, all);
  Json& target = *all[random.below(all.size())];
  Json& other = *all[random.below(all.size())];
  switch (random.below(6)) {
    case 0: target = harmful(random); break;
    case 1:  // what stands elsewhere in the file fits more often than not
      target = Json(other);
      break;
    case 2:  // a little more or less
      if (target.is_number_integer())
        target = target.get<std::int64_t>() + static_cast<std::int64_t>(random.below(9)) - 4;
      break;
    case 3:
      if (target.is_array() && !target.empty()) target.erase(random.below(target.size()));
      if (target.is_object() && !target.empty())
        target.erase(std::next(target.begin(), static_cast<std::ptrdiff_t>(random.below(target.size()))).key());
      break;
    case 4:
      if (target.is_array() && !target.empty()) target.push_back(Json(target[random.below(target.size())]));
      break;
    default:
      if (target.is_object() && other.is_object() && !other.empty()) {
        const auto taken = std::next(other.begin(), static_cast<std::ptrdiff_t>(random.below(other.size())));
        const std::string key = taken.key();
        const Json value = taken.value();
        target[key] = value;
      }
  }
}

void change_bytes(std::vector<std::byte>& bin, Random& random) {
  if (bin.empty()) return;
  const std::size_t at = random.below(bin.size());
  const float floats[] = {
      0, 1, -1, 0.5f, 1e30f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  switch (random.below(3)) {
    case 0: bin[at] = static_cast<std::byte>(random.below(256)); break;
    case 1:
      if (at + 4 <= bin.size()) std::memcpy(bin.data() + at / 4 * 4, &floats[random.below(std::size(floats))], 4);
      break;
    default:
      for (std::size_t i = at; i < std::min(bin.size(), at + 12); ++i) bin[i] = bin[random.below(bin.size())];
  }
}

}  // namespace

std::size_t mutate_gltf(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  Random random(seed);
  std::vector<Parts> parts = parts_of(data, size);
  if (parts.empty() || random.below(16) == 0) return LLVMFuzzerMutate(data, size, most);
  for (std::uint64_t n = random.below(3) + 1; n > 0; --n) {
    if (random.below(3) == 0) {
      change_bytes(parts[0].bin, random);
    } else {
      change_tree(parts[0].json, random);
    }
  }
  // A change that is refused early teaches nothing: most files keep a buffer that agrees with its bytes.
  Json& json = parts[0].json;
  if (json.is_object() && json.contains("buffers") && json["buffers"].is_array() && json["buffers"].size() == 1 &&
      random.below(8) != 0) {
    json["buffers"][0] = {{"byteLength", parts[0].bin.size()}};
  }
  const std::vector<std::byte> made =
      testing::glb_of(json.dump(-1, ' ', false, Json::error_handler_t::replace), parts[0].bin);
  if (made.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, made.data(), made.size());
  return made.size();
}

}  // namespace foredraw
