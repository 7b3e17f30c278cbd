#pragma once
// How many index entries a slot of a merged draw holds: the frequency. Every mesh is cut into slots of that many
// entries; the last one is padded by triangles that draw nothing. Large slots pad more, small slots need more records.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw::processors::merge_instances {

/// Meshes of one size, and how often they are placed together. Sizes may repeat.
struct MeshSize {
  std::uint64_t indices = 0;  ///< entries of the index buffer, below 2^32; 0 needs no slot
  std::uint64_t placed = 1;
};

/// What is paid, in bytes that the vertex shader reads.
///
/// A padded entry is a call of the vertex shader that reads its index (4 bytes) and its slot's record (8), as any
/// other, and comes to nothing: 12. A slot's record lies in memory once (8) and is read from there once (8) before it
/// is in the cache for the calls that follow: 2 for each of its bytes. So a slot is worth one padded entry and a third,
/// and one triangle of padding as much as two slots and a quarter.
struct FrequencyOptions {
  std::uint32_t multiple = 3;  ///< frequencies are multiples of it: 3, or the entries of a primitive group
  std::uint32_t classes = 1;   ///< different frequencies at most, 1 to 4; each mesh goes where it is cheapest
  double slot_bytes = 8;       ///< of a slot's record
  double padded_cost = 12;     ///< of a padded index entry
  double slot_byte_cost = 2;   ///< of a byte of slot records
  double class_cost = 0;       ///< of each class beyond the first: draws that it adds, times what a draw costs
  /// Of a search in meshes looked at, where it could take long: with 3 or 4 classes, under a limit, and where meshes
  /// have millions of entries. Then the best so far stands.
  std::uint64_t most_steps = 20'000'000;
};

struct FrequencyChoice {
  std::vector<std::uint32_t> frequencies;  ///< rising; empty where no mesh has indices
  std::vector<std::uint8_t> mesh_class;    ///< [mesh] the frequency's number
  std::uint64_t indices = 0;               ///< entries without padding, over all placed
  std::uint64_t padded = 0;                ///< padding, over all placed
  std::uint64_t slots = 0;                 ///< over all placed
  double cost = 0;
  double bound = 0;    ///< no choice with as many classes costs less
  bool proven = true;  ///< cost == bound

  /// Padded over all entries that are drawn, the padded ones too.
  double padding() const {
    return indices + padded == 0 ? 0 : static_cast<double>(padded) / static_cast<double>(indices + padded);
  }
};

inline std::uint64_t slots_of(std::uint64_t indices, std::uint32_t frequency) {
  return (indices + frequency - 1) / frequency;
}

/// The frequencies of least cost: exactly for one class, for two up to some hundred sizes of some ten thousand entries,
/// and beyond that where `proven` says so. Throws std::invalid_argument where an option is out of its range or a mesh
/// has 2^32 entries or more.
FrequencyChoice best_frequencies(std::span<const MeshSize> meshes, const FrequencyOptions& options = {});

/// The fewest slots with a padding() of at most `most_padding`, from 0 to 1: exactly for one class and where `proven`
/// says so, which for two it nearly always does; else the best that is found. `cost` and `bound` are slots. The prices
/// of the options play no part. Nothing where every frequency pads more than that.
std::optional<FrequencyChoice> fewest_slots(std::span<const MeshSize> meshes, double most_padding,
                                            const FrequencyOptions& options = {});

}  // namespace foredraw::processors::merge_instances
