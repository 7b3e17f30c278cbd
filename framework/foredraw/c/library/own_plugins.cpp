#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/modules/foreign_plugin.h>

#include <stdexcept>

using namespace foredraw;
using namespace foredraw::c;

int foredraw_add_plugin(foredraw_context* context, const foredraw_plugin* plugin, foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (context == nullptr || plugin == nullptr) return FOREDRAW_NULL_POINTER;
    try {
      context->registry.add(foreign_plugin(*plugin, std::make_shared<RunsInside>(*plugin)));
      return FOREDRAW_DONE;
    } catch (const std::invalid_argument& wrong) {
      Diagnostics diagnostics;
      diagnostics.error({}, "bad-plugin", wrong.what());
      put(diagnostics, problems);
      return FOREDRAW_MISTAKE;
    }
  });
}
