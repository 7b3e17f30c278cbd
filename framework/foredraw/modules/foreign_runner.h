#pragma once
#include <foredraw/c/plugin.h>

#include <memory>
#include <mutex>
#include <span>

namespace foredraw {

/// Who runs a technique of C's: in this process, or in another one.
class ForeignRunner {
 public:
  virtual ~ForeignRunner() = default;
  /// As foredraw_plugin::run, with the values of its options. Throws std::runtime_error where no status came back.
  virtual int run(const foredraw_draw& draw, std::span<const foredraw_value> options, foredraw_answer& answer,
                  const foredraw_host& host) const = 0;
};

/// In this process, and on one thread at a time unless it says otherwise. Rounding and the like are afterwards as they
/// were, whatever it did to them: later stages' bytes hang on that. `plugin` has to outlive it.
class RunsInside final : public ForeignRunner {
 public:
  explicit RunsInside(const foredraw_plugin& plugin) : plugin_(plugin) {}
  int run(const foredraw_draw& draw, std::span<const foredraw_value> options, foredraw_answer& answer,
          const foredraw_host& host) const override;

 private:
  const foredraw_plugin& plugin_;
  mutable std::mutex one_at_a_time_;
};

}  // namespace foredraw
