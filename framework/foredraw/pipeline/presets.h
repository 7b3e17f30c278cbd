#pragma once
#include <span>
#include <string_view>

namespace foredraw {

struct Preset {
  std::string_view name;  ///< used as "@name"
  std::string_view text;  ///< TOML
};

/// The pipelines that travel inside the program, from framework/presets/, by name.
std::span<const Preset> presets();

}  // namespace foredraw
