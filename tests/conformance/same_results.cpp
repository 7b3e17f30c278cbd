#include "same_results.h"

#include <algorithm>
#include <cmath>

namespace foredraw::testing {

namespace {

bool same(const Attachment& a, const Attachment& b) {
  if (a.index() != b.index() || name_of(a) != name_of(b)) return false;
  if (const auto* film = std::get_if<Film>(&a)) return film->frames == std::get<Film>(b).frames;
  const auto same_value = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  const auto same_line = [&](const Chart::Line& x, const Chart::Line& y) {
    return x.name == y.name && std::ranges::equal(x.values, y.values, same_value);
  };
  const Chart &x = std::get<Chart>(a), &y = std::get<Chart>(b);
  return std::ranges::equal(x.lines, y.lines, same_line) && x.mark.has_value() == y.mark.has_value() &&
         (!x.mark || x.mark->value == y.mark->value);
}

}  // namespace

std::vector<Stamp> content(const Scene& scene) {
  std::vector<Stamp> stamps;
  for (const Draw& draw : scene.draws) {
    for (const Level& level : draw.levels) {
      stamps.push_back(level.vertices->stamp());
      for (const IndexStream& stream : level.orders) stamps.push_back(stream.indices.stamp());
    }
  }
  return stamps;
}

std::vector<double> figures(const Result& result) {
  std::vector<double> values;
  for (const auto& [plugin, metrics] : result.report.after.metrics.all()) {
    for (const auto& [metric, figure] : metrics) {
      values.push_back(figure.numerator);
      values.push_back(figure.denominator.value_or(-1));
      values.push_back(figure.error);
    }
  }
  return values;
}

std::vector<AttachmentRecord> attachments(const Result& result) {
  std::vector<AttachmentRecord> all;
  for (const auto* records : {&result.report.stages, &result.report.measures}) {
    for (const StageRecord& record : *records) {
      all.insert(all.end(), record.attachments_before.begin(), record.attachments_before.end());
      all.insert(all.end(), record.attachments.begin(), record.attachments.end());
    }
  }
  return all;
}

bool same_attachments(const Result& a, const Result& b) {
  return std::ranges::equal(attachments(a), attachments(b), [](const AttachmentRecord& x, const AttachmentRecord& y) {
    return x.about == y.about && same(*x.content, *y.content);
  });
}

}  // namespace foredraw::testing
