// Plain arrays to buffers of the Draco codec, by libdraco's encoder. It is asked for nothing that rounds, and what it
// makes is decoded and compared before anybody sees it.
#include <foredraw/io/gltf/codecs/private/draco_encode.h>

#include <draco/compression/expert_encode.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace foredraw::gltf {

namespace {

constexpr int slowest = 0;                    // and shortest
constexpr std::size_t before_triangles = 21;  // bytes: Draco's header, and two counts at their longest

/// How an attribute is held.
struct Form {
  bool out = false;               ///< not at all
  std::optional<DracoGrid> grid;  ///< of floats; none: they stay bits
};

draco::DataType type_of(Component component) {
  switch (component) {
    case Component::int8: return draco::DT_INT8;
    case Component::uint8: return draco::DT_UINT8;
    case Component::int16: return draco::DT_INT16;
    case Component::uint16: return draco::DT_UINT16;
    case Component::uint32: return draco::DT_UINT32;
    case Component::float32: break;
  }
  return draco::DT_FLOAT32;
}

/// Normals are called something else: libdraco would round them to points of an octahedron, even where they are
/// integers.
draco::GeometryAttribute::Type kind_of(const std::string& semantic) {
  if (semantic == "POSITION") return draco::GeometryAttribute::POSITION;
  if (semantic.starts_with("TEXCOORD_")) return draco::GeometryAttribute::TEX_COORD;
  if (semantic.starts_with("COLOR_")) return draco::GeometryAttribute::COLOR;
  return draco::GeometryAttribute::GENERIC;
}

template <class T>
std::vector<T> values_of(std::span<const std::byte> bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

Form form_of(const DracoInput::Attribute& attribute) {
  const Format& format = attribute.format;
  const auto width = static_cast<std::size_t>(bytes_of(format.component));
  if (format.bytes != format.components * width) return {.out = true};  // columns of matrices have gaps in glTF
  if (format.component == Component::float32)
    return {.grid = draco_grid(values_of<float>(attribute.bytes), format.components)};
  if (format.component != Component::uint32) return {};
  // libdraco takes differences of signed ones, and counts how often each of them comes, in memory for all that may.
  constexpr std::uint32_t most = std::numeric_limits<std::int32_t>::max(), most_apart = std::uint32_t{1} << 22;
  const std::vector<std::uint32_t> values = values_of<std::uint32_t>(attribute.bytes);
  const auto [least, greatest] = std::ranges::minmax(values);
  return {.out = greatest > most || greatest - least > most_apart};
}

int add_attribute(const DracoInput::Attribute& attribute, draco::Mesh& mesh) {
  const Format& format = attribute.format;
  draco::GeometryAttribute made;
  made.Init(kind_of(attribute.semantic), nullptr, static_cast<std::uint8_t>(format.components),
            type_of(format.component), format.normalized, format.bytes, 0);
  const int id = mesh.AddAttribute(made, true, mesh.num_points());
  mesh.attribute(id)->buffer()->Write(0, attribute.bytes.data(), attribute.bytes.size());
  return id;
}

void add_faces(std::span<const std::uint32_t> indices, draco::Mesh& mesh) {
  mesh.SetNumFaces(indices.size() / 3);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    mesh.SetFace(draco::FaceIndex(static_cast<std::uint32_t>(i / 3)),
                 {draco::PointIndex(indices[i]), draco::PointIndex(indices[i + 1]), draco::PointIndex(indices[i + 2])});
  }
}

/// libdraco passes options on as text, and its own functions write six decimals, which moves an origin.
draco::Options options_for(const DracoGrid& grid) {
  const double range = double{grid.step} * ((1 << grid.bits) - 1);
  draco::Options options;
  options.SetInt("quantization_bits", grid.bits);
  options.SetString("quantization_origin", fmt::format("{:.17g}", fmt::join(grid.origin, " ")));
  options.SetString("quantization_range", fmt::format("{:.17g}", range));
  return options;
}

/// Encoded and decoded again. Nothing where either fails.
std::optional<DracoCoded> coded_as(const DracoInput& input, const std::vector<Form>& forms, bool reorders) {
  draco::Mesh mesh;
  mesh.set_num_points(static_cast<std::uint32_t>(input.points));
  DracoCoded made;
  DracoClaim claim;
  std::vector<int> numbers(forms.size(), -1);
  for (std::size_t a = 0; a < forms.size(); ++a) {
    made.ids.emplace_back();
    if (forms[a].out) continue;
    const DracoInput::Attribute& attribute = input.attributes[a];
    numbers[a] = add_attribute(attribute, mesh);
    made.ids[a] = mesh.attribute(numbers[a])->unique_id();
    claim.attributes.push_back({*made.ids[a], attribute.format, attribute.semantic});
    made.loose += attribute.format.component == Component::float32 && !forms[a].grid ? 1 : 0;
  }
  add_faces(input.indices, mesh);
  if (reorders && !mesh.DeduplicateAttributeValues()) return std::nullopt;
  if (reorders) mesh.DeduplicatePointIds();
  draco::ExpertEncoder encoder(mesh);
  encoder.SetSpeedOptions(slowest, slowest);
  encoder.SetTrackEncodedProperties(true);
  encoder.SetEncodingMethod(reorders ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
  encoder.options().SetGlobalBool("compress_connectivity", true);
  for (std::size_t a = 0; a < forms.size(); ++a) {
    if (!forms[a].grid) continue;
    encoder.options().SetAttributeOptions(numbers[a], options_for(*forms[a].grid));
  }
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeToBuffer(&buffer).ok()) return std::nullopt;
  const auto* begin = reinterpret_cast<const std::byte*>(buffer.data());
  made.bytes.assign(begin, begin + buffer.size());
  // Decoders of the sequential method refuse a buffer that has fewer bytes than indices behind its counts.
  if (!reorders) made.bytes.resize(std::max(made.bytes.size(), input.indices.size() + before_triangles));
  claim.points = encoder.num_encoded_points();
  claim.triangles = encoder.num_encoded_faces();
  auto decoded = draco_decoded(made.bytes, claim);
  if (std::holds_alternative<DracoFault>(decoded)) return std::nullopt;
  made.decoded = std::get<DracoMesh>(std::move(decoded));
  made.keeps_order = !reorders;
  return made;
}

/// Attributes that did not come back are held another way. False where all came back.
bool give_way(const DracoInput& input, const DracoCoded& coded, std::vector<Form>& forms) {
  bool any = false;
  std::size_t decoded = 0;
  for (std::size_t a = 0; a < forms.size(); ++a) {
    if (forms[a].out || std::ranges::equal(input.attributes[a].bytes, coded.decoded.attributes[decoded++])) continue;
    any = true;
    forms[a].out = !forms[a].grid;
    forms[a].grid.reset();
  }
  return any;
}

std::optional<DracoCoded> coded_in_order(const DracoInput& input, std::vector<Form>& forms) {
  while (std::ranges::any_of(forms, [](const Form& form) { return !form.out; })) {
    auto coded = coded_as(input, forms, false);
    if (!coded || coded->decoded.points != input.points || !std::ranges::equal(coded->decoded.indices, input.indices))
      return std::nullopt;
    if (!give_way(input, *coded, forms)) return coded;
  }
  return std::nullopt;
}

}  // namespace

std::optional<DracoCoded> draco_encoded(const DracoInput& input, bool may_reorder) {
  std::vector<Form> forms;
  for (const DracoInput::Attribute& attribute : input.attributes) forms.push_back(form_of(attribute));
  auto coded = coded_in_order(input, forms);
  if (!coded) return std::nullopt;
  const bool whole = std::ranges::none_of(forms, &Form::out);
  for (std::size_t a = 0; a < forms.size(); ++a) {
    if (input.attributes[a].semantic == "POSITION" && forms[a].out) return std::nullopt;
  }
  if (!may_reorder || !whole) return coded;
  auto free = coded_as(input, forms, true);
  return free && free->bytes.size() < coded->bytes.size() && same_triangles(input, free->decoded) ? free : coded;
}

}  // namespace foredraw::gltf
