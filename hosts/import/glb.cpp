#include "glb.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>

namespace foredraw::import {

namespace {

using Json = nlohmann::json;
static_assert(std::endian::native == std::endian::little, "glTF's buffers are little endian");

constexpr int unsigned_short = 5123, unsigned_int = 5125, single = 5126;

void put_number(std::string& text, std::size_t number) {
  for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(number >> shift & 0xff);
}

std::string padded(std::string text, char with) {
  text.resize((text.size() + 3) / 4 * 4, with);
  return text;
}

}  // namespace

Glb::Glb() : json({{"asset", {{"version", "2.0"}, {"generator", "foredraw-import"}}}}) {}

std::size_t Glb::add(const char* list, Json object) {
  json[list].push_back(std::move(object));
  return json[list].size() - 1;
}

std::size_t Glb::add_view(std::span<const std::byte> bytes, int target) {
  buffer_ = padded(std::move(buffer_), '\0');
  Json view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  buffer_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return add("bufferViews", std::move(view));
}

std::size_t Glb::add_floats(const std::vector<float>& values, const char* type, std::size_t width, int target,
                            bool with_bounds) {
  Json accessor{{"bufferView", add_view(std::as_bytes(std::span(values)), target)},
                {"componentType", single},
                {"count", values.size() / width},
                {"type", type}};
  if (with_bounds) {
    std::vector<float> low(width, std::numeric_limits<float>::max()), high(width, std::numeric_limits<float>::lowest());
    for (std::size_t i = 0; i < values.size(); ++i) {
      low[i % width] = std::min(low[i % width], values[i]);
      high[i % width] = std::max(high[i % width], values[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
  return add("accessors", std::move(accessor));
}

std::size_t Glb::add_joints(const std::vector<std::uint16_t>& values) {
  return add("accessors", {{"bufferView", add_view(std::as_bytes(std::span(values)), vertices)},
                           {"componentType", unsigned_short},
                           {"count", values.size() / 4},
                           {"type", "VEC4"}});
}

std::size_t Glb::add_indices(const std::vector<std::uint32_t>& values) {
  return add("accessors", {{"bufferView", add_view(std::as_bytes(std::span(values)), elements)},
                           {"componentType", unsigned_int},
                           {"count", values.size()},
                           {"type", "SCALAR"}});
}

std::string Glb::bytes() const {
  Json whole = json;
  if (!buffer_.empty()) whole["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  const std::string text = padded(whole.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  const std::string data = padded(buffer_, '\0');
  const std::size_t length = 12 + 8 + text.size() + (data.empty() ? 0 : 8 + data.size());
  if (length > std::numeric_limits<std::uint32_t>::max()) {
    throw std::runtime_error("its data is longer than the 4 GB that a GLB may have");
  }
  std::string file = "glTF";
  file.reserve(length);
  put_number(file, 2);
  put_number(file, length);
  put_number(file, text.size());
  file += "JSON" + text;
  if (data.empty()) return file;
  put_number(file, data.size());
  file += std::string("BIN\0", 4) + data;
  return file;
}

}  // namespace foredraw::import
