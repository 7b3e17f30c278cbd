#include "stream_bytes.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>

namespace foredraw {

namespace {

void put(std::vector<std::byte>& to, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<std::byte>(word >> shift & 0xff));
}
void put(std::vector<std::byte>& to, float value) { put(to, std::bit_cast<std::uint32_t>(value)); }

std::uint32_t checksum(std::uint32_t so_far, std::span<const std::byte> bytes) {
  return foredraw_stream_checksum(so_far, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

std::vector<std::byte> header_bytes(foredraw_stream_header& header, std::span<const foredraw_part> parts,
                                    std::span<const std::uint32_t> draw_parts,
                                    std::span<const foredraw_component> components) {
  header.bytes = static_cast<std::uint32_t>(FOREDRAW_STREAM_FIXED +
                                            4 * (parts.size() + draw_parts.size() + 4 * components.size()) + 4);
  std::vector<std::byte> bytes;
  for (const std::uint32_t word : {FOREDRAW_STREAM_MAGIC, 1u, header.bytes, header.total, header.chunks, header.points,
                                   header.vertices, header.triangles, header.grid_bits}) {
    put(bytes, word);
  }
  for (const float least : header.least) put(bytes, least);
  put(bytes, header.step);
  for (const std::uint32_t word : {header.parts, header.draws, header.components}) put(bytes, word);
  for (const foredraw_part& part : parts) put(bytes, part.count);
  for (const std::uint32_t part : draw_parts) put(bytes, part);
  for (const foredraw_component& component : components) {
    put(bytes, component.form);
    put(bytes, component.axis);
    put(bytes, component.least);
    put(bytes, component.step);
  }
  put(bytes, checksum(FOREDRAW_STREAM_NO_BYTES, bytes));
  return bytes;
}

std::vector<std::byte> stream_bytes(foredraw_stream_header header, std::span<const foredraw_part> parts,
                                    std::span<const std::uint32_t> draw_parts,
                                    std::span<const foredraw_component> components, std::span<CodedChunk> chunks,
                                    std::vector<std::uint32_t>& chunk_end) {
  header.chunks = static_cast<std::uint32_t>(chunks.size());
  const std::vector<std::byte> first = header_bytes(header, parts, draw_parts, components);
  std::uint64_t total = header.bytes;
  for (const CodedChunk& chunk : chunks) total += FOREDRAW_STREAM_CHUNK + chunk.bytes.size();
  const std::uint64_t memory = foredraw_stream_memory(&header, reinterpret_cast<const std::uint8_t*>(first.data()));
  const std::uint64_t least = memory / 1000 + 1;
  if (total < least) {
    chunks.back().bytes.resize(chunks.back().bytes.size() + (least - total));
    total = least;
  }
  if (total > std::numeric_limits<std::uint32_t>::max()) throw std::runtime_error("the stream exceeds 4 GB");
  header.total = static_cast<std::uint32_t>(total);
  std::vector<std::byte> bytes = header_bytes(header, parts, draw_parts, components);
  for (const CodedChunk& chunk : chunks) {
    const std::size_t begin = bytes.size();
    put(bytes, static_cast<std::uint32_t>(chunk.bytes.size()));
    put(bytes, chunk.splits);
    put(bytes, chunk.vertices);
    put(bytes, chunk.triangles);
    put(bytes, chunk.error);
    put(bytes, checksum(checksum(FOREDRAW_STREAM_NO_BYTES, std::span(bytes).subspan(begin)), chunk.bytes));
    bytes.insert(bytes.end(), chunk.bytes.begin(), chunk.bytes.end());
    chunk_end.push_back(static_cast<std::uint32_t>(bytes.size()));
  }
  return bytes;
}

}  // namespace foredraw
