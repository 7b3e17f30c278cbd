#pragma once
#include <foredraw/c/plugin.h>
#include <foredraw/modules/draw_overdraw.h>
#include <foredraw/technique/plugin.h>

#include <optional>
#include <string>

namespace foredraw {

/// What a foreign technique is handed to ask and tell.
class ForeignHost {
 public:
  /// `metrics`: what figures it may tell. `overdraw`: null where it may not ask for it.
  ForeignHost(Run& run, const std::vector<Metric>& metrics, DrawOverdraw* overdraw);
  ForeignHost(const ForeignHost&) = delete;
  ForeignHost& operator=(const ForeignHost&) = delete;

  const foredraw_host& table() const { return table_; }
  /// What it said that it failed of, or what was wrong with what it told.
  const std::optional<std::string>& failure() const { return failure_; }
  /// To be called at the end: tells of notes that were left out.
  void end() const;

 private:
  static ForeignHost& of(void* self) { return *static_cast<ForeignHost*>(self); }
  bool is_figure(const char* metric, double numerator, double denominator, double error);
  void note(const char* code, const char* message);
  int count_overdraw(const std::uint32_t* order, std::uint64_t* shaded, std::uint64_t* visible) noexcept;

  Run& run_;
  const std::vector<Metric>& metrics_;
  DrawOverdraw* overdraw_;
  foredraw_host table_;
  std::optional<std::string> failure_;
  std::size_t notes_ = 0;
};

}  // namespace foredraw
