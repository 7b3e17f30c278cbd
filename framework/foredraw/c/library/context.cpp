#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/technique/built_in_plugins.h>

#include <algorithm>
#include <cstring>
#include <limits>

foredraw_context::foredraw_context(const foredraw_settings& given)
    : settings(given),
      executor(static_cast<int>(std::min(given.threads, std::uint32_t{std::numeric_limits<std::int16_t>::max()}))) {
  foredraw::add_built_in_plugins(registry);
}

namespace foredraw::c {

Cancellable::Cancellable(foredraw_context& context) : context_(context) {
  const std::lock_guard lock(context_.mutex);
  context_.running.insert(&is_cancelled_);
}

Cancellable::~Cancellable() {
  const std::lock_guard lock(context_.mutex);
  context_.running.erase(&is_cancelled_);
}

std::function<void(std::string_view, double)> Cancellable::progress() {
  if (context_.settings.progress == nullptr) return {};
  return [this](std::string_view what, double part) {
    const foredraw_settings& settings = context_.settings;
    if (settings.progress(settings.user, std::string(what).c_str(), part) != 0) is_cancelled_ = true;
  };
}

JobSetup setup_for(Cancellable& call, const Lender& lender) {
  return {.registry = call.context().registry,
          .executor = call.context().executor,
          .lender = &lender,
          .input = call.context().input(),
          .cancel = &call.is_cancelled(),
          .progress = call.progress()};
}

}  // namespace foredraw::c

uint32_t foredraw_version(void) { return FOREDRAW_VERSION_NUMBER; }

foredraw_context* foredraw_context_new(const foredraw_settings* settings) {
  try {
    foredraw_settings known = {};
    // Of a caller with another version's header: what both know.
    if (settings != nullptr) std::memcpy(&known, settings, std::min<std::size_t>(settings->size, sizeof known));
    return new foredraw_context(known);
  } catch (...) {
    return nullptr;
  }
}

void foredraw_context_free(foredraw_context* context) { delete context; }

void foredraw_cancel(foredraw_context* context) {
  if (context == nullptr) return;
  const std::lock_guard lock(context->mutex);
  for (std::atomic<bool>* call : context->running) *call = true;
}
