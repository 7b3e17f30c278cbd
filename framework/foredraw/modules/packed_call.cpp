#include <foredraw/modules/packed_call.h>

#include <foredraw/modules/blocks.h>

#include <cstring>
#include <vector>

namespace foredraw {

namespace {

/// Puts one thing behind the other; without a block it only counts.
class Packer {
 public:
  explicit Packer(std::byte* block) : block_(block) {}

  /// Where it stands.
  std::uint64_t put(const void* bytes, std::size_t count) {
    if (bytes == nullptr) return 0;
    constexpr std::size_t line = 64;
    const std::size_t place = (size_ + line - 1) / line * line;
    size_ = place + count;
    if (block_ != nullptr && count > 0) std::memcpy(block_ + place, bytes, count);
    return place;
  }
  std::uint64_t put(const char* text) { return text == nullptr ? 0 : put(text, std::strlen(text) + 1); }
  template <class Row>
  std::uint64_t put(const std::vector<Row>& rows) {
    return put(rows.empty() ? nullptr : rows.data(), rows.size() * sizeof(Row));
  }
  std::size_t size() const { return size_; }

 private:
  std::byte* block_;
  std::size_t size_ = sizeof(AskedCall);
};

std::size_t packed(const ForeignQuestion& question, std::byte* block) {
  const foredraw_draw& draw = question.draw;
  Packer packer(block);
  std::vector<AskedStream> streams;
  for (const foredraw_stream& stream : std::span(draw.streams, draw.stream_count)) {
    streams.push_back({packer.put(stream.semantic),
                       packer.put(stream.bytes, std::size_t{stream.stride} * draw.vertex_count), stream.stride,
                       stream.component, stream.components, stream.normalized});
  }
  std::vector<AskedOption> options;
  for (const foredraw_value& option : question.options) {
    options.push_back({option.integer, option.number, packer.put(option.text)});
  }
  const std::uint64_t name = packer.put(draw.name);
  const std::uint64_t indices = packer.put(draw.indices, 3 * draw.triangle_count * sizeof *draw.indices);
  const std::uint64_t positions =
      packer.put(draw.positions, std::size_t{3} * draw.vertex_count * sizeof *draw.positions);
  const std::uint64_t offsets =
      packer.put(draw.cluster_offsets, (std::size_t{draw.cluster_count} + 1) * sizeof *draw.cluster_offsets);
  const std::uint64_t stream_rows = packer.put(streams), option_rows = packer.put(options);
  if (block == nullptr) return packer.size();
  AskedCall& call = *reinterpret_cast<AskedCall*>(block);
  call.cancelled = 0;
  call.plugin = question.plugin;
  call.seed = question.seed;
  call.room = question.room;
  call.vertex_room = question.vertex_room;
  call.may_count = question.may_count ? 1 : 0;
  call.triangle_count = draw.triangle_count;
  call.vertex_count = draw.vertex_count;
  call.stream_count = draw.stream_count;
  call.cluster_count = draw.cluster_count;
  call.option_count = static_cast<std::uint32_t>(options.size());
  call.name = name, call.indices = indices, call.positions = positions;
  call.streams = stream_rows, call.cluster_offsets = offsets, call.options = option_rows;
  return packer.size();
}

}  // namespace

std::size_t packed_size(const ForeignQuestion& question) { return packed(question, nullptr); }

void pack(const ForeignQuestion& question, std::byte* block) { packed(question, block); }

}  // namespace foredraw
