#include <foredraw/report/diagnostics_json.h>
#include <foredraw/report/private/report_json.h>

#include <algorithm>

namespace foredraw {

namespace {

using foredraw::json_of;

Json json_of(const SkipRecord& skip);
Json json_of(const NoteRecord& note);
Json json_of(const StageRecord& stage);
Json json_of(const FileRecord& file);
Json json_of(const ModuleFile& module);

template <class Row>
Json list_of(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) list.push_back(json_of(row));
  return list;
}

/// Puts members of another object behind those of this one.
void add_members(Json& json, Json others) {
  for (auto& [name, value] : others.items()) json[name] = std::move(value);
}

Json json_of(const Figure& figure) {
  Json json = JsonObject{{"value", json_of(figure.value())}, {"unit", figure.unit}, {"error", json_of(figure.error)}};
  if (figure.denominator) {
    json["numerator"] = json_of(figure.numerator);
    json["denominator"] = json_of(*figure.denominator);
  }
  return json;
}

/// "models.fifo-32.acmr" as models, fifo-32, acmr. What is measured apart may have dots in its name:
/// "poses.Walk@0.5.ratio".
std::vector<std::string> parts_of(const std::string& metric) {
  const std::size_t first = metric.find('.'), last = metric.rfind('.');
  if (first == std::string::npos) return {metric};
  if (first == last) return {metric.substr(0, first), metric.substr(last + 1)};
  return {metric.substr(0, first), metric.substr(first + 1, last - first - 1), metric.substr(last + 1)};
}

/// Groups are objects, each where its first figure stands.
Json json_of(const Metrics& metrics) {
  Json json = Json::object();
  for (const auto& [plugin, by_metric] : metrics.all()) {
    Json& own = json[plugin] = Json::object();
    for (const auto& [metric, figure] : by_metric) {
      Json* at = &own;
      for (const std::string& part : parts_of(metric)) at = &(*at)[part];
      add_members(*at, json_of(figure));
    }
  }
  return json;
}

Json json_of(const StateRecord& state) {
  return JsonObject{{"triangles", state.triangles}, {"vertices", state.vertices}, {"metrics", json_of(state.metrics)}};
}

Json states_of(const StateRecord& after, const StateRecord& before, bool optimized) {
  Json json = json_of(after);
  if (optimized) json["before"] = json_of(before);
  return json;
}

Json json_of(const Traits& traits) { return std::vector<std::string>(traits.begin(), traits.end()); }

Json json_of(const DrawRecord& draw, bool optimized) {
  Json json = JsonObject{{"name", draw.name}, {"traits", json_of(draw.traits)}, {"facts", Json::object()}};
  for (const auto& [name, count] : named_counts(draw.facts)) json["facts"][std::string(name)] = count;
  add_members(json, states_of(draw.after, draw.before, optimized));
  if (draw.levels.empty()) return json;
  Json& levels = json["levels"] = Json::array();
  for (const LevelRecord& level : draw.levels) {
    Json one = states_of(level.after, level.before, optimized);
    one["traits"] = json_of(level.traits);
    one["error"] = json_of(static_cast<double>(level.error));
    levels.push_back(std::move(one));
  }
  return json;
}

Json json_of(const SkipRecord& skip) {
  return JsonObject{{"code", skip.code}, {"reason", skip.reason}, {"places", skip.about}};
}

Json json_of(const NoteRecord& note) {
  return JsonObject{{"place", note.about}, {"code", note.code}, {"message", note.message}};
}

Json json_of(const StageRecord& stage) {
  Json json = JsonObject{{"use", stage.use},
                         {"text", stage.text},
                         {"kind", to_text(stage.kind)},
                         {"seconds", json_of(stage.seconds)},
                         {"places", stage.loops_over},
                         {"changed", stage.changed},
                         {"candidates", stage.candidates},
                         {"skipped", list_of(stage.skipped)},
                         {"notes", list_of(stage.notes)}};
  if (!stage.rounds.empty()) json["rounds"] = list_of(stage.rounds);
  if (stage.memory) json["memory"] = *stage.memory;
  if (!stage.attachments.empty()) json["attachments"] = list_of(stage.attachments);
  if (!stage.attachments_before.empty()) {
    json["before"] = JsonObject{{"attachments", list_of(stage.attachments_before)}};
  }
  return json;
}

Json json_of(const FileRecord& file) {
  Json json = JsonObject{{"path", file.path}, {"bytes", file.bytes}};
  if (!file.hash.empty()) json["hash"] = file.hash;
  return json;
}

Json json_of(const ModuleFile& module) {
  return JsonObject{{"path", module.path},       {"bytes", module.bytes},
                    {"hash", module.hash},       {"vendor", module.vendor},
                    {"version", module.version}, {"runs", module.is_inside ? "inside" : "apart"}};
}

Json evaluators_of(const Report& report) {
  Json json = Json::object();
  for (const auto& [name, options] : report.evaluator_options) {
    Json& own = json[name] = JsonObject{{"options", Json::object()}};
    for (const auto& [option, value] : options) own["options"][option] = json_of(value);
  }
  return json;
}

/// All that stands before the draws.
Json head_of(const Report& report) {
  Json json = JsonObject{{"report", report_version}, {"command", report.command}, {"input", json_of(report.input)}};
  if (!report.output.path.empty()) json["output"] = json_of(report.output);
  if (!report.named.empty()) json["named"] = list_of(report.named);
  if (!report.modules.empty()) json["modules"] = list_of(report.modules);
  json["pipeline"] = report.pipeline;
  json["seed"] = report.seed;
  json["threads"] = report.threads;
  json["machine"] = report.machine;
  json["seconds"] = json_of(report.seconds);
  json["peak-memory"] = report.peak_memory;
  json["totals"] = states_of(report.after, report.before, report.optimized);
  json["evaluators"] = evaluators_of(report);
  return json;
}

/// All that stands behind them.
Json tail_of(const Report& report) {
  return JsonObject{{"stages", list_of(report.stages)},
                    {"measures", list_of(report.measures)},
                    {"diagnostics", list_of(report.diagnostics)}};
}

}  // namespace

Json json_of(const Report& report) {
  Json json = head_of(report);
  Json& draws = json["draws"] = Json::array();
  for (const DrawRecord& draw : report.draws) draws.push_back(json_of(draw, report.optimized));
  add_members(json, tail_of(report));
  return json;
}

void write_json(const Report& report, const std::function<void(std::string_view)>& put) {
  const std::string head = indented_text(head_of(report)), tail = indented_text(tail_of(report));
  put(std::string_view(head).substr(0, head.rfind('\n')));
  put(",\n  \"draws\": [");
  for (const DrawRecord& draw : report.draws) {
    put(&draw == report.draws.data() ? "\n    " : ",\n    ");
    put_indented(indented_text(json_of(draw, report.optimized)), "    ", put);
  }
  put(report.draws.empty() ? "]," : "\n  ],");
  put(std::string_view(tail).substr(1));  // without its bracket
  put("\n");
}

std::string to_json(const Report& report) {
  std::string text;
  write_json(report, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string to_json(const Diagnostics& diagnostics) {
  return indented_text(JsonObject{{"diagnostics", list_of(diagnostics.all())}}) + '\n';
}

void put_indented(std::string_view text, std::string_view indent, const std::function<void(std::string_view)>& put) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  while (!text.empty()) {
    const std::size_t line = std::min(text.find('\n'), text.size() - 1) + 1;
    put(text.substr(0, line));
    text.remove_prefix(line);
    if (!text.empty()) put(indent);
  }
}

}  // namespace foredraw
