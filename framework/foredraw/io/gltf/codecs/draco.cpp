// Buffers of the Draco codec to plain arrays, by libdraco's decoder. It believes most of what a buffer claims; what it
// would allocate or loop over is bounded here, in decoders derived from its own.
#include <foredraw/io/gltf/codecs/private/draco.h>
#include <foredraw/io/gltf/codecs/private/draco_attributes.h>

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>
#include <set>
#include <utility>

namespace foredraw::gltf {

namespace {

/// Leaves libdraco's decoder, whose own answer to what is wrong is just false.
struct Refused {
  DracoFault fault;
};

[[noreturn]] void refuse(const char* code, std::string message) { throw Refused{{code, std::move(message)}}; }

Refused damaged() { return {{"compressed-data", "the Draco buffer is damaged"}}; }

/// What a buffer says before its triangles.
struct Header {
  std::uint32_t triangles = 0;
  std::uint8_t seams = 0;  ///< attributes that have seams of their own
};

template <class Decoder>
std::optional<Header> header_of(draco::DecoderBuffer buffer) {
  Header header;
  if constexpr (std::is_same_v<Decoder, draco::MeshSequentialDecoder>) {
    if (DecodeVarint(&header.triangles, &buffer)) return header;
  } else {
    std::uint32_t points = 0;  // three for each triangle at most, as libdraco sees to
    const bool counts = DecodeVarint(&points, &buffer) && DecodeVarint(&header.triangles, &buffer);
    if (counts && buffer.Decode(&header.seams)) return header;
  }
  return std::nullopt;
}

Component component_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8: return Component::int8;
    case draco::DT_UINT8:
    case draco::DT_BOOL: return Component::uint8;
    case draco::DT_INT16: return Component::int16;
    case draco::DT_UINT16: return Component::uint16;
    case draco::DT_UINT32: return Component::uint32;
    case draco::DT_FLOAT32: return Component::float32;
    default: break;
  }
  refuse("compressed-attribute", "the Draco buffer holds components of a type that glTF does not have");
}

const char* name_of(Component component) {
  switch (component) {
    case Component::int8: return "signed 8-bit integers";
    case Component::uint8: return "unsigned 8-bit integers";
    case Component::int16: return "signed 16-bit integers";
    case Component::uint16: return "unsigned 16-bit integers";
    case Component::uint32: return "unsigned 32-bit integers";
    case Component::float32: break;
  }
  return "floats";
}

void check_attribute(const draco::PointCloud& cloud, const DracoClaim::Attribute& claim) {
  const draco::PointAttribute* found = cloud.GetAttributeByUniqueId(claim.id);
  if (found == nullptr) refuse("compressed-attribute", fmt::format("the Draco buffer has no attribute {}", claim.id));
  const Component component = component_of(found->data_type());
  const bool same = found->num_components() == claim.format.components && component == claim.format.component;
  if (same && found->byte_stride() == claim.format.bytes) return;  // columns of matrices have gaps in glTF
  refuse("compressed-attribute",
         fmt::format("attribute {} of the Draco buffer has elements of {} {}, but the accessor has {} {}", claim.id,
                     found->num_components(), name_of(component), claim.format.components,
                     name_of(claim.format.component)));
}

/// One of libdraco's two decoders of meshes, which stops before it takes more than the claim allows.
template <class Decoder>
class Bounded final : public Decoder {
 public:
  explicit Bounded(const DracoClaim& claim) : claim_(claim) {}

  bool has_rounded(std::int32_t attribute) const { return rounded_.contains(attribute); }

 protected:
  bool DecodeConnectivity() override {
    const auto header = header_of<Decoder>(*this->buffer());
    if (!header) return false;
    // Tables of corners, and such of each attribute with seams.
    spend(std::uint64_t{header->triangles} * (128 + 48 * header->seams));
    return Decoder::DecodeConnectivity();
  }

  bool CreateAttributesDecoder(std::int32_t number) override {
    if (!Decoder::CreateAttributesDecoder(number)) return false;
    // libdraco hands it out as const; it is this decoder's own.
    auto* made = const_cast<draco::AttributesDecoderInterface*>(this->attributes_decoder(number));
    return this->SetAttributesDecoder(number, bounded_attributes(*made, rounded_));
  }

  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    for (const DracoClaim::Attribute& attribute : claim_.attributes) check_attribute(cloud, attribute);
    for (std::int32_t i = 0; i < cloud.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *cloud.attribute(i);
      // Its values, these as integers, and which point has which.
      spend(std::uint64_t{cloud.num_points()} *
            (static_cast<std::uint64_t>(attribute.byte_stride()) + 4u * attribute.num_components() + 8u));
    }
    return Decoder::DecodeAllAttributes();
  }

 private:
  void spend(std::uint64_t bytes) {
    spent_ += bytes;
    if (spent_ <= 16 * claim_.bytes() + (std::uint64_t{64} << 10)) return;
    refuse("compressed-count",
           fmt::format(
               "the accessors claim {} vertices and {} triangles, but the Draco buffer says that it holds far more",
               claim_.points, claim_.triangles));
  }

  const DracoClaim& claim_;
  std::uint64_t spent_ = 0;
  std::set<std::int32_t> rounded_;
};

std::vector<std::uint32_t> indices_of(const draco::Mesh& mesh) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * static_cast<std::size_t>(mesh.num_faces()));
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f) {
    for (const draco::PointIndex& corner : mesh.face(f)) indices.push_back(corner.value());
  }
  if (!indices.empty() && *std::max_element(indices.begin(), indices.end()) >= mesh.num_points()) throw damaged();
  return indices;
}

std::vector<std::byte> elements_of(const draco::PointAttribute& attribute, std::size_t points) {
  const auto bytes = static_cast<std::size_t>(attribute.byte_stride());
  const auto* values = reinterpret_cast<const std::byte*>(attribute.buffer()->data());
  if (attribute.buffer()->data_size() < attribute.size() * bytes) throw damaged();
  std::vector<std::byte> elements(points * bytes);
  for (std::size_t i = 0; i < points; ++i) {
    const std::size_t value = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i))).value();
    if (value >= attribute.size()) throw damaged();
    std::memcpy(elements.data() + i * bytes, values + value * bytes, bytes);
  }
  return elements;
}

template <class Decoder>
DracoMesh decode(draco::DecoderBuffer& buffer, const DracoClaim& claim) {
  draco::Mesh mesh;
  Bounded<Decoder> decoder(claim);
  if (!decoder.Decode(draco::DecoderOptions(), &buffer, &mesh).ok()) throw damaged();
  DracoMesh result{mesh.num_points(), indices_of(mesh), {}};
  if (result.points == 0 || result.indices.empty()) refuse("compressed-count", "the Draco buffer holds no triangles");
  std::vector<bool> rounded;
  for (const DracoClaim::Attribute& attribute : claim.attributes) {
    result.attributes.push_back(elements_of(*mesh.GetAttributeByUniqueId(attribute.id), result.points));
    rounded.push_back(decoder.has_rounded(mesh.GetAttributeIdByUniqueId(attribute.id)));
  }
  undo_rounding(claim, rounded, result);
  return result;
}

DracoMesh decode(std::span<const std::byte> bytes, const DracoClaim& claim) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DecoderBuffer ahead = buffer;
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok())
    refuse("compressed-data", "the buffer view does not hold a Draco buffer, which begins with the letters DRACO");
  if (header.version_major != 2 || header.version_minor != 2) {
    refuse("unsupported-extension", fmt::format("the Draco buffer is of bitstream version {}.{}; expected 2.2",
                                                header.version_major, header.version_minor));
  }
  if (header.encoder_type != draco::TRIANGULAR_MESH)
    refuse("compressed-data", "the Draco buffer holds points; expected triangles");
  switch (header.encoder_method) {
    case draco::MESH_SEQUENTIAL_ENCODING: return decode<draco::MeshSequentialDecoder>(buffer, claim);
    case draco::MESH_EDGEBREAKER_ENCODING: return decode<draco::MeshEdgebreakerDecoder>(buffer, claim);
    default: throw damaged();
  }
}

}  // namespace

std::uint64_t DracoClaim::bytes() const {
  std::uint64_t element = 0;
  for (const Attribute& attribute : attributes) element += attribute.format.bytes;
  return points * element + 12 * static_cast<std::uint64_t>(triangles);
}

std::variant<DracoMesh, DracoFault> draco_decoded(std::span<const std::byte> buffer, const DracoClaim& claim) {
  try {
    return decode(buffer, claim);
  } catch (const Refused& refused) {
    return refused.fault;
  } catch (const std::bad_alloc&) {
    throw;  // what was asked for is within bounds, so it was memory that lacked
  } catch (const std::exception&) {
    return damaged().fault;
  }
}

}  // namespace foredraw::gltf
