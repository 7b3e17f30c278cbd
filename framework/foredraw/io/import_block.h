#pragma once
// The block of memory through which foredraw-import hands over what it read. It is all that the two speak through, and
// the importer finds it as its descriptor 3.

#include <foredraw/platform/shared_word.h>

#include <cstddef>
#include <cstdint>

namespace foredraw {

inline constexpr int import_descriptor = 3;

enum class ImportTurn : std::uint32_t {
  begins,  ///< it reads
  ended,   ///< it is no more, and all that stands here is final
};

struct ImportBlock {
  SharedWord turn;             ///< an ImportTurn
  std::uint32_t is_whole;      ///< whether the GLB is there
  std::uint32_t is_refused;    ///< or the file was, for the reason that was told last
  std::uint64_t glb_bytes;     ///< of the GLB, from glb_place on
  std::uint64_t told_bytes;    ///< of what was told, from told_place on
  std::uint64_t wanted_bytes;  ///< of a GLB for which there is no room

  // By who watched it.
  std::uint32_t by_signal;
  std::int32_t code;
  std::uint64_t peak_memory;
  std::uint32_t last_words_bytes;
  char last_words[4096];
};

/// What is told stands one after the other: one of these, a text, a zero.
enum class ImportTold : char {
  read = 'r',       ///< the path of a file beside, which was read
  missing = 'm',    ///< the path of one that was looked for
  left_out = 'w',   ///< what glTF does not get, and why; behind a line end, what to do
  refused = 'e',    ///< why there is no GLB
  no_memory = 'o',  ///< there is none, for the memory that it may have is too little
};

inline constexpr std::size_t told_place = 8192;
inline constexpr std::size_t told_room = std::size_t{1} << 20;
inline constexpr std::size_t glb_place = told_place + told_room;
/// A GLB says its length in 32 bits.
inline constexpr std::size_t import_block_bytes = glb_place + (std::size_t{1} << 32);
static_assert(sizeof(ImportBlock) <= told_place);

}  // namespace foredraw
