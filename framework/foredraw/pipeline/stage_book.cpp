#include <foredraw/pipeline/stage_book.h>

#include <foredraw/scene/levels.h>
#include <foredraw/scene/subject.h>

#include <fmt/format.h>

#include <utility>

namespace foredraw {

void StageBook::skip(const std::string& code, const std::string& reason, const std::string& place) {
  for (SkipRecord& skip : record_.skipped) {
    if (skip.code == code && skip.reason == reason) return skip.about.push_back(place);
  }
  record_.skipped.push_back({code, reason, {place}});
}

void StageBook::failed(const std::string& why, const std::string& place) {
  diagnostics_.error({.file = scene_.name, .inside = place}, "stage-failed",
                     fmt::format("stage {} '{}' failed: {}", number_, stage_.plugin->card.name, why),
                     stage_.plugin->kind == Kind::evaluator ? "its figures are left out; the run continues"
                                                            : "this stage leaves it unchanged; the run continues");
}

void StageBook::found(Findings& findings, const std::string& place, const Scene& changed) {
  for (Measured& measured : findings.measured) measured_.push_back(std::move(measured));
  const auto name_at = [&](const About& at) {
    const Scene& scene = *at.draw < scene_.draws.size() ? scene_ : changed;
    return *at.draw < scene.draws.size() ? name_of(scene.draws[*at.draw], at.level) : "";
  };
  const auto place_of = [&](const About& at) { return at.draw ? name_at(at) : at == About{} ? "" : place; };
  for (Note& note : findings.notes) {
    record_.notes.push_back({place_of(note.about), std::move(note.code), std::move(note.message)});
  }
  for (Attached& attached : findings.attached) {
    const About& at = attached.about;
    record_.attachments.push_back(
        {at.subject && place.empty() ? name_of_subject(*at.subject) : place_of(at), std::move(attached.content)});
  }
}

std::string StageBook::name_of_subject(std::uint32_t number) const {
  const std::vector<Subject> subjects = subjects_of(scene_, plan_.pipeline.subjects.subject);
  return number < subjects.size() ? subjects[number].name : "";
}

}  // namespace foredraw
