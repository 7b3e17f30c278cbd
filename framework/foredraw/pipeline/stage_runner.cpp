#include <foredraw/pipeline/stage_runner.h>

#include <foredraw/base/random.h>
#include <foredraw/pipeline/answers.h>
#include <foredraw/pipeline/eligible.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

/// What came of one place: an answer, a reason why there is nothing to gain, or, with neither, a failure.
template <class Answer>
struct Outcome {
  std::optional<Answer> answer;
  std::string failure;
  Findings findings;

  bool failed() const { return !answer && !findings.nothing_to_gain; }
};

struct Measurement {};  // the answer of who only measures

class StageRunner {
 public:
  StageRunner(const PlannedStage& stage, std::size_t number, Scene& scene, const Plan& plan,
              const Surroundings& surroundings, StageRecord& record, Diagnostics& diagnostics)
      : stage_(stage), number_(number), scene_(scene), plan_(plan), surroundings_(surroundings), record_(record),
        diagnostics_(diagnostics) {
    std::vector<Traits> traits;
    for (const Draw& draw : scene.draws) traits.push_back(draw.traits);
    choice_ = choose(stage, scene, traits);
    for (const Skip& skip : choice_.skips) add_skip(skip.code, skip.reason, scene.draws[skip.draw].name);
  }

  std::vector<Measured> run() {
    std::visit([this](const auto& technique) { run(*technique); }, *stage_.technique);
    return std::move(measured_);
  }

 private:
  // --- the shapes ---------------------------------------------------------------------------------------------------

  void run(DrawOrderer& technique) {
    accept_draws(over_draws<Draw>([&](const DrawView& draw, Run& run, Outcome<Draw>& outcome) {
      const IndexOrder order = technique.order(draw, run);
      if (!run.keeps()) outcome.answer = ordered(draw, order, technique.cache_size(), run.analyses);
    }));
  }

  void run(Clusterer& technique) {
    accept_draws(over_draws<Draw>([&](const DrawView& draw, Run& run, Outcome<Draw>& outcome) {
      outcome.answer = clustered(draw, technique.cluster(draw, run));
    }));
  }

  void run(DrawProcessor& technique) {
    accept_draws(over_draws<Draw>([&](const DrawView& draw, Run& run, Outcome<Draw>& outcome) {
      Draw changed = technique.process(draw, run);
      if (run.keeps()) return;
      if (stage_.plugin->card.lossless) certify(draw.draw(), changed, run.analyses);
      outcome.answer = std::move(changed);
    }));
  }

  void run(SubjectOrderer& technique) {
    const std::vector<Subject> subjects = subjects_of(scene_);
    auto outcomes = over<OrderedSubject>(subjects.size(), [](std::size_t) { return Place{}; },
                                         [&](std::size_t i, Run& run, Outcome<OrderedSubject>& outcome) {
      const SubjectView view{scene_, subjects[i], eligible_draws(subjects[i])};
      if (view.draws.empty()) return run.keep("none of its draws may be ordered anew");
      SubjectOrders orders = technique.order(view, run);
      if (!run.keeps()) outcome.answer = ordered(view, std::move(orders), run.analyses);
    });
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      if (!accept(outcomes[i], subjects[i].name)) continue;
      for (auto& [id, draw] : outcomes[i].answer->draws) {
        scene_.draws[id] = std::move(draw);
        update_traits(scene_.draws[id]);
      }
      scene_.order_tables.push_back(std::move(outcomes[i].answer->table));
    }
  }

  void run(VertexOrderer& technique) {
    std::vector<VertexGroup> groups = vertex_groups(scene_);
    std::erase_if(groups, [&](const VertexGroup& group) {
      return !std::ranges::all_of(group.users, [&](const VertexGroup::User& user) { return is_eligible(user.draw); });
    });
    using Users = std::vector<std::pair<VertexGroup::User, Draw>>;
    auto outcomes = over<Users>(
        groups.size(), [&](std::size_t i) { return Place{groups[i].users.front().draw, {}}; },
        [&](std::size_t i, Run& run, Outcome<Users>& outcome) {
          const VertexUse use{*groups[i].vertices, index_streams_of(scene_, groups[i])};
          const VertexOrder order = technique.order(use, run);
          if (!run.keeps()) outcome.answer = renumbered(scene_, groups[i], order, run.analyses);
        });
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (accept(outcomes[i], scene_.draws[groups[i].users.front().draw].name)) {
        for (auto& [user, draw] : *outcomes[i].answer) {
          scene_.draws[user.draw].levels[user.level] = std::move(draw.levels[user.level]);
          if (user.level == 0) scene_.draws[user.draw].extensions = std::move(draw.extensions);
        }
      }
      if (outcomes[i].failed()) continue;
      for (const VertexGroup::User& user : groups[i].users) update_traits(scene_.draws[user.draw]);
    }
  }

  void run(Processor& technique) {
    auto outcomes = over<Scene>(1, [](std::size_t) { return Place{}; },
                                [&](std::size_t, Run& run, Outcome<Scene>& outcome) {
      Scene changed = scene_;
      technique.process(changed, choice_.draws, run);
      if (stage_.plugin->card.lossless) {
        if (changed.draws.size() != scene_.draws.size()) throw std::runtime_error("it promised the same draws");
        for (DrawId id : choice_.draws) certify(scene_.draws[id], changed.draws[id], run.analyses);
      }
      if (!run.keeps()) outcome.answer = std::move(changed);
    });
    if (accept(outcomes[0], "")) scene_ = std::move(*outcomes[0].answer);
    if (outcomes[0].failed()) return;
    for (DrawId id : choice_.draws) {
      if (id < scene_.draws.size()) update_traits(scene_.draws[id]);
    }
  }

  void run(ImageProcessor& technique) {
    auto outcomes = over_images<Image>([&](const Image& image, Run& run, Outcome<Image>& outcome) {
      Image changed = technique.process(image, run);
      if (!run.keeps()) outcome.answer = std::move(changed);
    });
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (accept(outcomes[i], scene_.images[i].name)) scene_.images[i] = std::move(*outcomes[i].answer);
    }
  }

  void run(Evaluator& technique) {
    auto outcomes = over<Measurement>(1, [](std::size_t) { return Place{}; },
                                      [&](std::size_t, Run& run, Outcome<Measurement>& outcome) {
      technique.evaluate(scene_, run);
      outcome.answer.emplace();
    });
    accept(outcomes[0], "");
  }

  void run(DrawEvaluator& technique) {
    auto outcomes = over_draws<Measurement>([&](const DrawView& draw, Run& run, Outcome<Measurement>& outcome) {
      technique.evaluate(draw, run);
      outcome.answer.emplace();
    });
    for (std::size_t i = 0; i < outcomes.size(); ++i) accept(outcomes[i], scene_.draws[choice_.draws[i]].name);
  }

  void run(ImageEvaluator& technique) {
    auto outcomes = over_images<Measurement>([&](const Image& image, Run& run, Outcome<Measurement>& outcome) {
      technique.evaluate(image, run);
      outcome.answer.emplace();
    });
    for (std::size_t i = 0; i < outcomes.size(); ++i) accept(outcomes[i], scene_.images[i].name);
  }

  // --- the loop that they share -------------------------------------------------------------------------------------

  template <class Answer, class PlaceOf, class Task>
  std::vector<Outcome<Answer>> over(std::size_t count, PlaceOf place_of, Task task) {
    record_.candidates = count;
    std::vector<Outcome<Answer>> outcomes(count);
    surroundings_.executor.for_each(count, [&](std::size_t i) {
      Outcome<Answer>& outcome = outcomes[i];
      Run run{.analyses = surroundings_.analyses,
              .executor = surroundings_.executor,
              .findings = outcome.findings,
              .views = plan_.views,
              .overdraw = stage_.plugin->card.uses_overdraw ? plan_.overdraw.get() : nullptr,
              .seed = derive_seed(static_cast<std::uint64_t>(plan_.pipeline.seed), number_, i),
              .place = place_of(i),
              .cancel = surroundings_.cancel};
      try {
        if (run.cancelled()) throw std::runtime_error("cancelled");
        task(i, run, outcome);
      } catch (const std::exception& problem) {
        outcome = {.failure = problem.what()};
      } catch (...) {
        outcome = {.failure = "it threw something that is no std::exception"};
      }
    });
    return outcomes;
  }

  template <class Answer, class Task>
  std::vector<Outcome<Answer>> over_draws(Task task) {
    return over<Answer>(
        choice_.draws.size(), [&](std::size_t i) { return Place{choice_.draws[i], {}}; },
        [&](std::size_t i, Run& run, Outcome<Answer>& outcome) {
          task(DrawView{scene_, choice_.draws[i]}, run, outcome);
        });
  }

  template <class Answer, class Task>
  std::vector<Outcome<Answer>> over_images(Task task) {
    return over<Answer>(
        scene_.images.size(), [](std::size_t i) { return Place{{}, static_cast<ImageId>(i)}; },
        [&](std::size_t i, Run& run, Outcome<Answer>& outcome) { task(scene_.images[i], run, outcome); });
  }

  /// Books what came of a place; whether there is an answer to apply.
  template <class Answer>
  bool accept(Outcome<Answer>& outcome, const std::string& place) {
    for (Measured& measured : outcome.findings.measured) measured_.push_back(std::move(measured));
    for (Note& note : outcome.findings.notes) {
      record_.notes.push_back({note.place == Place{} ? "" : place, std::move(note.code), std::move(note.message)});
    }
    if (outcome.answer) {
      ++record_.changed;
      return true;
    }
    if (outcome.findings.nothing_to_gain) {
      add_skip("nothing-to-gain", *outcome.findings.nothing_to_gain, place);
    } else {
      diagnostics_.error({.file = scene_.name, .inside = place}, "stage-failed",
                         fmt::format("stage {} '{}' failed: {}", number_, stage_.plugin->card.name, outcome.failure),
                         "it was left as it was before this stage; the rest went on");
    }
    return false;
  }

  void accept_draws(std::vector<Outcome<Draw>> outcomes) {
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      Draw& draw = scene_.draws[choice_.draws[i]];
      if (accept(outcomes[i], draw.name)) draw = std::move(*outcomes[i].answer);
      if (!outcomes[i].failed()) update_traits(draw);
    }
  }

  void add_skip(const std::string& code, const std::string& reason, const std::string& place) {
    for (SkipRecord& skip : record_.skipped) {
      if (skip.code == code && skip.reason == reason) return skip.places.push_back(place);
    }
    record_.skipped.push_back({code, reason, {place}});
  }

  void update_traits(Draw& draw) const {
    // Torn clusters are gone already, and with them the trait.
    draw.traits = after_stage(stage_.plugin->card, std::move(draw.traits));
    for (IndexStream& stream : draw.levels[0].orders) {
      if (!draw.traits.has(traits::clustered)) stream.clusters.reset();
    }
  }

  bool is_eligible(DrawId id) const { return std::ranges::binary_search(choice_.draws, id); }

  std::vector<DrawId> eligible_draws(const Subject& subject) const {
    std::vector<DrawId> draws;
    for (const SubjectPart& part : subject.parts) {
      if (is_eligible(part.draw) && std::ranges::find(draws, part.draw) == draws.end()) draws.push_back(part.draw);
    }
    return draws;
  }

  const PlannedStage& stage_;
  std::size_t number_;
  Scene& scene_;
  const Plan& plan_;
  const Surroundings& surroundings_;
  StageRecord& record_;
  Diagnostics& diagnostics_;
  Choice choice_;
  std::vector<Measured> measured_;
};

}  // namespace

std::vector<Measured> run_stage(const PlannedStage& stage, std::size_t number, Scene& scene, const Plan& plan,
                                const Surroundings& surroundings, StageRecord& record, Diagnostics& diagnostics) {
  return StageRunner(stage, number, scene, plan, surroundings, record, diagnostics).run();
}

}  // namespace foredraw
