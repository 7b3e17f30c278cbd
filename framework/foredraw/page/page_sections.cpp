#include <foredraw/page/private/page_sections.h>

#include <foredraw/page/private/page_parts.h>

#include <algorithm>

namespace foredraw {

namespace {

std::string stage_row(const StageRecord& stage) {
  const auto [least, most] = stage.rounds.empty() ? std::ranges::minmax_result<double>{stage.seconds, stage.seconds}
                                                  : std::ranges::minmax(stage.rounds);
  const std::string spread = stage.rounds.empty()
                                 ? element("td", "-", "class=\"number\"")
                                 : element("td", fmt::format("{:.2f} to {:.2f} ms", 1000 * least, 1000 * most),
                                           fmt::format("class=\"number\" data-value=\"{}\"", most - least));
  const std::string memory = !stage.memory
                                 ? element("td", "-", "class=\"number\"")
                                 : element("td", fmt::format("{:.1f} MB", static_cast<double>(*stage.memory) / 1e6),
                                           fmt::format("class=\"number\" data-value=\"{}\"", *stage.memory));
  return element("tr", element("td", escaped(stage.text)) +
                           element("td", escaped(changed_text(stage)),
                                   fmt::format("class=\"number\" data-value=\"{}\"", stage.changed)) +
                           element("td", fmt::format("{:.2f} ms", 1000 * stage.seconds),
                                   fmt::format("class=\"number\" data-value=\"{}\"", stage.seconds)) +
                           spread + memory) +
         '\n';
}

std::string skips_html(const std::vector<StageRecord>& stages) {
  std::string items;
  for (const StageRecord& stage : stages) {
    for (const SkipRecord& skip : stage.skipped) {
      const bool is_scene = skip.about.size() == 1 && skip.about[0].empty();
      const std::string places = is_scene                ? "the scene"
                                 : skip.about.empty()    ? "everything"
                                 : skip.about.size() > 5 ? fmt::format("{} {}", skip.about.size(), stage.loops_over)
                                                         : fmt::format("{}", fmt::join(skip.about, ", "));
      items += element("li", escaped(fmt::format("{} left {} alone: {}", stage.use, places, skip.reason))) + '\n';
    }
    for (const NoteRecord& note : stage.notes) {
      items +=
          element("li", escaped(stage.use + (note.about.empty() ? "" : " on " + note.about) + ": " + note.message)) +
          '\n';
    }
  }
  return items.empty() ? "" : element("ul", '\n' + items, "class=\"skipped\"") + '\n';
}

std::string stages_of(const Comparison& comparison) {
  std::string html;
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    const Branch& branch = comparison.branches[i];
    if (branch.is_lost) continue;
    html += element("h4", number_of(i) + ' ' + element("code", escaped(branch.name))) + '\n';
    std::string rows;
    for (const StageRecord& stage : branch.report.stages) rows += stage_row(stage);
    const std::string heads = element("th", "stage") + element("th", "changed", "class=\"number\"") +
                              element("th", "time", "class=\"number\"") + element("th", "spread", "class=\"number\"") +
                              element("th", "memory", "class=\"number\"");
    html += rows.empty() ? element("p", "No stages.") : table(heads, rows, "stages");
    html += skips_html(branch.report.stages) + skips_html(branch.report.measures);
  }
  return html;
}

}  // namespace

std::string stages_html(std::span<const Comparison> comparisons) { return articles(comparisons, stages_of); }

namespace {

std::string diagnostics_of(const Comparison& comparison) {
  std::string items;
  for (const Diagnostic& diagnostic : comparison.diagnostics) {
    items +=
        element("li", escaped(to_text(diagnostic)), fmt::format("class=\"{}\"", to_text(diagnostic.severity))) + '\n';
  }
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    for (const Diagnostic& diagnostic : comparison.branches[i].report.diagnostics) {
      items += element("li", escaped(number_of(i) + ' ' + to_text(diagnostic)),
                       fmt::format("class=\"{}\"", to_text(diagnostic.severity))) +
               '\n';
    }
  }
  return items.empty() ? items : element("ul", '\n' + items);
}

bool has_diagnostics(const Comparison& comparison) {
  return !comparison.diagnostics.empty() || std::ranges::any_of(comparison.branches, [](const Branch& branch) {
    return !branch.report.diagnostics.empty();
  });
}

}  // namespace

std::string diagnostics_html(std::span<const Comparison> comparisons, std::size_t most_files) {
  const auto files = static_cast<std::size_t>(std::ranges::count_if(comparisons, has_diagnostics));
  const std::string html = articles(comparisons, diagnostics_of, most_files);
  if (files <= most_files) return html;
  const std::string more =
      fmt::format("Of {} files with messages the first {} are shown here. The JSON form has all.", files, most_files);
  return html + element("p", more, "class=\"note\"");
}

std::string pipelines_html(std::span<const Comparison> comparisons) {
  std::string html;
  const auto whole = std::ranges::find(comparisons, false, &Comparison::is_lost);
  if (whole == comparisons.end()) return html;
  const std::vector<Branch>& branches = whole->branches;  // the same on every file
  for (std::size_t i = 0; i < branches.size(); ++i) {
    html += element("details", element("summary", number_of(i) + ' ' + escaped(branches[i].name)) +
                                   element("pre", escaped(branches[i].report.pipeline))) +
            '\n';
  }
  return html;
}

std::string run_html(std::span<const Comparison> comparisons, const std::string& program) {
  std::string rows;
  const auto add = [&](std::string_view name, const std::string& value) {
    if (!value.empty()) rows += element("dt", name) + element("dd", escaped(value)) + '\n';
  };
  add("Program", program);
  for (const Comparison& comparison : comparisons) {
    const auto branch = std::ranges::find(comparison.branches, false, &Branch::is_lost);
    if (branch == comparison.branches.end()) continue;
    const Report& report = branch->report;
    add("Machine", report.machine);
    add("Threads", std::to_string(report.threads));
    add("Seed", std::to_string(report.seed));
    break;
  }
  return element("dl", '\n' + rows);
}

}  // namespace foredraw
