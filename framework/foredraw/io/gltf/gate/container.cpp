// The outermost layer: GLB or JSON text, and the text parsed.
#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/text/private/json_text.h>

#include <fmt/format.h>

namespace foredraw::gltf {

namespace {

std::uint32_t word(Bytes bytes, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

std::string_view text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
const char* const make_again = "export the file again; it was cut off or damaged on its way";

/// The chunks of a GLB; nullopt where header and lengths do not agree with the bytes.
std::optional<std::vector<Chunk>> chunks_of(Gate& gate, Bytes file) {
  if (file.size() < 12) {
    gate.error("header", "glb-length", fmt::format("a GLB has at least 12 bytes, but the file has {}", file.size()),
               make_again);
    return std::nullopt;
  }
  if (word(file, 4) != 2) {
    gate.error("header.version", "gltf-version", fmt::format("GLB version is {}, but must be 2", word(file, 4)),
               "convert the file to glTF 2.0 first");
    return std::nullopt;
  }
  if (word(file, 8) >= 12 && word(file, 8) < file.size()) {
    gate.fault("trailing-bytes", "header.length",
               fmt::format("the header says {} bytes, but the file has {}", word(file, 8), file.size()));
    gate.mend();
    file = file.first(word(file, 8));
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
                          : fmt::format("its length is {} bytes, but {} are left", word(file, at), left - 8),
                 make_again);
      return std::nullopt;
    }
    const std::size_t length = word(file, at);
    if (length % 4 != 0) {
      gate.fault("chunk-length", place, fmt::format("its length {} is not a multiple of 4", length));
      gate.mend();
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
    gate.error("chunks[0]", "glb-chunk", "the first chunk must be JSON, and not empty", make_again);
    return std::nullopt;
  }
  Container container{text_of(chunks->front().bytes), std::nullopt};
  for (std::size_t i = 1; i < chunks->size(); ++i) {
    const Chunk& chunk = (*chunks)[i];
    if (chunk.type == glb_bin_chunk && i == 1) {
      container.bin = chunk.bytes;
    } else if (chunk.type == glb_bin_chunk || chunk.type == glb_json_chunk) {
      gate.error(fmt::format("chunks[{}]", i), "glb-chunk",
                 "only the first chunk may be JSON, and only the second may be BIN");
      return std::nullopt;
    } else {
      gate.document().further_chunks.push_back(chunk);
    }
  }
  return container;
}

}  // namespace

std::optional<Container> open_container(Gate& gate) {
  const Bytes file = gate.document().file.view();
  const std::string_view text = text_of(file);
  if (file.empty()) {
    gate.error({}, "not-gltf", "the file is empty", "export it again");
    return std::nullopt;
  }
  if (file.size() >= 4 && word(file, 0) == glb_magic) {
    gate.document().binary = true;
    return open_glb(gate, file);
  }
  if (text.substr(0, byte_order_mark.size()) != byte_order_mark) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '{') {
      gate.error({}, "not-gltf", "not glTF: it starts neither with 'glTF' (.glb) nor with '{' (.gltf)",
                 "export the file as .glb or .gltf");
      return std::nullopt;
    }
  }
  return Container{text, std::nullopt};
}

bool parse_json(Gate& gate, std::string_view text) {
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) {
    gate.fault("byte-order-mark", {}, "the JSON starts with a byte order mark, which glTF forbids");
    gate.mend();
    text.remove_prefix(byte_order_mark.size());
  }
  auto parsed = parse_json_text(text);
  if (const JsonFault* fault = std::get_if<JsonFault>(&parsed)) {
    if (fault->byte) {
      gate.error_at(*fault->byte, text, fault->code, fault->message, fault->hint);
    } else {
      gate.error({}, fault->code, fault->message, fault->hint);
    }
    return false;
  }
  gate.document().json = std::move(std::get<Json>(parsed));
  return true;
}

}  // namespace foredraw::gltf
