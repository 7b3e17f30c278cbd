#include "byte_size.h"

#include <charconv>
#include <string>

namespace foredraw::cli {

std::optional<std::uint64_t> byte_size_in(std::string_view text) {
  std::uint64_t size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  const std::string unit(end, text.data() + text.size());
  constexpr std::string_view units = "KMGT";
  const std::size_t power = unit.size() == 1 ? units.find(unit[0]) : std::string_view::npos;
  if (error != std::errc() || size == 0 || (!unit.empty() && power == std::string_view::npos)) return std::nullopt;
  const std::size_t shift = unit.empty() ? 0 : 10 * (power + 1);
  return size > (~std::uint64_t{0} >> shift) ? std::nullopt : std::optional(size << shift);
}

}  // namespace foredraw::cli
