#pragma once
// The two blocks of memory through which a program and a worker speak: `asked`, which the worker can not write, and
// `answered`. They are all that a call needs, so that a module may close every descriptor there is. A worker finds them
// as its descriptors 3 and 4.

#include <foredraw/platform/shared_word.h>

#include <cstddef>
#include <cstdint>

namespace foredraw {

inline constexpr int asked_descriptor = 3;
inline constexpr int answered_descriptor = 4;

/// A call. Places are bytes from the block's begin; 0 is NULL.
struct AskedCall {
  SharedWord cancelled;
  std::uint32_t plugin;  ///< of the module's, by number
  std::uint64_t seed;
  std::uint64_t room;  ///< numbers that the answer may have
  std::uint64_t vertex_room;
  std::uint32_t may_count;  ///< whether it may ask for overdraw; an order for that lies behind the answer
  // What came of that.
  std::int32_t counted;
  std::uint64_t shaded, visible;
  std::uint64_t triangle_count;
  std::uint32_t vertex_count;
  std::uint32_t stream_count;
  std::uint32_t cluster_count;
  std::uint32_t option_count;
  std::uint64_t name, indices, positions, streams, cluster_offsets, options;
};

struct AskedStream {
  std::uint64_t semantic, bytes;
  std::uint32_t stride, component, components, normalized;
};

struct AskedOption {
  std::int64_t integer;
  double number;
  std::uint64_t text;
};

/// Who has to do the next thing.
enum class BlockTurn : std::uint32_t {
  begins,   ///< the worker loads its module
  program,  ///< it answered
  worker,   ///< it was asked
  ended,    ///< it is no more
  counts    ///< it asks for the overdraw of an order meanwhile, and the program has to say
};

struct AnsweredCall {
  SharedWord turn;  ///< a BlockTurn
  /// Of the module that was loaded: whether it was refused, and how much is told at first: its tables, or why.
  std::uint32_t refused;
  std::int32_t status;
  std::uint32_t said_bytes;  ///< what it told its host, message by message
  std::uint64_t count;       ///< of the answer
  std::uint64_t vertex_count;
  std::uint32_t has_order;  ///< of what it asks for; 0: as the triangles stand
  std::uint64_t left_out;   ///< messages for which there was no room

  // Once it ended, by who watched it.
  std::uint32_t by_signal;
  std::int32_t code;
  std::uint64_t peak_memory;
  std::uint32_t last_words_bytes;
  char last_words[4096];
};

inline constexpr std::size_t said_place = 8192;
inline constexpr std::size_t said_room = std::size_t{1} << 20;
/// Numbers of the answer, those of its vertices, an order to count the overdraw of.
inline constexpr std::size_t values_place = said_place + said_room;
static_assert(sizeof(AnsweredCall) <= said_place);

/// What a message is of, its first number.
enum class WorkerSaid : std::uint32_t { keep, fail, note, count, measure };

}  // namespace foredraw
