// Which accessors have rows in common.
#include <foredraw/io/gltf/codecs/private/draco_primitives.h>

#include <algorithm>
#include <tuple>

namespace foredraw::gltf {

SharedRows::SharedRows(const Json& json) : groups_(json.value("accessors", Json::array()).size()) {
  /// Rows of an accessor: where in each stride of which view they begin, and which they are.
  struct Span {
    std::tuple<std::size_t, std::size_t, std::size_t, std::size_t> column;  // view, stride, place in it, bytes
    std::size_t first = 0, end = 0, accessor = 0;
  };
  std::vector<Span> spans;
  for (std::size_t a = 0; a < groups_.size(); ++a) {
    const Json& accessor = json["accessors"][a];
    if (!accessor.contains("bufferView") || accessor.contains("sparse")) continue;
    const auto v = accessor["bufferView"].get<std::size_t>();
    const Json& view = json["bufferViews"][v];
    const auto format =
        format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(), false);
    if (!format || view["buffer"] != 0 || view.contains("extensions")) continue;
    const std::size_t stride = view.value("byteStride", std::size_t{format->bytes});
    const auto offset = accessor.value("byteOffset", std::size_t{0});
    spans.push_back({{v, stride, offset % stride, format->bytes},
                     offset / stride,
                     offset / stride + accessor["count"].get<std::size_t>(),
                     a});
  }
  std::ranges::sort(spans, [](const Span& a, const Span& b) {
    return std::tie(a.column, a.first, a.end, a.accessor) < std::tie(b.column, b.first, b.end, b.accessor);
  });
  std::size_t end = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Span& span = spans[i];
    const bool joins = i > 0 && spans[i - 1].column == span.column && span.first < end;
    if (!joins) bytes_.push_back(0);
    const std::size_t known = joins ? end : span.first;
    end = joins ? std::max(end, span.end) : span.end;
    bytes_.back() += (end - known) * std::get<3>(span.column);
    groups_[span.accessor] = bytes_.size() - 1;
  }
}

}  // namespace foredraw::gltf
