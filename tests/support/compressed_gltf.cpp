#include "support/compressed_gltf.h"

#include <meshoptimizer.h>

#include <cstring>
#include <set>
#include <stdexcept>

namespace foredraw::testing {

namespace {

using Bytes = std::vector<std::byte>;

struct Elements {
  std::size_t stride = 0;
  bool indices = false;
};

std::size_t element_bytes(const GltfJson& accessor) {
  const std::string type = accessor["type"];
  const std::size_t components = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<std::size_t>(type[3] - '0');
  const int component = accessor["componentType"];
  return components * (component <= 5121 ? 1 : component <= 5123 ? 2 : 4);
}

/// What lies in each view: the first accessor that uses it says.
std::map<std::size_t, Elements> elements_of(const GltfJson& json) {
  std::set<std::size_t> indices;
  for (const GltfJson& mesh : json["meshes"]) {
    for (const GltfJson& primitive : mesh["primitives"]) {
      if (primitive.contains("indices")) indices.insert(primitive["indices"].get<std::size_t>());
    }
  }
  std::map<std::size_t, Elements> found;
  for (std::size_t a = 0; a < json["accessors"].size(); ++a) {
    const GltfJson& accessor = json["accessors"][a];
    if (!accessor.contains("bufferView")) continue;
    const std::size_t view = accessor["bufferView"];
    const std::size_t stride = json["bufferViews"][view].value("byteStride", element_bytes(accessor));
    found.try_emplace(view, Elements{stride, indices.contains(a)});
  }
  return found;
}

template <class Encode>
Bytes encoded(std::size_t bound, Encode encode) {
  Bytes stream(bound);
  stream.resize(encode(reinterpret_cast<unsigned char*>(stream.data()), bound));
  return stream;
}

Bytes index_stream(const Bytes& plain, std::size_t width, bool triangles) {
  std::vector<unsigned> indices(plain.size() / width, 0);
  for (std::size_t i = 0; i < indices.size(); ++i) std::memcpy(&indices[i], plain.data() + i * width, width);
  meshopt_encodeIndexVersion(1);
  const std::size_t n = indices.size();
  if (triangles) {
    return encoded(meshopt_encodeIndexBufferBound(n, 1 << 20), [&](unsigned char* to, std::size_t most) {
      return meshopt_encodeIndexBuffer(to, most, indices.data(), n);
    });
  }
  return encoded(meshopt_encodeIndexSequenceBound(n, 1 << 20), [&](unsigned char* to, std::size_t most) {
    return meshopt_encodeIndexSequence(to, most, indices.data(), n);
  });
}

/// Values as 8- or 16-bit normalized numbers, or as they are, to floats.
std::vector<float> floats_of(const Bytes& plain, std::size_t count, std::size_t stride, std::size_t width) {
  std::vector<float> values(count * stride / width);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (width == 4) std::memcpy(&values[i], plain.data() + 4 * i, 4);
    if (width == 2) {
      std::int16_t value;
      std::memcpy(&value, plain.data() + 2 * i, 2);
      values[i] = static_cast<float>(value) / 32767;
    }
    if (width == 1) values[i] = static_cast<float>(static_cast<std::int8_t>(plain[i])) / 127;
  }
  return values;
}

/// What goes into the codec; `plain` becomes what comes out of the filter again.
Bytes filtered(Bytes& plain, std::size_t count, std::size_t stride, const std::string& filter) {
  Bytes rows(plain.size());
  if (filter == "OCTAHEDRAL") {
    const auto values = floats_of(plain, count, stride, stride / 4);
    meshopt_encodeFilterOct(rows.data(), count, stride, stride == 4 ? 8 : 12, values.data());
    plain = rows;
    meshopt_decodeFilterOct(plain.data(), count, stride);
  } else if (filter == "QUATERNION") {
    meshopt_encodeFilterQuat(rows.data(), count, stride, 12, floats_of(plain, count, stride, 2).data());
    plain = rows;
    meshopt_decodeFilterQuat(plain.data(), count, stride);
  } else if (filter == "EXPONENTIAL") {
    meshopt_encodeFilterExp(rows.data(), count, stride, 15, floats_of(plain, count, stride, 4).data());
    plain = rows;
    meshopt_decodeFilterExp(plain.data(), count, stride);
  } else {
    throw std::runtime_error("no filter " + filter);
  }
  return rows;
}

std::string base64_uri(const Bytes& bytes) {
  GltfBuilder carrier;
  carrier.buffer = bytes;
  return json_of(carrier.gltf())["buffers"][0]["uri"];
}

std::size_t append(Bytes& to, const Bytes& bytes) {
  to.resize((to.size() + 7) / 8 * 8);
  to.insert(to.end(), bytes.begin(), bytes.end());
  return to.size() - bytes.size();
}

}  // namespace

GltfBuilder compressed(const GltfBuilder& plain, const CompressionChoice& choice) {
  using Plain = CompressionChoice::Plain;
  GltfBuilder made;
  made.json = plain.json;
  Bytes fallback;
  const auto elements = elements_of(plain.json);
  for (std::size_t v = 0; v < plain.json["bufferViews"].size(); ++v) {
    GltfJson& view = made.json["bufferViews"][v];
    const auto from = plain.buffer.begin() + view.value("byteOffset", std::ptrdiff_t{0});
    Bytes bytes(from, from + view["byteLength"].get<std::ptrdiff_t>());
    const auto found = elements.find(v);
    const Elements what = found == elements.end() ? Elements{} : found->second;
    if (what.stride == 0 || (!what.indices && what.stride % 4 != 0) || bytes.size() % what.stride != 0) {
      view["byteOffset"] = append(made.buffer, bytes);
      continue;
    }
    const std::size_t count = bytes.size() / what.stride;
    GltfJson extension{{"buffer", 0}};
    Bytes stream;
    if (what.indices) {
      stream = index_stream(bytes, what.stride, choice.triangles);
    } else {
      const auto filter = choice.filters.find(v);
      const Bytes rows = filter == choice.filters.end() ? bytes : filtered(bytes, count, what.stride, filter->second);
      stream = encoded(meshopt_encodeVertexBufferBound(count, what.stride), [&](unsigned char* to, std::size_t most) {
        return meshopt_encodeVertexBuffer(to, most, rows.data(), count, what.stride);
      });
      if (filter != choice.filters.end()) extension["filter"] = filter->second;
    }
    extension["byteOffset"] = append(made.buffer, stream);
    extension["byteLength"] = stream.size();
    extension["byteStride"] = what.stride;
    extension["count"] = count;
    extension["mode"] = !what.indices ? "ATTRIBUTES" : choice.triangles ? "TRIANGLES" : "INDICES";
    const bool beside = choice.plain == Plain::beside;
    view["buffer"] = beside ? 0 : 1;
    view["byteOffset"] = append(beside ? made.buffer : fallback, bytes);
    view["extensions"][choice.extension] = std::move(extension);
  }
  made.json["buffers"] = {{{"byteLength", made.buffer.size()}}};
  if (choice.plain != Plain::beside) {
    made.json["buffers"][1] = {{"byteLength", fallback.size()}};
    made.json["buffers"][1]["extensions"][choice.extension]["fallback"] = true;
  }
  if (choice.plain == Plain::data_uri) made.json["buffers"][1]["uri"] = base64_uri(fallback);
  made.json["extensionsUsed"].push_back(choice.extension);
  if (choice.plain == Plain::none) made.json["extensionsRequired"].push_back(choice.extension);
  return made;
}

GltfBuilder builder_of(std::span<const std::byte> glb) {
  GltfBuilder made;
  made.json = json_of(glb);
  std::uint32_t text;
  std::memcpy(&text, glb.data() + 12, 4);
  const auto bin = glb.subspan(28 + text);
  made.buffer.assign(bin.begin(), bin.end());
  return made;
}

}  // namespace foredraw::testing
