#include "option_settings.h"

#include <algorithm>
#include <cmath>

namespace foredraw::testing {

namespace {

/// How far pictures and samples go: a hundred thousand views show no more than a thousand, but take a device minutes.
struct Pictures {
  double views, pixels, points, frames, samples;
};
constexpr Pictures some_pictures{30, 128, 500, 4, 64};
constexpr Pictures largest_pictures{1000, 4096, 100'000, 300, 65'536};

bool is_size(const OptionSpec& option) {
  return option.unit == "pixels" && (option.name == "size" || option.name == "width" || option.name == "height");
}

double most_of(const OptionSpec& option, const Pictures& pictures) {
  if (option.unit == "views") return std::min(option.most, pictures.views);
  if (option.unit == "points") return std::min(option.most, pictures.points);
  if (option.unit == "frames") return std::min(option.most, pictures.frames);
  if (option.unit == "samples") return std::min(option.most, pictures.samples);
  return is_size(option) ? std::min(option.most, pictures.pixels) : option.most;
}

std::optional<OptionValue> extreme(const OptionSpec& option, bool most, const Pictures& pictures = some_pictures) {
  // The least error takes the most views, and leaves the other options of views unused.
  if (option.name == "error" && !most) return std::nullopt;
  // Pictures of each object take seconds: the defaults ask for them.
  if (option.name == "accuracy" && !most) return std::string("errors");
  const double bound = most ? most_of(option, pictures) : option.least;
  if (option.type == OptionType::boolean) return most;
  if (option.type == OptionType::choice) return most ? option.choices.back() : option.choices.front();
  if (!std::isfinite(bound)) return std::nullopt;
  if (option.type == OptionType::integer) return static_cast<std::int64_t>(bound);
  if (option.type == OptionType::number) return bound;
  return std::nullopt;
}

/// The options that a plugin may not do without: those that name files, and choices without a default.
Settings what_must_be_said(const Plugin& plugin) {
  Settings said;
  for (const OptionSpec& option : plugin.options) {
    if (option.type == OptionType::scene || option.type == OptionType::image) said[option.name] = std::string("lent");
    const bool has_default = !std::holds_alternative<std::monostate>(option.default_value);
    if (option.type == OptionType::choice && !has_default) said[option.name] = option.choices.front();
  }
  return said;
}

/// Everything at its least.
Settings least_of(const Plugin& plugin) {
  Settings least = what_must_be_said(plugin);
  for (const OptionSpec& option : plugin.options) {
    if (const auto value = extreme(option, false)) least[option.name] = *value;
  }
  return least;
}

}  // namespace

Settings few_pictures(const Plugin& plugin) {
  Settings settings = what_must_be_said(plugin);
  for (const OptionSpec& option : plugin.options) {
    if (option.unit == "views") settings[option.name] = std::int64_t{12};
    if (option.unit == "points") settings[option.name] = std::int64_t{100};
    if (option.unit == "samples") settings[option.name] = static_cast<std::int64_t>(option.least);
    if (option.unit == "frames") settings[option.name] = std::int64_t{3};
    if (is_size(option)) settings[option.name] = std::int64_t{48};
    // Pictures of each object take seconds.
    if (option.name == "accuracy") settings[option.name] = std::string("errors");
    if (option.name == "renderings") settings[option.name] = false;
  }
  return settings;
}

std::vector<Settings> settings_of(const Plugin& plugin) {
  const Settings least = least_of(plugin);
  std::vector<Settings> all{few_pictures(plugin), least};
  for (const OptionSpec& option : plugin.options) {
    if (const auto value = extreme(option, true)) {
      all.push_back(least);
      all.back()[option.name] = *value;
    }
  }
  return all;
}

bool is_of_pictures(const OptionSpec& option) {
  return option.unit == "views" || option.unit == "frames" || option.unit == "samples" || is_size(option);
}

Settings with_the_largest(const Plugin& plugin, const OptionSpec& option) {
  Settings settings = least_of(plugin);
  settings[option.name] = *extreme(option, true, largest_pictures);
  return settings;
}

}  // namespace foredraw::testing
