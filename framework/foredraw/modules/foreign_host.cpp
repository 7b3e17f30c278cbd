#include <foredraw/modules/foreign_host.h>

#include <foredraw/modules/foreign_technique.h>
#include <foredraw/scene/reorder.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace foredraw {

namespace {

constexpr std::size_t most_notes = 100;

}  // namespace

ForeignHost::ForeignHost(Run& run, const std::vector<Metric>& metrics, DrawOverdraw* overdraw)
    : run_(run),
      metrics_(metrics),
      overdraw_(overdraw),
      table_{.size = sizeof table_,
             .seed = run.seed,
             .self = this,
             .cancelled = [](void* self) { return of(self).run_.cancelled() ? 1 : 0; },
             .keep = [](void* self, const char* reason) { of(self).run_.keep(text_from_c(reason)); },
             .fail = [](void* self, const char* message) { of(self).failure_ = text_from_c(message); },
             .note = [](void* self, const char* code, const char* message) { of(self).note(code, message); },
             .count =
                 [](void* self, const char* metric, double number) {
                   if (of(self).is_figure(metric, number, 1, 0)) of(self).run_.count(text_from_c(metric), number);
                 },
             .measure =
                 [](void* self, const char* metric, double numerator, double denominator, double error) {
                   if (!of(self).is_figure(metric, numerator, denominator, error)) return;
                   of(self).run_.measure(text_from_c(metric), numerator, denominator, error);
                 },
             .count_overdraw = [](void* self, const std::uint32_t* order, std::uint64_t* shaded,
                                  std::uint64_t* visible) { return of(self).count_overdraw(order, shaded, visible); }} {
}

void ForeignHost::end() const {
  if (notes_ <= most_notes) return;
  run_.note("notes-left-out", fmt::format("{} more notes are left out", notes_ - most_notes));
}

bool ForeignHost::is_figure(const char* metric, double numerator, double denominator, double error) {
  const std::string name = text_from_c(metric);
  const std::size_t dot = name.rfind('.');
  const std::string on_card = dot == std::string::npos ? name : name.substr(dot + 1);  // of a group
  if (!std::isfinite(numerator) || !std::isfinite(denominator) || !std::isfinite(error)) {
    failure_ = fmt::format("its figure '{}' is not a finite number", name);
  } else if (error < 0) {
    failure_ = fmt::format("its figure '{}' has the error {}, which is negative", name, error);
  } else if (std::ranges::find(metrics_, on_card, &Metric::name) == metrics_.end()) {
    failure_ = fmt::format("it has no metric '{}' among those that it says it has", name);
  } else {
    return true;
  }
  return false;
}

/// What it throws would cross a function in C.
int ForeignHost::count_overdraw(const std::uint32_t* order, std::uint64_t* shaded, std::uint64_t* visible) noexcept {
  if (overdraw_ == nullptr) return FOREDRAW_MISTAKE;
  try {
    if (order != nullptr && !is_permutation({order, overdraw_->triangle_count()}, overdraw_->triangle_count())) {
      return FOREDRAW_NO_ORDER;
    }
    const OverdrawCount count = overdraw_->count(order);
    if (run_.cancelled()) return FOREDRAW_CANCELLED;
    if (shaded != nullptr) *shaded = count.shaded;
    if (visible != nullptr) *visible = count.visible;
    return FOREDRAW_DONE;
  } catch (const std::bad_alloc&) {
    return FOREDRAW_NO_MEMORY;
  } catch (const std::exception& problem) {
    failure_ = fmt::format("its overdraw can not be counted: {}", problem.what());
  } catch (...) {
    failure_ = "its overdraw can not be counted";
  }
  return run_.cancelled() ? FOREDRAW_CANCELLED : FOREDRAW_FAILED;
}

void ForeignHost::note(const char* code, const char* message) {
  if (++notes_ <= most_notes) run_.note(text_from_c(code), text_from_c(message));
}

}  // namespace foredraw
