#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/modules/load_modules.h>
#include <foredraw/modules/serve.h>

using namespace foredraw;
using namespace foredraw::c;

int foredraw_load_module(foredraw_context* context, const char* path, uint32_t inside, foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (context == nullptr || path == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    add_modules({.places = {path}, .inside = inside != 0}, context->executor, context->registry, diagnostics);
    put(diagnostics, problems);
    return diagnostics.has_errors() ? FOREDRAW_MISTAKE : FOREDRAW_DONE;
  });
}

int foredraw_serve_module(const foredraw_module* module) {
  return at_border(nullptr, [&]() -> int {
    serve(module);
    return FOREDRAW_FAILED;
  });
}
