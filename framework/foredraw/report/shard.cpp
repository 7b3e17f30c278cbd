#include <foredraw/report/shard.h>

#include <foredraw/base/content_hash.h>

#include <charconv>
#include <string>

namespace foredraw {

namespace {

std::optional<std::uint32_t> number_in(std::string_view text) {
  std::uint32_t number = 0;
  const auto [end, mistake] = std::from_chars(text.data(), text.data() + text.size(), number);
  return mistake == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<Shard> shard_in(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto number = number_in(text.substr(0, slash)), of = number_in(text.substr(slash + 1));
  return number && of && *number >= 1 && *number <= *of ? std::optional(Shard{*number, *of}) : std::nullopt;
}

bool holds(const Shard& shard, const std::filesystem::path& file) {
  const std::string name = file.generic_string();
  return content_hash(std::as_bytes(std::span(name))).high % shard.of == shard.number - 1;
}

}  // namespace foredraw
