#include <foredraw/report/private/attachment_json.h>
#include <foredraw/report/private/json_writer.h>
#include <foredraw/report/report.h>

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

Json to_json(const std::vector<AttachmentRecord>& attachments) {
  Json json = Json::array();
  for (const AttachmentRecord& attachment : attachments) json.push_back(json_of(attachment));
  return json;
}

Json to_json(const StageRecord& stage) {
  Json skipped = Json::array();
  for (const SkipRecord& skip : stage.skipped) {
    skipped.push_back({{"code", skip.code}, {"reason", skip.reason}, {"places", skip.about}});
  }
  Json notes = Json::array();
  for (const NoteRecord& note : stage.notes) {
    notes.push_back({{"place", note.about}, {"code", note.code}, {"message", note.message}});
  }
  Json json{{"use", stage.use},
            {"text", stage.text},
            {"kind", to_text(stage.kind)},
            {"seconds", stage.seconds},
            {"places", stage.loops_over},
            {"changed", stage.changed},
            {"candidates", stage.candidates},
            {"skipped", skipped},
            {"notes", notes}};
  if (stage.from_cache) json["cached"] = true;
  if (!stage.rounds.empty()) json["rounds"] = stage.rounds;
  if (stage.memory) json["memory"] = *stage.memory;
  if (!stage.attachments.empty()) json["attachments"] = to_json(stage.attachments);
  if (!stage.attachments_before.empty()) json["before"]["attachments"] = to_json(stage.attachments_before);
  return json;
}

Json to_json(const std::vector<StageRecord>& stages) {
  Json json = Json::array();
  for (const StageRecord& stage : stages) json.push_back(to_json(stage));
  return json;
}

Json to_json(const FileRecord& file) {
  Json json{{"path", file.path}, {"bytes", file.bytes}};
  if (!file.hash.empty()) json["hash"] = file.hash;
  return json;
}

Json to_json(const ModuleFile& module) {
  return {{"path", module.path},     {"bytes", module.bytes},     {"hash", module.hash},
          {"vendor", module.vendor}, {"version", module.version}, {"runs", module.is_inside ? "inside" : "apart"}};
}

}  // namespace

void write_json(const Report& report, const std::function<void(std::string_view)>& put) {
  JsonWriter out(put);
  out.begin('{');
  Json head{{"report", report_version}, {"command", report.command}, {"input", to_json(report.input)}};
  if (!report.output.path.empty()) head["output"] = to_json(report.output);
  for (const FileRecord& file : report.named) head["named"].push_back(to_json(file));
  for (const ModuleFile& module : report.modules) head["modules"].push_back(to_json(module));
  head["pipeline"] = report.pipeline;
  head["seed"] = report.seed;
  head["threads"] = report.threads;
  head["machine"] = report.machine;
  head["seconds"] = report.seconds;
  head["peak-memory"] = report.peak_memory;
  for (const auto& [name, value] : head.items()) out.key(name).tree(value);
  out.key("totals").begin('{');
  write(out, report.after, report.before, report.optimized);
  out.end('}');
  Json evaluators = Json::object();
  for (const auto& [name, options] : report.evaluator_options) {
    Json& values = evaluators[name]["options"] = Json::object();
    for (const auto& [option, value] : options) values[option] = json_of(value);
  }
  out.key("evaluators").tree(evaluators);
  out.key("draws").begin('[');
  for (const DrawRecord& draw : report.draws) write(out, draw, report.optimized);
  out.end(']');
  out.key("stages").tree(to_json(report.stages));
  out.key("measures").tree(to_json(report.measures));
  out.key("diagnostics").begin('[');
  for (const Diagnostic& diagnostic : report.diagnostics) out.tree(json_of(diagnostic));
  out.end(']');
  out.end('}');
  out.finish();
}

std::string to_json(const Report& report) {
  std::string text;
  write_json(report, [&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace foredraw
