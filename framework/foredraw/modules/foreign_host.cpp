#include <foredraw/modules/foreign_host.h>

#include <foredraw/modules/foreign_technique.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

constexpr std::size_t most_notes = 100;

}  // namespace

ForeignHost::ForeignHost(Run& run, const std::vector<Metric>& metrics)
    : run_(run),
      metrics_(metrics),
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
                 }} {}

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

void ForeignHost::note(const char* code, const char* message) {
  if (++notes_ <= most_notes) run_.note(text_from_c(code), text_from_c(message));
}

}  // namespace foredraw
