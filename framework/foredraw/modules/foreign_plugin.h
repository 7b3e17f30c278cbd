#pragma once
#include <foredraw/modules/foreign_runner.h>
#include <foredraw/technique/plugin.h>

namespace foredraw {

/// A description with whatever this version of it has; what those before it did not have is 0. std::invalid_argument
/// where its size is that of no version.
foredraw_plugin in_this_version(const foredraw_plugin& described);

/// The plugin that a description in C says. Nothing of the description is kept. std::invalid_argument says what is
/// wrong with it.
Plugin foreign_plugin(const foredraw_plugin& described, std::shared_ptr<const ForeignRunner> runner);

}  // namespace foredraw
