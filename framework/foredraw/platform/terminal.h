#pragma once
namespace foredraw {

/// Whether somebody watches standard error.
bool stderr_is_terminal();

}  // namespace foredraw
