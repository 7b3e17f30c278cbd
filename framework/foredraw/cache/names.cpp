#include <foredraw/cache/names.h>

#include <charconv>

namespace foredraw {

namespace {

constexpr std::size_t digits_of_a_folder = 2;

std::optional<std::uint64_t> number_in(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, mistake] = std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return mistake == std::errc() && end == digits.data() + digits.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<Stamp> stamp_in(std::string_view digits) {
  if (digits.size() != 32) return std::nullopt;
  const auto high = number_in(digits.substr(0, 16)), low = number_in(digits.substr(16));
  return high && low ? std::optional(Stamp{*high, *low}) : std::nullopt;
}

std::filesystem::path place_below(const std::filesystem::path& folder, const Stamp& stamp) {
  const std::string digits = to_text(stamp);
  return folder / digits.substr(0, digits_of_a_folder) / digits.substr(digits_of_a_folder);
}

std::optional<Stamp> stamp_called(const std::filesystem::path& place) {
  return stamp_in(place.parent_path().filename().string() + place.filename().string());
}

}  // namespace foredraw
