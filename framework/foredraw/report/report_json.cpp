#include <foredraw/report/private/report_json.h>

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

/// What a figure says, within the object that is its own.
void write(JsonWriter& out, const Figure& figure) {
  out.key("value").value(figure.value());
  out.key("unit").value(figure.unit);
  out.key("error").value(figure.error);
  if (!figure.denominator) return;
  out.key("numerator").value(figure.numerator);
  out.key("denominator").value(*figure.denominator);
}

struct Entry {
  std::array<std::string_view, 3> parts;
  std::size_t count;  ///< of the parts
  const Figure* figure;
};

/// "models.fifo-32.acmr" as models, fifo-32, acmr. What is measured apart may have dots in its name:
/// "poses.Walk@0.5.ratio".
Entry entry_of(std::string_view metric, const Figure& figure) {
  const std::size_t first = metric.find('.');
  if (first == std::string::npos) return {{metric}, 1, &figure};
  const std::size_t last = metric.rfind('.');
  if (first == last) return {{metric.substr(0, first), metric.substr(last + 1)}, 2, &figure};
  return {{metric.substr(0, first), metric.substr(first + 1, last - first - 1), metric.substr(last + 1)}, 3, &figure};
}

/// Groups are objects, each where its first figure stands.
void write(JsonWriter& out, std::vector<Entry> entries, std::size_t part) {
  while (!entries.empty()) {
    const std::string_view name = entries.front().parts[part];
    const auto others =
        std::stable_partition(entries.begin(), entries.end(), [&](const Entry& e) { return e.parts[part] == name; });
    std::vector<Entry> group(entries.begin(), others);
    entries.erase(entries.begin(), others);
    out.key(name).begin('{');
    if (group.front().count == part + 1) {
      write(out, *group.front().figure);
      group.erase(group.begin());
    }
    if (!group.empty()) write(out, std::move(group), part + 1);
    out.end('}');
  }
}

void write(JsonWriter& out, const Metrics& metrics) {
  out.begin('{');
  for (const auto& [plugin, by_metric] : metrics.all()) {
    std::vector<Entry> entries;
    for (const auto& [metric, figure] : by_metric) entries.push_back(entry_of(metric, figure));
    out.key(plugin).begin('{');
    write(out, std::move(entries), 0);
    out.end('}');
  }
  out.end('}');
}

/// What a state says, within the object that is its own.
void write(JsonWriter& out, const StateRecord& state) {
  out.key("triangles").value(state.triangles);
  out.key("vertices").value(state.vertices);
  write(out.key("metrics"), state.metrics);
}

void write(JsonWriter& out, const StateRecord& after, const StateRecord& before, bool optimized) {
  write(out, after);
  if (!optimized) return;
  out.key("before").begin('{');
  write(out, before);
  out.end('}');
}

void write(JsonWriter& out, const Traits& traits) {
  out.key("traits").begin('[');
  for (const Trait trait : traits) out.value(trait);
  out.end(']');
}

void write(JsonWriter& out, const DrawRecord& draw, bool optimized) {
  out.begin('{');
  out.key("name").value(draw.name);
  write(out, draw.traits);
  out.key("facts").begin('{');
  for (const auto& [name, count] : named_counts(draw.facts)) out.key(name).value(count);
  out.end('}');
  write(out, draw.after, draw.before, optimized);
  if (!draw.levels.empty()) {
    out.key("levels").begin('[');
    for (const LevelRecord& level : draw.levels) {
      out.begin('{');
      write(out, level.after, level.before, optimized);
      write(out, level.traits);
      out.key("error").value(static_cast<double>(level.error));
      out.end('}');
    }
    out.end(']');
  }
  out.end('}');
}

void write(JsonWriter& out, const std::vector<AttachmentRecord>& attachments) {
  out.begin('[');
  for (const AttachmentRecord& attachment : attachments) write(out, attachment);
  out.end(']');
}

void write(JsonWriter& out, const SkipRecord& skip) {
  out.begin('{');
  out.key("code").value(skip.code);
  out.key("reason").value(skip.reason);
  out.key("places").begin('[');
  for (const std::string& place : skip.about) out.value(place);
  out.end(']');
  out.end('}');
}

void write(JsonWriter& out, const NoteRecord& note) {
  out.begin('{');
  out.key("place").value(note.about);
  out.key("code").value(note.code);
  out.key("message").value(note.message);
  out.end('}');
}

void write(JsonWriter& out, const StageRecord& stage) {
  out.begin('{');
  out.key("use").value(stage.use);
  out.key("text").value(stage.text);
  out.key("kind").value(to_text(stage.kind));
  out.key("seconds").value(stage.seconds);
  out.key("places").value(stage.loops_over);
  out.key("changed").value(stage.changed);
  out.key("candidates").value(stage.candidates);
  out.key("skipped").begin('[');
  for (const SkipRecord& skip : stage.skipped) write(out, skip);
  out.end(']');
  out.key("notes").begin('[');
  for (const NoteRecord& note : stage.notes) write(out, note);
  out.end(']');
  if (stage.from_cache) out.key("cached").value(true);
  if (!stage.rounds.empty()) {
    out.key("rounds").begin('[');
    for (const double seconds : stage.rounds) out.value(seconds);
    out.end(']');
  }
  if (stage.memory) out.key("memory").value(*stage.memory);
  if (!stage.attachments.empty()) write(out.key("attachments"), stage.attachments);
  if (!stage.attachments_before.empty()) {
    out.key("before").begin('{');
    write(out.key("attachments"), stage.attachments_before);
    out.end('}');
  }
  out.end('}');
}

void write(JsonWriter& out, const std::vector<StageRecord>& stages) {
  out.begin('[');
  for (const StageRecord& stage : stages) write(out, stage);
  out.end(']');
}

void write(JsonWriter& out, const FileRecord& file) {
  out.begin('{');
  out.key("path").value(file.path);
  out.key("bytes").value(file.bytes);
  if (!file.hash.empty()) out.key("hash").value(file.hash);
  out.end('}');
}

void write(JsonWriter& out, const ModuleFile& module) {
  out.begin('{');
  out.key("path").value(module.path);
  out.key("bytes").value(module.bytes);
  out.key("hash").value(module.hash);
  out.key("vendor").value(module.vendor);
  out.key("version").value(module.version);
  out.key("runs").value(module.is_inside ? "inside" : "apart");
  out.end('}');
}

/// What is left out where there is none.
template <class Row>
void write_any(JsonWriter& out, std::string_view key, const std::vector<Row>& rows) {
  if (rows.empty()) return;
  out.key(key).begin('[');
  for (const Row& row : rows) write(out, row);
  out.end(']');
}

void write_evaluators(JsonWriter& out, const Report& report) {
  out.begin('{');
  for (const auto& [name, options] : report.evaluator_options) {
    out.key(name).begin('{');
    out.key("options").begin('{');
    for (const auto& [option, value] : options) write(out.key(option), value);
    out.end('}');
    out.end('}');
  }
  out.end('}');
}

}  // namespace

void write(JsonWriter& out, const Report& report) {
  out.begin('{');
  out.key("report").value(report_version);
  out.key("command").value(report.command);
  write(out.key("input"), report.input);
  if (!report.output.path.empty()) write(out.key("output"), report.output);
  write_any(out, "named", report.named);
  write_any(out, "modules", report.modules);
  out.key("pipeline").value(report.pipeline);
  out.key("seed").value(report.seed);
  out.key("threads").value(report.threads);
  out.key("machine").value(report.machine);
  out.key("seconds").value(report.seconds);
  out.key("peak-memory").value(report.peak_memory);
  out.key("totals").begin('{');
  write(out, report.after, report.before, report.optimized);
  out.end('}');
  write_evaluators(out.key("evaluators"), report);
  out.key("draws").begin('[');
  for (const DrawRecord& draw : report.draws) write(out, draw, report.optimized);
  out.end(']');
  write(out.key("stages"), report.stages);
  write(out.key("measures"), report.measures);
  write(out.key("diagnostics"), report.diagnostics);
  out.end('}');
}

void write_json(const Report& report, const std::function<void(std::string_view)>& put) {
  JsonWriter out(put);
  write(out, report);
  out.finish();
}

std::string to_json(const Report& report) {
  return json_text([&](JsonWriter& out) { write(out, report); });
}

}  // namespace foredraw
