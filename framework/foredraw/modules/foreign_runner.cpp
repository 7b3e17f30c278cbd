#include <foredraw/modules/foreign_runner.h>

#include <cfenv>

namespace foredraw {

int RunsInside::run(const foredraw_draw& draw, std::span<const foredraw_value> options, foredraw_answer& answer,
                    const foredraw_host& host) const {
  std::unique_lock lock(one_at_a_time_, std::defer_lock);
  if (plugin_.runs_on_many_threads == 0) lock.lock();
  std::fenv_t before;
  std::fegetenv(&before);
  const int status = plugin_.run(plugin_.user, &draw, options.data(), &answer, &host);
  std::fesetenv(&before);
  return status;
}

}  // namespace foredraw
