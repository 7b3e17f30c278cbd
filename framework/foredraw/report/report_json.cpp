#include <foredraw/report/private/json_values.h>
#include <foredraw/report/report.h>

namespace foredraw {

namespace {

Json to_json(const Figure& figure) {
  Json json{{"value", json_of(figure.value())}, {"unit", figure.unit}, {"error", json_of(figure.error)}};
  if (figure.denominator) {
    json["numerator"] = json_of(figure.numerator);
    json["denominator"] = json_of(*figure.denominator);
  }
  return json;
}

/// "models.fifo-32.acmr" as models, fifo-32, acmr. What is measured apart may have dots in its name: "poses.Walk@0.5.ratio".
std::vector<std::string> parts_of(const std::string& metric) {
  const std::size_t first = metric.find('.');
  if (first == std::string::npos) return {metric};
  const std::size_t last = metric.rfind('.');
  if (first == last) return {metric.substr(0, first), metric.substr(last + 1)};
  return {metric.substr(0, first), metric.substr(first + 1, last - first - 1), metric.substr(last + 1)};
}

/// Groups are objects.
Json to_json(const Metrics& metrics) {
  Json json = Json::object();
  for (const auto& [plugin, by_metric] : metrics.all()) {
    for (const auto& [metric, figure] : by_metric) {
      Json* at = &json[plugin];
      for (const std::string& part : parts_of(metric)) at = &(*at)[part];
      *at = to_json(figure);
    }
  }
  return json;
}

Json to_json(const StateRecord& state) {
  return {{"triangles", state.triangles}, {"vertices", state.vertices}, {"metrics", to_json(state.metrics)}};
}

Json with_before(const StateRecord& after, const StateRecord& before, bool optimized) {
  Json json = to_json(after);
  if (optimized) json["before"] = to_json(before);
  return json;
}

Json to_json(const MeshFacts& facts) {
  Json json = Json::object();
  for (const auto& [name, count] : named_counts(facts)) json[std::string(name)] = count;
  return json;
}

Json to_json(const DrawRecord& draw, bool optimized) {
  Json json{{"name", draw.name}, {"traits", std::vector<std::string>(draw.traits.begin(), draw.traits.end())}};
  json["facts"] = to_json(draw.facts);
  json.update(with_before(draw.after, draw.before, optimized));
  for (const LevelRecord& level : draw.levels) {
    Json& one = json["levels"].emplace_back(with_before(level.after, level.before, optimized));
    one["traits"] = std::vector<std::string>(level.traits.begin(), level.traits.end());
    one["error"] = json_of(level.error);
  }
  return json;
}

Json to_json(const StageRecord& stage) {
  Json skipped = Json::array();
  for (const SkipRecord& skip : stage.skipped) {
    skipped.push_back({{"code", skip.code}, {"reason", skip.reason}, {"places", skip.places}});
  }
  Json notes = Json::array();
  for (const NoteRecord& note : stage.notes) {
    notes.push_back({{"place", note.place}, {"code", note.code}, {"message", note.message}});
  }
  Json json{{"use", stage.use},         {"text", stage.text},       {"kind", to_text(stage.kind)},
            {"seconds", stage.seconds}, {"places", stage.places},   {"changed", stage.changed},
            {"candidates", stage.candidates}, {"skipped", skipped}, {"notes", notes}};
  if (!stage.rounds.empty()) json["rounds"] = stage.rounds;
  if (stage.memory) json["memory"] = *stage.memory;
  return json;
}

Json to_json(const std::vector<StageRecord>& stages) {
  Json json = Json::array();
  for (const StageRecord& stage : stages) json.push_back(to_json(stage));
  return json;
}

Json to_json(const Diagnostic& diagnostic) {
  return {{"severity", to_text(diagnostic.severity)},
          {"code", diagnostic.code},
          {"message", diagnostic.message},
          {"hint", diagnostic.hint},
          {"file", diagnostic.where.file},
          {"line", diagnostic.where.line},
          {"column", diagnostic.where.column},
          {"inside", diagnostic.where.inside}};
}

Json to_json(const FileRecord& file) { return {{"path", file.path}, {"bytes", file.bytes}}; }

}  // namespace

std::string to_json(const Report& report) {
  Json json{{"report", report_version}, {"command", report.command}, {"input", to_json(report.input)}};
  if (!report.output.path.empty()) json["output"] = to_json(report.output);
  json["pipeline"] = report.pipeline;
  json["seed"] = report.seed;
  json["threads"] = report.threads;
  json["machine"] = report.machine;
  json["seconds"] = report.seconds;
  json["peak-memory"] = report.peak_memory;

  json["totals"] = with_before(report.after, report.before, report.optimized);
  json["evaluators"] = Json::object();
  for (const auto& [name, options] : report.evaluator_options) {
    Json& values = json["evaluators"][name]["options"] = Json::object();
    for (const auto& [option, value] : options) values[option] = json_of(value);
  }
  json["draws"] = Json::array();
  for (const DrawRecord& draw : report.draws) json["draws"].push_back(to_json(draw, report.optimized));
  json["images"] = Json::array();
  for (const ImageRecord& image : report.images) {
    Json entry{{"name", image.name}, {"metrics", to_json(image.after)}};
    if (report.optimized) entry["before"] = {{"metrics", to_json(image.before)}};
    json["images"].push_back(std::move(entry));
  }
  json["stages"] = to_json(report.stages);
  json["measures"] = to_json(report.measures);
  json["diagnostics"] = Json::array();
  for (const Diagnostic& diagnostic : report.diagnostics) json["diagnostics"].push_back(to_json(diagnostic));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foredraw
