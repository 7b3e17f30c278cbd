#include <foredraw/io/gltf/gate/private/decoded_views.h>

#include <foredraw/io/gltf/private/rows.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

std::size_t padded_to_4(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

}  // namespace

void DecodedViews::expect_vertices(std::size_t count, std::size_t element) {
  view_of(padded_to_4(element)).expected += count * padded_to_4(element);
}

Lies DecodedViews::add_vertices(Bytes elements, std::size_t element) {
  const std::size_t stride = padded_to_4(element), count = elements.size() / element;
  Lies lies;
  copy_rows(grow(stride, count * stride, lies), stride, elements.data(), element, element, count);
  return lies;
}

Lies DecodedViews::add_indices(Bytes indices) {
  Lies lies;
  std::ranges::copy(indices, grow(0, padded_to_4(indices.size()), lies));
  return lies;
}

std::uint64_t DecodedViews::put(Document& document, std::size_t buffer) && {
  std::uint64_t bytes = 0;
  for (View& view : views_) {
    bytes += view.bytes.size();
    Json json = JsonObject{{"buffer", buffer}, {"byteLength", view.bytes.size()}};
    if (view.stride != 0) json["byteStride"] = view.stride;
    json["target"] = view.stride != 0 ? 34962 : 34963;
    document.json["bufferViews"].push_back(std::move(json));
    document.kept.push_back(std::move(view.bytes));
    const Bytes kept = document.kept.back();
    document.views.push_back({buffer, 0, kept.size(), view.stride, kept, std::nullopt});
  }
  return bytes;
}

DecodedViews::View& DecodedViews::view_of(std::size_t stride) {
  const auto found = std::ranges::find(views_, stride, &View::stride);
  return found != views_.end() ? *found : views_.emplace_back(View{stride, 0, {}});
}

std::byte* DecodedViews::grow(std::size_t stride, std::size_t bytes, Lies& lies) {
  View& view = view_of(stride);
  lies = {first_ + static_cast<std::size_t>(&view - views_.data()), view.bytes.size()};
  view.bytes.reserve(view.expected);
  view.bytes.resize(lies.offset + bytes);
  return view.bytes.data() + lies.offset;
}

}  // namespace foredraw::gltf
