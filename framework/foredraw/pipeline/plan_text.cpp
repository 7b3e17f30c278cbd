#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/plan.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

struct Reason {
  std::string code;
  std::string text;
  std::vector<std::string> draws;
};

std::vector<Reason> reasons(const PlannedStage& stage, const Scene& scene) {
  std::vector<Reason> all;
  for (const Skip& skip : stage.skips) {
    auto at = std::ranges::find_if(all, [&](const Reason& r) { return r.code == skip.code && r.text == skip.reason; });
    if (at == all.end()) at = all.insert(all.end(), {skip.code, skip.reason, {}});
    at->draws.push_back(scene.draws[skip.draw].name);
  }
  return all;
}

std::string stage_text(const PlannedStage& stage, const Scene& scene) {
  const Card& card = stage.plugin->card;
  std::string text = "  " + print_stage(stage.stage) + ": ";
  if (stage.left_out) return text + "skipped, " + *stage.left_out + '\n';
  text += fmt::format("{} of {} draws", stage.draws.size(), scene.draws.size());
  if (!card.pays_if.empty()) text += "; pays if " + card.pays_if;
  text += '\n';
  for (const Reason& reason : reasons(stage, scene)) {
    std::vector<std::string> shown(reason.draws.begin(),
                                   reason.draws.begin() + std::min<std::ptrdiff_t>(4, std::ssize(reason.draws)));
    text +=
        fmt::format("      leaves {}{} alone: {}\n", fmt::join(shown, ", "),
                    reason.draws.size() > 4 ? fmt::format(" and {} more", reason.draws.size() - 4) : "", reason.text);
  }
  return text;
}

Json stage_json(const PlannedStage& stage, const Scene& scene) {
  Json json{{"use", stage.label}, {"text", print_stage(stage.stage)}, {"places", stage.loops_over()}};
  json["draws"] = Json::array();
  for (DrawId id : stage.draws) json["draws"].push_back(scene.draws[id].name);
  json["skipped"] = Json::array();
  for (const Reason& reason : reasons(stage, scene)) {
    json["skipped"].push_back({{"code", reason.code}, {"reason", reason.text}, {"places", reason.draws}});
  }
  if (stage.left_out) json["unavailable"] = *stage.left_out;
  if (!stage.plugin->card.pays_if.empty()) json["pays-if"] = stage.plugin->card.pays_if;
  return json;
}

}  // namespace

std::string to_text(const Plan& plan, const Scene& scene) {
  std::string text = "stages\n";
  for (const PlannedStage& stage : plan.stages) text += stage_text(stage, scene);
  if (plan.stages.empty()) text += "  none\n";
  text += "measure\n";
  for (const PlannedStage& stage : plan.measures) text += stage_text(stage, scene);
  if (plan.measures.empty()) text += "  nothing\n";
  return text;
}

std::string to_json(const Plan& plan, const Scene& scene) {
  Json json{
      {"plan", 1}, {"pipeline", print_file(plan.pipeline)}, {"stages", Json::array()}, {"measures", Json::array()}};
  for (const PlannedStage& stage : plan.stages) json["stages"].push_back(stage_json(stage, scene));
  for (const PlannedStage& stage : plan.measures) json["measures"].push_back(stage_json(stage, scene));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foredraw
