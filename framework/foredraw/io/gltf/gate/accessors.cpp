// Checks of accessors: that every element claimed lies in the bytes that there are.
#include <foredraw/io/gltf/gate/private/gate.h>

#include <fmt/format.h>

#include <set>
#include <tuple>

namespace foredraw::gltf {

namespace {

/// Accessors without bytes claim zeros; a few letters of JSON must not claim all memory.
constexpr std::uint64_t most_zeros = std::uint64_t{256} << 20;

struct Claim {
  std::uint64_t count = 0;
  std::size_t element = 0;    ///< bytes
  std::size_t component = 0;  ///< bytes
};

/// Where `count` elements lie in a buffer view, if they do.
std::optional<Rows> rows_in_view(Gate& gate, const Json& json, const Claim& claim, bool may_stride,
                                 const std::string& place) {
  const auto number = gate.reference(json, "bufferView", "bufferViews", place);
  const auto offset = gate.whole(json, "byteOffset", place);
  if (!number || (!offset && json.contains("byteOffset")) || gate.view(number) == nullptr) return std::nullopt;
  const BufferView& view = *gate.view(number);
  if (!may_stride && view.stride != 0) {
    gate.error(in(place, "bufferView"), "view-stride",
               "sparse elements must be tightly packed, but the view has a byteStride");
    return std::nullopt;
  }
  const std::size_t stride = view.stride == 0 ? claim.element : view.stride;
  const std::uint64_t from = offset.value_or(0);
  if (stride < claim.element) {
    gate.error(in(place, "bufferView"), "view-stride",
               fmt::format("the view's byteStride {} is less than the {} bytes of an element", stride, claim.element));
    return std::nullopt;
  }
  if (from % claim.component != 0 || (view.offset + from) % claim.component != 0 || stride % claim.component != 0) {
    gate.fault(
        "alignment", in(place, "byteOffset"),
        fmt::format("elements at byte {} of the buffer, every {} bytes, are not aligned to their {}-byte components",
                    view.offset + from, stride, claim.component));
  }
  const bool first_fits = from <= view.length && claim.element <= view.length - from;
  if (!first_fits || (view.length - from - claim.element) / stride < claim.count - 1) {
    gate.error(in(place, "count"), "accessor-range",
               fmt::format("{} elements, one every {} bytes from byte {}, do not fit in buffer view {} of {} bytes",
                           claim.count, stride, from, *number, view.length));
    return std::nullopt;
  }
  return Rows{*number, static_cast<std::size_t>(from), stride};
}

void check_sparse_order(Gate& gate, const Accessor& accessor, const std::string& place) {
  const SparseElements& sparse = *accessor.sparse;
  const Format format{sparse.index, 1, false, static_cast<std::uint16_t>(bytes_of(sparse.index))};
  std::int64_t last = -1;
  std::size_t i = 0;
  for (std::uint32_t index : index_elements(gate.document(), {format, sparse.count, sparse.indices, std::nullopt})) {
    if (index >= accessor.count || index <= last) {
      gate.error(
          in(place, "sparse.indices"), "sparse-indices",
          fmt::format("index {} is {}, but indices must rise strictly and stay below {}", i, index, accessor.count));
      return;
    }
    last = index;
    ++i;
  }
}

std::optional<SparseElements> sparse_elements(Gate& gate, const Json& sparse, const Accessor& accessor,
                                              const std::string& place) {
  for (const char* key : {"count", "indices", "values"}) gate.required(sparse, key, place);
  const auto count = gate.whole(sparse, "count", place, 1, accessor.count);
  const Json* indices = gate.object(sparse, "indices", place);
  const Json* values = gate.object(sparse, "values", place);
  if (!count || indices == nullptr || values == nullptr) return std::nullopt;
  for (const char* key : {"bufferView", "componentType"}) gate.required(*indices, key, in(place, "indices"));
  gate.required(*values, "bufferView", in(place, "values"));
  const auto type = gate.whole(*indices, "componentType", in(place, "indices"));
  if (!type) return std::nullopt;
  const auto format = format_of("SCALAR", *type, false);
  if (!format || (*type != 5121 && *type != 5123 && *type != 5125)) {
    gate.error(in(place, "indices.componentType"), "accessor-type",
               fmt::format("is {}, but must be 5121, 5123 or 5125 (unsigned)", *type));
    return std::nullopt;
  }
  const auto where = rows_in_view(gate, *indices, {*count, format->bytes, format->bytes}, false, in(place, "indices"));
  const auto what = rows_in_view(gate, *values, {*count, accessor.format.bytes, bytes_of(accessor.format.component)},
                                 false, in(place, "values"));
  if (!where || !what) return std::nullopt;
  return SparseElements{static_cast<std::size_t>(*count), format->component, *where, *what};
}

std::optional<Accessor> accessor_of(Gate& gate, const Json& json, const std::string& place, std::uint64_t& zeros) {
  for (const char* key : {"componentType", "count", "type"}) gate.required(json, key, place);
  const auto component = gate.whole(json, "componentType", place);
  const auto type = gate.text(json, "type", place);
  const auto count = gate.whole(json, "count", place, 1);
  const bool normalized = gate.boolean(json, "normalized", place).value_or(false);
  if (!component || !type || !count) return std::nullopt;
  const auto format = format_of(*type, *component, normalized);
  if (!format) {
    gate.error(place, "accessor-type", fmt::format("glTF has no type '{}' of component type {}", *type, *component),
               "types are SCALAR, VEC2..4, MAT2..4; component types 5120 to 5123, 5125 and 5126");
    return std::nullopt;
  }
  for (const char* key : {"min", "max"}) {
    if (!json.contains(key)) continue;
    gate.leave_out_if_wrong("bounds", in(place, key), [&] { gate.numbers(json, key, place, format->components); });
  }
  if (*count > std::numeric_limits<std::uint32_t>::max()) {
    gate.error(in(place, "count"), "accessor-range",
               fmt::format("is {}, but a buffer view has at most 4294967295 bytes", *count));
    return std::nullopt;
  }
  Accessor accessor{*format, static_cast<std::size_t>(*count), std::nullopt, std::nullopt};
  if (json.contains("bufferView")) {
    accessor.rows = rows_in_view(gate, json, {*count, format->bytes, bytes_of(format->component)}, true, place);
    if (!accessor.rows) return std::nullopt;
  } else {
    if (zeros + *count * format->bytes > most_zeros) {
      gate.error(in(place, "count"), "accessor-range", "accessors without bytes claim more than 256 MiB of zeros");
      return std::nullopt;
    }
    zeros += *count * format->bytes;
  }
  if (const Json* sparse = gate.object(json, "sparse", place)) {
    accessor.sparse = sparse_elements(gate, *sparse, accessor, in(place, "sparse"));
    if (!accessor.sparse) return std::nullopt;
    check_sparse_order(gate, accessor, place);
  }
  return accessor;
}

}  // namespace

void check_accessors(Gate& gate) {
  const Json& accessors = gate.all("accessors");
  std::uint64_t zeros = 0;
  const std::uint64_t most = most_claimed(gate);
  std::uint64_t claimed = 0;
  std::set<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> known;  // the same bytes are kept once
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    gate.accessors.push_back(gate.only_if_used("accessors", i, [&] {
      std::optional<Accessor> made = accessor_of(gate, accessors[i], at("accessors", i), zeros);
      if (!made || !made->rows) return made;
      const std::tuple rows{made->rows->view, made->rows->offset, made->rows->stride, made->count};
      if (known.contains(rows) && !made->sparse) return made;
      if (made->bytes() > most - claimed) {
        gate.too_much(
            at("accessors", i), "overlap",
            fmt::format("the accessors up to this one claim {} bytes, because they overlap", claimed + made->bytes()),
            "share accessors between primitives instead");
        return std::optional<Accessor>();
      }
      claimed += made->bytes();
      known.insert(rows);
      return made;
    }));
  }
}

}  // namespace foredraw::gltf
