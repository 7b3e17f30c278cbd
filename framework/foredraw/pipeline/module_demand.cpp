#include <foredraw/pipeline/module_demand.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace foredraw {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Numbers with dots between.
bool is_version(std::string_view text) {
  if (text.empty() || !is_digit(text.front()) || !is_digit(text.back())) return false;
  return text.find("..") == std::string_view::npos &&
         std::ranges::all_of(text, [](char c) { return is_digit(c) || c == '.'; });
}

/// Its numbers as far as they go: {1, 2} of "1.2-beta".
std::vector<std::uint64_t> numbers_of(std::string_view version) {
  std::vector<std::uint64_t> numbers;
  const char* const end = version.data() + version.size();
  for (const char* at = version.data(); at < end; ++at) {
    std::uint64_t number = 0;
    const auto read = std::from_chars(at, end, number);
    if (read.ec != std::errc()) break;
    numbers.push_back(number);
    at = read.ptr;
    if (at < end && *at != '.') break;
  }
  return numbers;
}

/// What is missing at the end is 0.
bool is_at_least(std::string_view version, std::string_view least) {
  std::vector<std::uint64_t> is = numbers_of(version), wanted = numbers_of(least);
  const std::size_t size = std::max(is.size(), wanted.size());
  is.resize(size), wanted.resize(size);
  return is >= wanted;
}

/// A module of the vendor's: the newest, where several are there.
const ModuleFile* newest_of(const std::string& vendor, const Registry& registry) {
  const ModuleFile* newest = nullptr;
  for (const Plugin* plugin : registry.all()) {
    const ModuleFile* module = registry.module_of(plugin->card.name);
    if (module == nullptr || module->vendor != vendor) continue;
    if (newest == nullptr || !is_at_least(newest->version, module->version)) newest = module;
  }
  return newest;
}

}  // namespace

std::optional<ModuleDemand> module_demand(std::string_view text) {
  const std::size_t sign = text.find(">=");
  const std::string_view vendor = trimmed(text.substr(0, sign));
  const bool is_name =
      !vendor.empty() && std::ranges::all_of(vendor, [](char c) { return is_digit(c) || (c >= 'a' && c <= 'z'); });
  if (!is_name) return std::nullopt;
  if (sign == std::string_view::npos) return ModuleDemand{std::string(vendor), {}};
  const std::string_view version = trimmed(text.substr(sign + 2));
  if (!is_version(version)) return std::nullopt;
  return ModuleDemand{std::string(vendor), std::string(version)};
}

std::string to_text(const ModuleDemand& demand) {
  return demand.version.empty() ? demand.vendor : demand.vendor + " >= " + demand.version;
}

void check_demands(const std::vector<ModuleDemand>& demands, const Registry& registry, Diagnostics& diagnostics) {
  for (const ModuleDemand& demand : demands) {
    const ModuleFile* module = newest_of(demand.vendor, registry);
    if (module == nullptr) {
      diagnostics.error(demand.where, "needs-module",
                        fmt::format("it needs the module '{}', which is not loaded", to_text(demand)),
                        "name its file or folder with --module, or in the environment variable FOREDRAW_MODULES");
    } else if (!is_at_least(module->version, demand.version)) {
      diagnostics.error(
          demand.where, "needs-module",
          fmt::format("it needs the module '{}', but {} is {}", to_text(demand), module->path, module->version),
          "name a newer one with --module");
    }
  }
}

}  // namespace foredraw
