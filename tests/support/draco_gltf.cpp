#include "support/draco_gltf.h"

#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>

#include <cstring>
#include <stdexcept>

namespace foredraw::testing {

namespace {

using Bytes = std::vector<std::byte>;

std::size_t width_of(int component) { return component <= 5121 ? 1 : component <= 5123 ? 2 : 4; }

int components_of(const GltfJson& accessor) {
  const std::string type = accessor["type"];
  return type == "SCALAR" ? 1 : type[3] - '0';
}

draco::DataType type_of(int component) {
  static const std::map<int, draco::DataType> types{{5120, draco::DT_INT8},   {5121, draco::DT_UINT8},
                                                    {5122, draco::DT_INT16},  {5123, draco::DT_UINT16},
                                                    {5125, draco::DT_UINT32}, {5126, draco::DT_FLOAT32}};
  return types.at(component);
}

draco::GeometryAttribute::Type kind_of(const std::string& semantic) {
  if (semantic == "POSITION") return draco::GeometryAttribute::POSITION;
  if (semantic == "NORMAL") return draco::GeometryAttribute::NORMAL;
  if (semantic.starts_with("TEXCOORD_")) return draco::GeometryAttribute::TEX_COORD;
  if (semantic.starts_with("COLOR_")) return draco::GeometryAttribute::COLOR;
  return draco::GeometryAttribute::GENERIC;
}

Bytes elements_of(const GltfBuilder& builder, std::size_t number) {
  const GltfJson& accessor = builder.json["accessors"][number];
  const GltfJson& view = builder.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const std::size_t element = width_of(accessor["componentType"]) * static_cast<std::size_t>(components_of(accessor));
  const std::size_t stride = view.value("byteStride", element), count = accessor["count"];
  const std::size_t from = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
  Bytes elements;
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = builder.buffer.begin() + static_cast<std::ptrdiff_t>(from + i * stride);
    elements.insert(elements.end(), begin, begin + static_cast<std::ptrdiff_t>(element));
  }
  return elements;
}

void add_faces(const GltfBuilder& builder, std::size_t number, draco::Mesh& mesh) {
  const Bytes bytes = elements_of(builder, number);
  const std::size_t width = width_of(builder.json["accessors"][number]["componentType"]);
  std::vector<std::uint32_t> indices(bytes.size() / width, 0);
  for (std::size_t i = 0; i < indices.size(); ++i) std::memcpy(&indices[i], bytes.data() + i * width, width);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    mesh.AddFace({draco::PointIndex(indices[i]), draco::PointIndex(indices[i + 1]), draco::PointIndex(indices[i + 2])});
  }
}

int add_attribute(const GltfBuilder& builder, const std::string& semantic, std::size_t number, draco::Mesh& mesh) {
  const GltfJson& accessor = builder.json["accessors"][number];
  const Bytes elements = elements_of(builder, number);
  const int component = accessor["componentType"], components = components_of(accessor);
  const std::size_t element = width_of(component) * static_cast<std::size_t>(components);
  const auto count = static_cast<std::uint32_t>(elements.size() / element);
  draco::GeometryAttribute attribute;
  attribute.Init(kind_of(semantic), nullptr, static_cast<std::int8_t>(components), type_of(component),
                 accessor.value("normalized", false), static_cast<std::int64_t>(element), 0);
  mesh.set_num_points(count);
  const int id = mesh.AddAttribute(attribute, true, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), elements.data() + i * element);
  }
  return id;
}

struct Encoded {
  Bytes bytes;
  GltfJson ids;
  std::size_t points = 0, faces = 0;
};

Encoded encoded(const GltfBuilder& builder, const GltfJson& primitive, const DracoChoice& choice) {
  draco::Mesh mesh;
  std::map<std::string, int> attributes;
  for (const auto& [semantic, number] : primitive["attributes"].items()) {
    attributes[semantic] = add_attribute(builder, semantic, number, mesh);
  }
  add_faces(builder, primitive["indices"], mesh);
  draco::ExpertEncoder encoder(mesh);
  encoder.SetSpeedOptions(choice.speed, choice.speed);
  encoder.SetTrackEncodedProperties(true);
  encoder.SetEncodingMethod(choice.sequential ? draco::MESH_SEQUENTIAL_ENCODING : draco::MESH_EDGEBREAKER_ENCODING);
  Encoded made;
  for (const auto& [semantic, id] : attributes) {
    if (choice.bits > 0) encoder.SetAttributeQuantization(id, choice.bits);
    made.ids[semantic] = mesh.attribute(id)->unique_id();
  }
  draco::EncoderBuffer buffer;
  const draco::Status status = encoder.EncodeToBuffer(&buffer);
  if (!status.ok()) throw std::runtime_error(status.error_msg_string());
  const auto* begin = reinterpret_cast<const std::byte*>(buffer.data());
  made.bytes.assign(begin, begin + buffer.size());
  made.points = encoder.num_encoded_points();
  made.faces = encoder.num_encoded_faces();
  return made;
}

template <class Visit>
void each_view_holder(GltfJson& value, Visit visit) {
  if (value.is_object() && value.contains("bufferView")) visit(value);
  if (!value.is_structured()) return;
  for (auto& part : value) each_view_holder(part, visit);
}

/// Views that nobody names fall away, and the others are renumbered.
GltfBuilder without_unused_views(const GltfBuilder& from) {
  GltfBuilder packed;
  packed.json = from.json;
  packed.json.erase("bufferViews");
  std::map<std::size_t, std::size_t> numbers;
  each_view_holder(packed.json, [&](GltfJson& holder) { numbers[holder["bufferView"]] = 0; });
  GltfBuilder views;
  for (auto& [old, number] : numbers) {
    number = views.add_view(view_bytes(from, old), from.json["bufferViews"][old].value("byteStride", std::size_t{0}));
  }
  each_view_holder(packed.json, [&](GltfJson& holder) { holder["bufferView"] = numbers.at(holder["bufferView"]); });
  packed.json["bufferViews"] = views.json["bufferViews"];
  packed.buffer = views.buffer;
  return packed;
}

}  // namespace

std::span<const std::byte> view_bytes(const GltfBuilder& builder, std::size_t view) {
  const GltfJson& json = builder.json["bufferViews"][view];
  return std::span(builder.buffer)
      .subspan(json.value("byteOffset", std::size_t{0}), json["byteLength"].get<std::size_t>());
}

GltfBuilder draco_compressed(const GltfBuilder& plain, const DracoChoice& choice) {
  GltfBuilder made = plain;
  const char* name = "KHR_draco_mesh_compression";
  for (GltfJson& mesh : made.json["meshes"]) {
    for (GltfJson& primitive : mesh["primitives"]) {
      const Encoded coded = encoded(plain, primitive, choice);
      primitive["extensions"][name] = {{"bufferView", made.add_view(coded.bytes)}, {"attributes", coded.ids}};
      const auto now_holds = [&](const GltfJson& number, std::size_t count) {
        GltfJson& accessor = made.json["accessors"][number.get<std::size_t>()];
        if (!choice.counted_before) accessor["count"] = count;
        if (choice.plain_copy) return;
        accessor.erase("bufferView");
        accessor.erase("byteOffset");
      };
      for (const GltfJson& number : primitive["attributes"]) now_holds(number, coded.points);
      now_holds(primitive["indices"], 3 * coded.faces);
    }
  }
  made.json["extensionsUsed"].push_back(name);
  if (!choice.plain_copy) made.json["extensionsRequired"].push_back(name);
  return without_unused_views(made);
}

DracoDecoded decoded_by_draco(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return {};
  const draco::Mesh& mesh = *decoded.value();
  DracoDecoded result;
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f) {
    for (const draco::PointIndex& corner : mesh.face(f)) result.indices.push_back(corner.value());
  }
  for (int a = 0; a < mesh.num_attributes(); ++a) {
    const draco::PointAttribute& attribute = *mesh.attribute(a);
    const auto element = static_cast<std::size_t>(attribute.byte_stride());
    Bytes& values = result.attributes[attribute.unique_id()];
    values.resize(mesh.num_points() * element);
    for (draco::PointIndex i(0); i < mesh.num_points(); ++i) {
      attribute.GetMappedValue(i, values.data() + i.value() * element);
    }
  }
  return result;
}

}  // namespace foredraw::testing
