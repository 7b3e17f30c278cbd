#include <foredraw/platform/terminal.h>

#include <unistd.h>

namespace foredraw {

bool stderr_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace foredraw
