// Elements to streams of the vertex codec. Nothing is estimated: channels do not touch each other, so every mode of a
// channel is measured over the whole stream, and the shortest is taken.
#include <foredraw/io/meshopt/private/channels.h>

#include <cstring>
#include <limits>

namespace foredraw::meshopt {

namespace {

struct Elements {
  const Byte* bytes;
  std::size_t count;
  std::size_t stride;

  std::size_t in_block(std::size_t first) const { return std::min(elements_in_block(stride), count - first); }

  /// One word of each element; the first one before them all too, and the last one again and again for whole groups.
  void channel(std::size_t c, std::vector<std::uint32_t>& words) const {
    words.resize(1 + rounded_up(count, group_size));
    const Byte* from = bytes + c * channel_bytes;
    std::memcpy(words.data(), from, channel_bytes);
    for (std::size_t i = 0; i < count; ++i) std::memcpy(&words[i + 1], from + i * stride, channel_bytes);
    std::fill(words.begin() + 1 + static_cast<std::ptrdiff_t>(count), words.end(), words[count]);
  }
};

/// A byte of the tail. Turning by 8 bits more only has the planes change places.
constexpr std::array<Byte, 10> modes{0, 1, 0x02, 0x12, 0x22, 0x32, 0x42, 0x52, 0x62, 0x72};

Byte best_mode(const Elements& elements, const std::vector<std::uint32_t>& words) {
  Byte best = 0;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Byte mode : modes) {
    std::size_t bytes = 0;
    for (std::size_t first = 0; first < elements.count && bytes < least; first += elements_in_block(elements.stride)) {
      bytes += cost_of_channel(&words[first], elements.in_block(first), mode);
    }
    if (bytes < least) best = mode;
    least = std::min(least, bytes);
  }
  return best;
}

/// More than any stream of so many elements takes, by what is overwritten while it is made.
std::size_t most_bytes(const Elements& elements) {
  const std::size_t blocks =
      rounded_up(elements.count, elements_in_block(elements.stride)) / elements_in_block(elements.stride);
  return 1 + blocks * elements.stride * (1 + header_bytes(most_in_block)) +
         rounded_up(elements.count, group_size) * elements.stride + 512;
}

}  // namespace

std::vector<std::byte> encode_vertices(std::span<const std::byte> bytes, std::size_t stride, VertexVersion version) {
  const Elements elements{reinterpret_cast<const Byte*>(bytes.data()), bytes.size() / stride, stride};
  const std::size_t channels = stride / channel_bytes;
  std::array<Byte, 64> mode{};
  std::vector<std::vector<std::uint32_t>> words(elements.count == 0 ? 0 : channels);
  for (std::size_t c = 0; c < words.size(); ++c) {
    elements.channel(c, words[c]);
    if (version == VertexVersion::v1) mode[c] = best_mode(elements, words[c]);
  }
  std::vector<std::byte> stream(most_bytes(elements));
  auto* const begin = reinterpret_cast<Byte*>(stream.data());
  Byte* to = begin;
  *to++ = static_cast<Byte>(codec_byte + (version == VertexVersion::v0 ? 0 : 1));
  for (std::size_t first = 0; first < elements.count; first += elements_in_block(stride)) {
    const std::size_t count = elements.in_block(first);
    Byte* controls = to;
    if (version == VertexVersion::v1) to = std::fill_n(to, channels, Byte{0});
    for (std::size_t c = 0; c < channels; ++c) {
      to = put_channel(&words[c][first], count, mode[c], version, controls + c, to);
    }
  }
  to = std::fill_n(to, padded_tail_bytes(stride, version) - tail_bytes(stride, version), Byte{0});
  to = elements.count == 0 ? std::fill_n(to, stride, Byte{0}) : std::copy_n(elements.bytes, stride, to);
  if (version == VertexVersion::v1) to = std::copy_n(mode.begin(), channels, to);
  stream.resize(static_cast<std::size_t>(to - begin));
  return stream;
}

}  // namespace foredraw::meshopt
