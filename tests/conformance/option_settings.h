#pragma once
// At which settings of its options a plugin is asked.

#include <foredraw/technique/plugin.h>

#include <vector>

namespace foredraw::testing {

/// The defaults, but for pictures and samples: a few small ones are made by the same code as many large ones, in a
/// hundredth of the time.
Settings few_pictures(const Plugin& plugin);

/// The defaults; everything at its least; and each option at its most with the others at their least. Pictures and
/// samples go as far as takes seconds.
std::vector<Settings> settings_of(const Plugin& plugin);

/// True if it says how many pictures are made, how large, or of how many samples.
bool is_of_pictures(const OptionSpec& option);

/// Everything at its least, but that one at its most, as far as takes minutes.
Settings with_the_largest(const Plugin& plugin, const OptionSpec& option);

}  // namespace foredraw::testing
