#include <foredraw/displaced/stored_seams.h>

#include <foredraw/displaced/tessellation_levels.h>

namespace foredraw {

StoredSeams::StoredSeams(const DrawSeams& of)
    : heights_(of.heights.view()), parts_log2_(of.parts_log2.view()), sides_(of.sides.view()) {
  std::uint32_t first = 0;
  for (const std::uint8_t log : parts_log2_) {
    firsts_.push_back(first);
    if (log <= most_log_level) first += (1u << log) - 1;
  }
}

foredraw_seam_table StoredSeams::table() const {
  return {heights_.data(), heights_.size(), firsts_.data(), parts_log2_.data(),
          static_cast<std::uint32_t>(firsts_.size())};
}

bool StoredSeams::is_sound(std::size_t triangles) const {
  const foredraw_seam_table all = table();
  if (foredraw_seam_table_is_sound(&all) == 0) return false;
  const std::size_t named = firsts_.empty() ? 0 : firsts_.back() + (std::size_t{1} << parts_log2_.back()) - 1;
  if (named != heights_.size()) return false;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    const bool is_rising = s == 0 || sides_[s - 1].side < sides_[s].side;
    if (!is_rising || sides_[s].side >= 3 * triangles || sides_[s].edge / 2 >= firsts_.size()) return false;
  }
  return true;
}

std::vector<std::uint32_t> seam_words(const StoredSeams& seams) {
  const foredraw_seam_table table = seams.table();
  std::vector<std::uint32_t> words{static_cast<std::uint32_t>(seams.sides().size()), table.edge_count};
  for (const foredraw_seam_side& side : seams.sides()) words.insert(words.end(), {side.side, side.edge});
  for (std::uint32_t e = 0; e < table.edge_count; ++e) words.push_back(8 * table.firsts[e] + table.parts_log2[e]);
  for (std::size_t h = 0; h < table.height_count; h += 2) {
    const std::uint32_t next = h + 1 < table.height_count ? table.heights[h + 1] : 0u;
    words.push_back(table.heights[h] | next << 16);
  }
  return words;
}

}  // namespace foredraw
