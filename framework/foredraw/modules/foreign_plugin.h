#pragma once
#include <foredraw/modules/foreign_runner.h>
#include <foredraw/technique/plugin.h>

namespace foredraw {

/// The plugin that a description in C says. Nothing of the description is kept. std::invalid_argument says what is
/// wrong with it.
Plugin foreign_plugin(const foredraw_plugin& described, std::shared_ptr<const ForeignRunner> runner);

}  // namespace foredraw
