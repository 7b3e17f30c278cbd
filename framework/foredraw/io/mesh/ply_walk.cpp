#include <foredraw/io/mesh/private/ply.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace foredraw::mesh_files {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr TypeName type_names[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

std::optional<PlyType> type_of(std::string_view name) {
  for (const TypeName& row : type_names) {
    if (row.name == name) return row.type;
  }
  return std::nullopt;
}

/// The header, line by line.
class HeaderReader {
 public:
  explicit HeaderReader(const Reading& reading) : reading_(reading), text_(without_mark(reading.text)) {}

  bool run() {
    // Old Macintoshes end a line with a carriage return alone. All lines end as the first.
    const std::size_t first_end = text_.find_first_of("\r\n");
    if (first_end != text_.npos && !text_.substr(first_end).starts_with("\r\n")) line_end_ = text_[first_end];
    std::string_view line = take_line(text_, line_end_);
    if (trimmed(line) != "ply") return reading_.refuse(reading_.at(line), "the first line must be 'ply'");
    bool has_format = false;
    while (!text_.empty()) {
      line = take_line(text_, line_end_);
      std::string_view rest = line;
      const std::string_view key = take_token(rest);
      if (key == "end_header") {
        header.end = reading_.text.size() - text_.size();
        return has_format || reading_.refuse(reading_.at(key), "the header has no line 'format'");
      }
      if (key.empty() || key == "comment" || key == "obj_info") continue;
      if (key == "format") {
        if (!format(rest)) return false;
        has_format = true;
      } else if (key == "element") {
        if (!element(rest)) return false;
        declare(line.data());
      } else if (key == "property") {
        if (!property(rest)) return false;
        declare(header.elements.back().lines.data());
      } else if (header.unknown_word.empty()) {
        header.unknown_word = key;
      }
    }
    if (!header.unknown_word.empty()) return refuse_unknown_word(reading_, header);
    return reading_.refuse(reading_.at(text_), "the file ends inside its header");
  }

  PlyHeader header;

 private:
  bool format(std::string_view rest) {
    const std::string_view name = take_token(rest), version = take_token(rest);
    using Encoding = PlyHeader::Encoding;
    if (name == "ascii")
      header.encoding = Encoding::ascii;
    else if (name == "binary_little_endian")
      header.encoding = Encoding::little;
    else if (name == "binary_big_endian")
      header.encoding = Encoding::big;
    else
      return reading_.refuse(
          reading_.at(name),
          fmt::format("{} is not a PLY format; expected ascii, binary_little_endian or binary_big_endian",
                      shown(name)));
    return version == "1.0" ||
           reading_.refuse(reading_.at(version), fmt::format("expected version 1.0, found {}", shown(version)));
  }

  /// The last element's lines go from there to here.
  void declare(const char* begin) {
    header.elements.back().lines = {begin, static_cast<std::size_t>(text_.data() - begin)};
  }

  bool element(std::string_view rest) {
    PlyElement made;
    made.name = take_token(rest);
    made.count_token = take_token(rest);
    if (!read_integer(made.count_token, made.count)) {
      return reading_.refuse(reading_.at(made.count_token),
                             fmt::format("expected the number of elements, found {}", shown(made.count_token)));
    }
    if (!element_names_.insert(made.name).second) {
      return reading_.refuse(reading_.at(made.count_token), fmt::format("there are two elements {}", shown(made.name)));
    }
    header.elements.push_back(std::move(made));
    return true;
  }

  bool property(std::string_view rest) {
    if (header.elements.empty())
      return reading_.refuse(reading_.at(rest), "there is a property before the first element");
    PlyProperty made;
    std::string_view word = take_token(rest);
    if (word == "list") {
      word = take_token(rest);
      made.list = type_of(word);
      if (!made.list || !is_whole(*made.list)) {
        return reading_.refuse(
            reading_.at(word),
            fmt::format("{} is not a type for the length of a list; expected an integer type", shown(word)));
      }
      word = take_token(rest);
    }
    const auto type = type_of(word);
    if (!type) return reading_.refuse(reading_.at(word), fmt::format("{} is not a PLY type", shown(word)));
    made.type = *type;
    made.name = take_token(rest);
    if (made.name.empty()) return reading_.refuse(reading_.at(rest), "the property has no name");
    made.type_token = word;
    header.elements.back().properties.push_back(std::move(made));
    return true;
  }

  const Reading& reading_;
  std::string_view text_;
  char line_end_ = '\n';
  std::set<std::string> element_names_;
};

template <class T>
double from_bytes(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swap) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

template <class T>
bool integer_from_text(std::string_view token, double& value) {
  T number = 0;
  if (!read_integer(token, number)) return false;
  value = static_cast<double>(number);
  return true;
}

}  // namespace

bool refuse_unknown_word(const Reading& reading, const PlyHeader& header) {
  return reading.refuse(reading.at(header.unknown_word),
                        fmt::format("{} is not a keyword of a PLY header", shown(header.unknown_word)));
}

std::size_t bytes_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto found = std::ranges::find_if(elements, [&](const PlyElement& e) { return e.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

const PlyProperty* PlyHeader::corner_list() const {
  const PlyElement* faces = find("face");
  if (faces == nullptr) return nullptr;
  const auto found = std::ranges::find_if(faces->properties, names_vertices);
  return found == faces->properties.end() ? nullptr : &*found;
}

std::optional<PlyHeader> read_ply_header(const Reading& reading) {
  HeaderReader reader(reading);
  if (!reader.run()) return std::nullopt;
  return std::move(reader.header);
}

bool PlyWalk::has_line_for_each_record() const {
  // A line that was skipped may have been a misspelt property: then the values themselves have to come out even.
  if (header_.encoding != PlyHeader::Encoding::ascii || !header_.unknown_word.empty()) return false;
  std::uint64_t lines = 0;
  for (std::string_view rest = reading_.text.substr(at_); !rest.empty();) {
    if (!trimmed(take_line(rest)).empty()) ++lines;
  }
  for (const PlyElement& element : header_.elements) {
    if (element.properties.empty()) continue;
    if (element.count > lines) return false;
    lines -= element.count;
  }
  return lines == 0;
}

bool PlyWalk::is_line_over() const {
  if (!by_lines_ || begin_ == none_yet) return false;
  const std::string_view text = reading_.text;
  std::size_t at = at_;
  while (at < text.size() && is_space(text[at]) && text[at] != '\n') ++at;
  return at == text.size() || text[at] == '\n';
}

bool PlyWalk::miss() const {
  reading_.fault("line-values", reading_.text.substr(begin_), "the record has fewer values than the header says");
  return true;
}

void PlyWalk::end_line() {
  std::string_view rest = reading_.text.substr(at_);
  const std::string_view more = trimmed(take_line(rest));
  if (more.empty()) return;
  reading_.fault("line-values", more, "the record has more values than the header says");
  at_ = static_cast<std::size_t>(more.data() + more.size() - reading_.text.data());
}

bool PlyWalk::may_hold(const PlyElement& element) const {
  std::size_t least = 0;
  for (const PlyProperty& p : element.properties) {
    least += header_.encoding == PlyHeader::Encoding::ascii ? 2 : bytes_of(p.list ? *p.list : p.type);
  }
  const std::size_t left = reading_.text.size() - at_;
  // The last value of a text needs no space after it.
  if (element.count <= (left + 1) / least) return true;
  return reading_.refuse(reading_.at(element.count_token),
                         fmt::format("{} elements '{}' take at least {} bytes each, but {} bytes are left",
                                     element.count, element.name, least, left));
}

bool PlyWalk::refuse_list(const PlyValue& value, std::size_t left) const {
  const bool is_text = header_.encoding == PlyHeader::Encoding::ascii;
  return reading_.refuse(
      is_text ? reading_.at(reading_.text.substr(value.begin)) : reading_.at_byte(value.begin),
      fmt::format("a list of {} values does not fit in the {} bytes that are left", value.value, left));
}

bool PlyWalk::find(PlyType type, PlyValue& value) {
  if (header_.encoding == PlyHeader::Encoding::ascii) {
    std::string_view rest = reading_.text.substr(at_);
    if (is_line_over()) return reading_.refuse(reading_.at(rest), "the line ends inside its record");
    const std::string_view token = take_token(rest);
    if (token.empty()) return reading_.refuse(reading_.at(rest), "the file ends inside its records");
    value.begin = static_cast<std::size_t>(token.data() - reading_.text.data());
    value.end = value.begin + token.size();
  } else {
    const std::size_t size = bytes_of(type);
    if (reading_.text.size() - at_ < size)
      return reading_.refuse(reading_.at_byte(at_), "the file ends inside a record");
    value.begin = at_;
    value.end = at_ + size;
  }
  at_ = value.end;
  begin_ = std::min(begin_, value.begin);
  return true;
}

bool PlyWalk::pass_over(PlyType type, std::size_t count) {
  PlyValue value;
  for (std::size_t i = 0; i < count; ++i) {
    if (!find(type, value)) return false;
  }
  return true;
}

bool PlyWalk::read(PlyType type, PlyValue& value) {
  if (!find(type, value)) return false;
  if (header_.encoding == PlyHeader::Encoding::ascii) return read_text(type, value);
  const char* bytes = reading_.text.data() + value.begin;
  const bool swap = (header_.encoding == PlyHeader::Encoding::big) == (std::endian::native == std::endian::little);
  switch (type) {
    case PlyType::int8: value.value = from_bytes<std::int8_t>(bytes, swap); break;
    case PlyType::uint8: value.value = from_bytes<std::uint8_t>(bytes, swap); break;
    case PlyType::int16: value.value = from_bytes<std::int16_t>(bytes, swap); break;
    case PlyType::uint16: value.value = from_bytes<std::uint16_t>(bytes, swap); break;
    case PlyType::int32: value.value = from_bytes<std::int32_t>(bytes, swap); break;
    case PlyType::uint32: value.value = from_bytes<std::uint32_t>(bytes, swap); break;
    case PlyType::float32: value.value = from_bytes<float>(bytes, swap); break;
    case PlyType::float64: value.value = from_bytes<double>(bytes, swap); break;
  }
  return true;
}

bool PlyWalk::read_text(PlyType type, PlyValue& value) const {
  const std::string_view token = reading_.text.substr(value.begin, value.end - value.begin);
  bool good = false;
  switch (type) {
    case PlyType::int8: good = integer_from_text<std::int8_t>(token, value.value); break;
    case PlyType::uint8: good = integer_from_text<std::uint8_t>(token, value.value); break;
    case PlyType::int16: good = integer_from_text<std::int16_t>(token, value.value); break;
    case PlyType::uint16: good = integer_from_text<std::uint16_t>(token, value.value); break;
    case PlyType::int32: good = integer_from_text<std::int32_t>(token, value.value); break;
    case PlyType::uint32: good = integer_from_text<std::uint32_t>(token, value.value); break;
    default: {
      float number = 0;
      const bool is_number = read_float(token, number).empty() || !std::isfinite(number);
      if (!is_number) return reading_.read(token, number);  // which refuses
      value.value = number;
      return true;
    }
  }
  return good || reading_.refuse(reading_.at(token),
                                 fmt::format("{} is not a whole number, or does not fit its type", shown(token)));
}

void put_ply_integer(std::span<char> bytes, std::uint32_t value, bool big_endian) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[big_endian ? bytes.size() - 1 - i : i] = static_cast<char>((value >> (8 * i)) & 0xff);
  }
}

}  // namespace foredraw::mesh_files
