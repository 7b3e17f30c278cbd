// The outermost layer: GLB or JSON text, and the text parsed.
#include <foredraw/io/private/gltf_gate.h>

#include <fmt/format.h>

#include <set>

namespace foredraw::gltf {

namespace {

constexpr int deepest = 64;
constexpr std::size_t most_keys = 2048;  // of one object, whose keys are looked for one after the other

std::uint32_t word(Bytes bytes, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

std::string_view text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

const char* const make_again = "export the file again; it was cut off or damaged on its way";

/// The chunks of a GLB; nullopt where header and lengths do not agree with the bytes.
std::optional<std::vector<Chunk>> chunks_of(Gate& gate, Bytes file) {
  if (file.size() < 12) {
    gate.error("header", "glb-length", fmt::format("a GLB has 12 bytes at least, this has {}", file.size()),
               make_again);
    return std::nullopt;
  }
  if (word(file, 4) != 2) {
    gate.error("header.version", "gltf-version", fmt::format("GLB version is {}, but must be 2", word(file, 4)),
               "convert the file to glTF 2.0 first");
    return std::nullopt;
  }
  if (word(file, 8) != file.size()) {
    gate.error("header.length", "glb-length",
               fmt::format("the header says {} bytes, but the file has {}", word(file, 8), file.size()), make_again);
    return std::nullopt;
  }
  std::vector<Chunk> chunks;
  for (std::size_t at = 12; at < file.size();) {
    const std::string place = fmt::format("chunks[{}]", chunks.size());
    const std::size_t left = file.size() - at;
    if (left < 8 || word(file, at) > left - 8) {
      gate.error(place, "glb-chunk",
                 left < 8 ? fmt::format("{} bytes are left, too few for a chunk", left)
                          : fmt::format("says {} bytes, but {} are left", word(file, at), left - 8),
                 make_again);
      return std::nullopt;
    }
    const std::size_t length = word(file, at);
    if (length % 4 != 0) {
      gate.error(place, "glb-chunk", fmt::format("its length {} is not a multiple of 4", length), make_again);
      return std::nullopt;
    }
    chunks.push_back({word(file, at + 4), file.subspan(at + 8, length)});
    at += 8 + length;
  }
  return chunks;
}

std::optional<Container> open_glb(Gate& gate, Bytes file) {
  const auto chunks = chunks_of(gate, file);
  if (!chunks) return std::nullopt;
  if (chunks->empty() || chunks->front().type != glb_json_chunk || chunks->front().bytes.empty()) {
    gate.error("chunks[0]", "glb-chunk", "the first chunk must be JSON and not empty", make_again);
    return std::nullopt;
  }
  Container container{text_of(chunks->front().bytes), std::nullopt};
  for (std::size_t i = 1; i < chunks->size(); ++i) {
    const Chunk& chunk = (*chunks)[i];
    if (chunk.type == glb_bin_chunk && i == 1) {
      container.bin = chunk.bytes;
    } else if (chunk.type == glb_bin_chunk || chunk.type == glb_json_chunk) {
      gate.error(fmt::format("chunks[{}]", i), "glb-chunk",
                 "a JSON chunk must be the first and a BIN chunk the second, and there may be one of each");
      return std::nullopt;
    } else {
      gate.document().further_chunks.push_back(chunk);
    }
  }
  return container;
}

/// Parsers recurse, so that depth has to be bounded before one is let loose. Returns the byte where it gets too deep.
std::optional<std::size_t> too_deep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest) return i;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return std::nullopt;
}

/// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." without what we say ourselves.
std::string reason(const std::string& what) {
  const std::size_t from = what.find("syntax error");
  if (from != std::string::npos) return what.substr(from);
  const std::size_t bracket = what.find("] ");
  return bracket == std::string::npos ? what : what.substr(bracket + 2);
}

/// Reads along for what a tree of values no longer shows or has no room for. The parser's own callback would ask all of
/// an array at the end of each of its objects.
class Reading final : public Json::json_sax_t {
 public:
  std::string twice;                 ///< the first key that stands twice in one object
  bool is_crowded = false;           ///< some object has too many keys
  std::optional<std::size_t> stuck;  ///< the byte at which it is no JSON
  std::string why;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return true;
  }
  bool end_object() override {
    keys_.pop_back();
    return true;
  }
  bool key(string_t& key) override {
    if (!keys_.back().insert(key).second && twice.empty()) twice = key;
    is_crowded = keys_.back().size() > most_keys;
    return !is_crowded;
  }
  bool parse_error(std::size_t byte, const std::string&, const Json::exception& mistake) override {
    stuck = byte == 0 ? 0 : byte - 1;
    why = reason(mistake.what());
    return false;
  }

 private:
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

}  // namespace

std::optional<Container> open_container(Gate& gate) {
  const Bytes file = gate.document().file.view();
  const std::string_view text = text_of(file);
  if (file.size() >= 4 && word(file, 0) == glb_magic) {
    gate.document().binary = true;
    return open_glb(gate, file);
  }
  if (text.substr(0, 3) != "\xEF\xBB\xBF") {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '{') {
      gate.error({}, "not-gltf", "is no glTF: it starts neither with 'glTF' (.glb) nor with '{' (.gltf)",
                 "is the file empty, or of another format?");
      return std::nullopt;
    }
  }
  return Container{text, std::nullopt};
}

bool parse_json(Gate& gate, std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") {
    gate.error_at(0, text, "json-bom", "the JSON starts with a byte order mark, which glTF forbids",
                  "save it as UTF-8 without byte order mark");
    return false;
  }
  if (const auto byte = too_deep(text)) {
    gate.error_at(*byte, text, "json-nesting", fmt::format("the JSON is nested deeper than {} levels", deepest));
    return false;
  }
  Reading reading;
  Json::sax_parse(text.begin(), text.end(), &reading);
  if (reading.stuck) {
    gate.error_at(*reading.stuck, text, "json-syntax", "is not JSON: " + reading.why);
  } else if (reading.is_crowded) {
    gate.error({}, "json-crowd", fmt::format("an object has more than {} keys", most_keys), "put them into an array");
  } else if (!reading.twice.empty()) {
    gate.error({}, "json-duplicate-key", fmt::format("the key '{}' stands twice in one object", reading.twice),
               "keep one of them; readers differ in which they take");
  } else {
    gate.document().json = Json::parse(text.begin(), text.end());
    return true;
  }
  return false;
}

}  // namespace foredraw::gltf
