// Layout: "OpenEXR File Layout", openexr.com. Little-endian throughout.
#include <foredraw/io/image/private/exr.h>

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>

namespace foredraw::images {

namespace {

enum class Compression : std::uint8_t { none, rle, zips, zip, other };
enum class Sample : std::uint32_t { uint32, float16, float32 };

struct Channel {
  std::string name;
  Sample sample = Sample::float16;
};

struct Layout {
  std::vector<Channel> channels;  ///< in the file's sequence, which is the alphabet's
  std::uint8_t compression = 0;
  std::int32_t first_row = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::size_t end = 0;  ///< of the header: there the offsets begin
  std::string unsupported;

  std::size_t row_bytes() const {
    std::size_t bytes = 0;
    for (const Channel& channel : channels) bytes += std::size_t{width} * (channel.sample == Sample::float16 ? 2 : 4);
    return bytes;
  }
  std::uint32_t rows_in_chunk() const { return compression == static_cast<std::uint8_t>(Compression::zip) ? 16 : 1; }
  std::uint32_t chunks() const { return (height - 1) / rows_in_chunk() + 1; }
};

/// Reads on as long as there are bytes; once one is missing, everything is zero and `good` false.
class Reader {
 public:
  explicit Reader(Bytes bytes, std::size_t at = 0) : bytes_(bytes), at_(std::min(at, bytes.size())) {}

  template <class T>
  T value() {
    T result{};
    const Bytes from = take(sizeof(T));
    if (!from.empty()) std::memcpy(&result, from.data(), sizeof(T));
    return result;
  }

  std::string text() {
    std::string result;
    while (good && result.size() < 256) {
      const char c = value<char>();
      if (c == '\0') return result;
      result += c;
    }
    good = false;
    return {};
  }

  Bytes take(std::size_t count) {
    good = good && count <= bytes_.size() - at_;
    if (!good) return {};
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

  std::size_t at() const { return at_; }
  bool good = true;

 private:
  Bytes bytes_;
  std::size_t at_;
};

constexpr std::size_t most_channels = 64;

void read_channels(Bytes bytes, Layout& layout) {
  Reader reader(bytes);
  for (std::string name = reader.text(); reader.good && !name.empty(); name = reader.text()) {
    const auto sample = reader.value<std::uint32_t>();
    reader.value<std::uint32_t>();  // whether it is perceptually linear, and three bytes of nothing
    const auto across = reader.value<std::int32_t>(), down = reader.value<std::int32_t>();
    if (sample > 2) layout.unsupported = "its samples are of an unknown type";
    if (across != 1 || down != 1) layout.unsupported = "a channel is coarser than the image";
    if (layout.channels.size() == most_channels) layout.unsupported = "it has too many channels";
    if (!layout.unsupported.empty()) return;
    layout.channels.push_back({std::move(name), static_cast<Sample>(sample)});
  }
}

std::optional<Layout> layout_of(Bytes bytes) {
  Reader reader(bytes, 4);
  const auto version = reader.value<std::uint32_t>();
  Layout layout;
  if ((version & 0xff) != 2) return std::nullopt;
  if ((version & 0x200) != 0) layout.unsupported = "it is made of tiles";
  if ((version & 0x1800) != 0) layout.unsupported = "it is deep or has several parts";
  bool has_window = false, has_channels = false, has_compression = false;
  for (std::string name = reader.text(); reader.good && !name.empty(); name = reader.text()) {
    reader.text();  // the type, which these names have once for all
    const auto size = reader.value<std::uint32_t>();
    const Bytes value = reader.take(size);
    Reader inside(value);
    if (name == "channels") {
      read_channels(value, layout);
      has_channels = true;
    } else if (name == "compression") {
      layout.compression = inside.value<std::uint8_t>();
      has_compression = inside.good;
    } else if (name == "dataWindow") {
      const auto left = inside.value<std::int32_t>(), top = inside.value<std::int32_t>();
      const auto right = inside.value<std::int32_t>(), bottom = inside.value<std::int32_t>();
      if (!inside.good || right < left || bottom < top) return std::nullopt;
      layout.first_row = top;
      const std::int64_t width = std::int64_t{right} - left + 1, height = std::int64_t{bottom} - top + 1;
      if (width > 0x7fffffff || height > 0x7fffffff) return std::nullopt;
      layout.width = static_cast<std::uint32_t>(width);
      layout.height = static_cast<std::uint32_t>(height);
      has_window = true;
    }
  }
  if (!reader.good || !has_window || !has_channels || !has_compression) return std::nullopt;
  layout.end = reader.at();
  if (layout.channels.empty() && layout.unsupported.empty()) return std::nullopt;
  static constexpr const char* others[] = {"PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB"};
  if (layout.compression > 3 && layout.unsupported.empty()) {
    const std::size_t other = layout.compression - 4u;
    layout.unsupported = std::string("it is compressed by ") +
                         (other < std::size(others) ? others[other] : "an unknown method") +
                         "; save it with ZIP compression";
  }
  return layout;
}

/// Where each channel goes: red, green, blue, alpha, where these are the names; else as in the file.
std::vector<std::size_t> places_of(const std::vector<Channel>& channels) {
  std::vector<std::size_t> places(channels.size());
  std::vector<std::string> names = {"Y", "R", "G", "B", "A"};
  std::erase_if(names, [&](const std::string& name) {
    return std::none_of(channels.begin(), channels.end(), [&](const Channel& channel) { return channel.name == name; });
  });
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), channels[i].name);
    places[i] = names.size() == channels.size() ? static_cast<std::size_t>(found - names.begin()) : i;
  }
  return places;
}

float from_half(std::uint16_t half) {
  const std::uint32_t sign = (half & 0x8000u) << 16, exponent = half >> 10 & 31u, mantissa = half & 0x3ffu;
  if (exponent == 31) return std::bit_cast<float>(sign | 0x7f800000u | mantissa << 13);
  if (exponent != 0) return std::bit_cast<float>(sign | (exponent + 112) << 23 | mantissa << 13);
  const float small = static_cast<float>(mantissa) / 16777216.0f;  // 2^-24
  return sign != 0 ? -small : small;
}

bool undo_rle(Bytes from, std::span<std::byte> to) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < from.size();) {
    const int count = std::to_integer<std::int8_t>(from[i++]);
    const auto length = static_cast<std::size_t>(count < 0 ? -count : count + 1);
    if (length > to.size() - at || (count < 0 ? length : 1) > from.size() - i) return false;
    if (count < 0) {
      std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(i), length, to.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
      std::fill_n(to.begin() + static_cast<std::ptrdiff_t>(at), length, from[i]);
    }
    i += count < 0 ? length : 1;
    at += length;
  }
  return at == to.size();
}

bool undo_deflate(Bytes from, std::span<std::byte> to) {
  uLongf length = to.size();
  const int result = ::uncompress(reinterpret_cast<Bytef*>(to.data()), &length,
                                  reinterpret_cast<const Bytef*>(from.data()), static_cast<uLong>(from.size()));
  return result == Z_OK && length == to.size();
}

/// Before compression bytes were replaced by differences, and even ones parted from odd ones.
void undo_differences(std::span<std::byte> bytes, std::vector<std::byte>& spare) {
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::byte>(std::to_integer<int>(bytes[i - 1]) + std::to_integer<int>(bytes[i]) - 128);
  }
  spare.assign(bytes.begin(), bytes.end());
  const std::size_t half = (bytes.size() + 1) / 2;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = spare[i / 2 + (i % 2 == 0 ? 0 : half)];
}

bool decompress(Bytes from, std::span<std::byte> to, std::uint8_t compression, std::vector<std::byte>& spare) {
  if (from.size() == to.size()) {  // what would not get smaller was left as it is
    std::copy(from.begin(), from.end(), to.begin());
    return true;
  }
  if (compression == static_cast<std::uint8_t>(Compression::none)) return false;
  const bool is_rle = compression == static_cast<std::uint8_t>(Compression::rle);
  if (!(is_rle ? undo_rle(from, to) : undo_deflate(from, to))) return false;
  undo_differences(to, spare);
  return true;
}

/// A row: one channel after the other.
void put_row(Bytes row, const Layout& layout, const std::vector<std::size_t>& places, std::byte* to) {
  Reader reader(row);
  for (std::size_t c = 0; c < layout.channels.size(); ++c) {
    for (std::size_t x = 0; x < layout.width; ++x) {
      float value = 0;
      switch (layout.channels[c].sample) {
        case Sample::uint32: value = static_cast<float>(reader.value<std::uint32_t>()); break;
        case Sample::float16: value = from_half(reader.value<std::uint16_t>()); break;
        case Sample::float32: value = reader.value<float>(); break;
      }
      std::memcpy(to + (x * layout.channels.size() + places[c]) * sizeof(float), &value, sizeof(float));
    }
  }
}

}  // namespace

bool is_exr(Bytes bytes) {
  constexpr std::string_view magic = "\x76\x2f\x31\x01";
  return bytes.size() > 8 && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

std::optional<Header> exr_header(Bytes bytes) {
  const auto layout = layout_of(bytes);
  if (!layout) return std::nullopt;
  Header header{Kind::exr, {layout->width, layout->height, static_cast<int>(layout->channels.size()), 0, true}};
  std::size_t texel = 0;
  for (const Channel& channel : layout->channels) {
    const int bits = channel.sample == Sample::float16 ? 16 : 32;
    header.facts.bits = std::max(header.facts.bits, bits);
    texel += static_cast<std::size_t>(bits / 8);
  }
  const std::uint64_t best = layout->compression == 0 ? 1 : layout->compression == 1 ? 64 : 1032;
  header.most_texels = texel == 0 ? 0 : bytes.size() * best / texel;
  if (!layout->unsupported.empty()) header.most_texels = std::numeric_limits<std::uint64_t>::max();  // is told instead
  return header;
}

std::variant<std::vector<std::byte>, std::string> exr_texels(Bytes bytes) {
  const auto layout = layout_of(bytes);
  if (!layout) return "the header is damaged";
  if (!layout->unsupported.empty()) return layout->unsupported;
  Reader offsets(bytes, layout->end);
  if (layout->chunks() > (bytes.size() - layout->end) / 8) return "the table of offsets is cut off";
  const std::vector<std::size_t> places = places_of(layout->channels);
  const std::size_t row = layout->row_bytes(),
                    row_out = std::size_t{layout->width} * layout->channels.size() * sizeof(float);
  std::vector<std::byte> texels(row_out * layout->height), chunk, spare;
  for (std::uint32_t i = 0; i < layout->chunks(); ++i) {
    const std::string name = "chunk " + std::to_string(i);
    const auto offset = offsets.value<std::uint64_t>();
    if (offset > bytes.size()) return name + " lies past the end";
    Reader reader(bytes, offset);
    const std::int64_t first = std::int64_t{reader.value<std::int32_t>()} - layout->first_row;
    const Bytes packed = reader.take(reader.value<std::uint32_t>());
    if (!reader.good) return name + " is cut off";
    if (first != std::int64_t{i} * layout->rows_in_chunk()) return name + " holds the wrong rows";
    const auto rows = std::min<std::size_t>(layout->rows_in_chunk(), layout->height - static_cast<std::size_t>(first));
    chunk.resize(rows * row);
    if (!decompress(packed, chunk, layout->compression, spare)) return name + " is damaged";
    for (std::size_t y = 0; y < rows; ++y) {
      put_row(Bytes(chunk).subspan(y * row, row), *layout, places,
              texels.data() + (static_cast<std::size_t>(first) + y) * row_out);
    }
  }
  return texels;
}

}  // namespace foredraw::images
