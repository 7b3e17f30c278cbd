#include <foredraw/pipeline/stage_runner.h>

#include <foredraw/analysis/placements.h>
#include <foredraw/base/random.h>
#include <foredraw/pipeline/answers.h>
#include <foredraw/pipeline/changed_tables.h>
#include <foredraw/pipeline/eligible.h>
#include <foredraw/pipeline/stage_book.h>
#include <foredraw/pipeline/stage_levels.h>
#include <foredraw/pipeline/stage_products.h>

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

namespace foredraw {

namespace {

/// What came of one of them: an answer, a reason why there is nothing to gain, or, with neither, a failure.
template <class Answer>
struct Outcome {
  std::optional<Answer> answer;
  std::string failure;
  Findings findings;

  bool kept() const { return findings.nothing_to_gain.has_value(); }
  bool failed() const { return !answer && !kept(); }
};

struct Measurement {};  // the answer of who only measures

/// Loops that end with the next of their tasks where the run is cancelled, so that a technique need not look before
/// each of them.
Executor ending_with(const Executor& executor, const std::atomic<bool>* cancel) {
  if (cancel == nullptr) return executor;
  return Executor(executor.threads(),
                  [&executor, cancel](std::size_t count, const std::function<void(std::size_t)>& task) {
                    executor.for_each(count, [&](std::size_t i) {
                      if (cancel->load(std::memory_order_relaxed)) throw std::runtime_error("cancelled");
                      task(i);
                    });
                  });
}

class StageRunner {
 public:
  StageRunner(const PlannedStage& stage, std::size_t number, Scene& scene, const Scene& original, const Plan& plan,
              const Surroundings& surroundings, StageRecord& record, Diagnostics& diagnostics)
      : stage_(stage),
        number_(number),
        scene_(scene),
        original_(original),
        plan_(plan),
        surroundings_(surroundings),
        executor_(ending_with(surroundings.executor, surroundings.cancel)),
        record_(record),
        book_(stage, number, plan, scene, record, diagnostics),
        products_(plan.products, record),
        chosen_(stage, scene, plan.products) {
    if (surroundings.progress) progress_ = [this](double part) { surroundings_.progress(stage_.label, part); };
    for (const LevelSkip& skip : chosen_.skips()) book_.skip(skip.why.code, skip.why.reason, name_of(skip.at));
  }

  std::vector<Measured> run() {
    const bool may_change = stage_.plugin->kind != Kind::evaluator;
    const Scene before = may_change && !scene_.products.empty() ? scene_ : Scene();
    std::visit([this](const auto& technique) { run(*technique); }, *stage_.technique);
    if (may_change) products_.settle(before, scene_);
    return std::move(book_.measured());
  }

 private:
  // --- the shapes ---------------------------------------------------------------------------------------------------

  void run(const DrawOrderer& technique) {
    const int cache_size = technique.cache_size();
    auto outcomes = over_draws<Draw>([&](const DrawView& draw, Run& run, Outcome<Draw>& outcome) {
      const RangedScene* ranges = chosen_.ranges_at(run.about.level);
      const IndexOrder order = ranges ? order_of(technique, draw.id, *ranges, run) : technique.order(draw, run);
      if (!run.keeps()) outcome.answer = ordered(draw, order, cache_size, run.analyses);
    });
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const auto [id, level] = chosen_.levels()[i];
      // An order that could not be bettered for this cache is as good as made for it.
      IndexStream& stream = scene_.draws[id].levels[level].stream();
      if (outcomes[i].kept() && cache_size > 0) stream.cache_size = static_cast<std::uint16_t>(cache_size);
    }
    accept_draws(std::move(outcomes));
  }

  void run(const Clusterer& technique) {
    accept_draws(over_draws<Draw>([&](const DrawView& draw, Run& run, Outcome<Draw>& outcome) {
      const RangedScene* ranges = chosen_.ranges_at(run.about.level);
      outcome.answer =
          clustered(draw, ranges ? clusters_of(technique, draw.id, *ranges, run) : technique.cluster(draw, run));
    }));
  }

  void run(const DrawProcessor& technique) {
    accept_draws(over_draws<Draw>([&](const DrawView& draw, Run& run, Outcome<Draw>& outcome) {
      Draw changed = technique.process(draw, run);
      if (run.keeps()) return;
      if (stage_.plugin->card.lossless) certify(draw.draw(), changed, run.analyses);
      outcome.answer = std::move(changed);
    }));
  }

  void run(const SubjectOrderer& technique) {
    const std::vector<Subject> subjects = subjects_of(scene_, plan_.pipeline.subjects.subject);
    const std::vector<SubjectLevel> parts = chosen_.of(subjects);
    const PartGroups groups(scene_, subjects, [&](DrawId id) { return may_change_places(id); });
    auto outcomes = over<OrderedSubject>(
        parts.size(), [&](std::size_t i) { return About{.subject = parts[i].subject, .level = parts[i].level}; },
        [&](std::size_t i, Run& run, Outcome<OrderedSubject>& outcome) {
          SubjectView view{chosen_.scene_at(parts[i].level), subjects[parts[i].subject], parts[i].draws};
          if (parts[i].level == 0) view.groups = groups.of(parts[i].subject);
          if (view.draws.empty()) return run.keep("none of its draws may be reordered");
          const RangedScene* ranges = chosen_.ranges_at(run.about.level);
          if (parts[i].level == 0 && !ranges) view.free_groups = free_groups(view.subject, view.draws);
          SubjectOrders orders = ranges ? orders_of(technique, view, *ranges, run) : technique.order(view, run);
          if (!run.keeps()) outcome.answer = ordered(view, std::move(orders), run.analyses);
        });
    ChangedTables tables(scene_);
    std::vector<std::vector<SubjectPart>> sequences;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string& name = subjects[parts[i].subject].name;
      if (parts[i].draws.empty() && chosen_.skips_all_of(subjects[parts[i].subject])) continue;
      accept(outcomes[i], parts[i].level == 0 ? name : fmt::format("{} (level {})", name, parts[i].level));
      if (outcomes[i].answer && !outcomes[i].answer->sequence.empty())
        sequences.push_back(outcomes[i].answer->sequence);
      if (outcomes[i].answer) tables.put(std::move(*outcomes[i].answer), parts[i].level);
      for (DrawId id : parts[i].draws) update_traits(scene_.draws[id], parts[i].level, outcomes[i]);
    }
    put_in_sequence(scene_, sequences);
    tables.settle(products_);
  }

  void run(const VertexOrderer& technique) {
    std::vector<VertexGroup> groups = vertex_groups(scene_);
    for (const HeldDraw& held : keep_groups_of(groups, chosen_.draws())) {
      book_.skip("shared-vertices",
                 "it shares its vertices with " + scene_.draws[held.by].name + ", which stays as it is",
                 scene_.draws[held.draw].name);
    }
    using Users = std::vector<std::pair<VertexGroup::User, Draw>>;
    auto outcomes = over<Users>(
        groups.size(), [&](std::size_t i) { return about_of(groups[i].users.front()); },
        [&](std::size_t i, Run& run, Outcome<Users>& outcome) {
          const VertexUse use{*groups[i].vertices, index_streams_of(scene_, groups[i])};
          const VertexOrder order = technique.order(use, run);
          if (!run.keeps()) outcome.answer = renumbered(scene_, groups[i], order, run.analyses);
        });
    for (std::size_t i = 0; i < groups.size(); ++i) {
      accept(outcomes[i], name_of(groups[i].users.front()));
      if (outcomes[i].answer) {
        for (auto& [user, draw] : *outcomes[i].answer) {
          scene_.draws[user.draw].levels[user.level] = std::move(draw.levels[user.level]);
        }
      }
      for (const VertexGroup::User& user : groups[i].users) {
        update_traits(scene_.draws[user.draw], user.level, outcomes[i]);
      }
    }
  }

  void run(const Processor& technique) {
    std::vector<DrawId> worked_on;
    auto outcomes = over<Scene>(
        1, [](std::size_t) { return About{}; },
        [&](std::size_t, Run& run, Outcome<Scene>& outcome) {
          Scene changed = scene_;
          worked_on = technique.process(changed, chosen_.draws(), run);
          if (run.keeps()) return;
          if (stage_.plugin->card.lossless) {
            if (changed.draws.size() != scene_.draws.size())
              throw std::runtime_error("it is lossless, but changed the number of draws");
            for (DrawId id : chosen_.draws()) certify(scene_.draws[id], changed.draws[id], run.analyses);
            if (const std::string other = placement_difference(scene_, changed); !other.empty())
              throw std::runtime_error(other);
          }
          must_be_left(changed);
          products_.prove(scene_, changed);
          outcome.answer = std::move(changed);
        });
    accept(outcomes[0], "", outcomes[0].answer ? *outcomes[0].answer : scene_);
    if (outcomes[0].answer) scene_ = std::move(*outcomes[0].answer);
    for (DrawId id : worked_on) {
      if (id >= scene_.draws.size()) continue;
      for (std::size_t level = 0; level < scene_.draws[id].levels.size(); ++level) {
        update_traits(scene_.draws[id], level, outcomes[0]);
      }
    }
  }

  void run(const Evaluator& technique) {
    auto outcomes = over<Measurement>(
        1, [](std::size_t) { return About{}; },
        [&](std::size_t, Run& run, Outcome<Measurement>& outcome) {
          technique.evaluate(scene_, run);
          outcome.answer.emplace();
        });
    accept(outcomes[0], "");
  }

  void run(const DrawEvaluator& technique) {
    auto outcomes = over_draws<Measurement>([&](const DrawView& draw, Run& run, Outcome<Measurement>& outcome) {
      technique.evaluate(draw, run);
      outcome.answer.emplace();
    });
    for (std::size_t i = 0; i < outcomes.size(); ++i) accept(outcomes[i], name_of(chosen_.levels()[i]));
  }

  // --- the loop that they share -------------------------------------------------------------------------------------

  template <class Answer, class AboutOf, class Task>
  std::vector<Outcome<Answer>> over(std::size_t count, AboutOf about_of, Task task) {
    record_.candidates = count;
    std::vector<Outcome<Answer>> outcomes(count);
    surroundings_.executor.for_each(count, [&](std::size_t i) {
      Outcome<Answer>& outcome = outcomes[i];
      Run run{.analyses = surroundings_.analyses,
              .executor = executor_,
              .findings = outcome.findings,
              .views = plan_.views,
              .poses = plan_.poses,
              .overdraw = stage_.plugin->card.uses_overdraw ? plan_.overdraw.get() : nullptr,
              .seed = seed_of(about_of(i)),
              .about = about_of(i),
              .cancel = surroundings_.cancel,
              .progress = count == 1 ? progress_ : nullptr,
              .loans = plan_.loans,
              .subjects = plan_.pipeline.subjects.subject,
              .original = stage_.plugin->kind == Kind::evaluator ? &original_ : nullptr,
              .products = plan_.products};
      try {
        if (run.cancelled()) throw std::runtime_error("cancelled");
        task(i, run, outcome);
      } catch (const std::bad_alloc&) {
        throw;  // no fault of the stage's: whatever comes next would lack the memory too
      } catch (const std::exception& problem) {
        outcome = {.failure = problem.what()};
      } catch (...) {
        outcome = {.failure = "it threw something that is not a std::exception"};
      }
    });
    return outcomes;
  }

  /// Not of the number among those that are worked on, so that a draw's seed does not hang on what else is skipped.
  std::uint64_t seed_of(const About& about) const {
    const std::uint64_t id = about.draw.value_or(about.subject.value_or(0));
    return derive_seed(static_cast<std::uint64_t>(plan_.pipeline.seed), number_,
                       id + (std::uint64_t{about.level} << 32));
  }

  template <class Answer, class Task>
  std::vector<Outcome<Answer>> over_draws(Task task) {
    if (chosen_.levels().size() > chosen_.draws().size()) record_.loops_over = "levels of draws";
    return over<Answer>(
        chosen_.levels().size(), [&](std::size_t i) { return about_of(chosen_.levels()[i]); },
        [&](std::size_t i, Run& run, Outcome<Answer>& outcome) {
          task(DrawView{chosen_.scene_at(chosen_.levels()[i].level), chosen_.levels()[i].draw}, run, outcome);
        });
  }

  template <class Answer>
  void accept(Outcome<Answer>& outcome, const std::string& place) {
    accept(outcome, place, scene_);
  }

  /// `changed`: the scene with the draws that the stage added.
  template <class Answer>
  void accept(Outcome<Answer>& outcome, const std::string& place, const Scene& changed) {
    book_.found(outcome.findings, place, changed);
    if (outcome.answer) {
      book_.changed_one();
    } else if (outcome.kept()) {
      book_.skip("nothing-to-gain", *outcome.findings.nothing_to_gain, place);
    } else {
      book_.failed(outcome.failure, place);
    }
  }

  void accept_draws(std::vector<Outcome<Draw>> outcomes) {
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      Draw& draw = scene_.draws[chosen_.levels()[i].draw];
      accept(outcomes[i], name_of(chosen_.levels()[i]));
      if (outcomes[i].answer) put_level(draw, chosen_.levels()[i].level, std::move(*outcomes[i].answer));
      update_traits(draw, chosen_.levels()[i].level, outcomes[i]);
    }
  }

  /// What stays as it was has what the stage provides, and loses nothing that it had.
  template <class Answer>
  void update_traits(Draw& draw, std::size_t level, const Outcome<Answer>& outcome) const {
    const Card& card = stage_.plugin->card;
    Level& changed = draw.levels[level];
    if (!outcome.answer) {
      if (outcome.kept()) changed.made.add(card.provides);
      return;
    }
    // Torn clusters are gone already, and with them the trait.
    changed.made = after_stage(card, std::move(changed.made));
    draw.traits.remove(card.breaks);
    for (IndexStream& stream : changed.orders) {
      if (!changed.made.has(traits::clustered)) stream.clusters.reset();
    }
  }

  /// Products may name a draw by its number in its mesh, so nothing moves beside them.
  bool may_change_places(DrawId id) const {
    return scene_.products.empty() && std::ranges::binary_search(chosen_.draws(), id);
  }

  /// Draws that a processor was not given have the same handles afterwards.
  void must_be_left(const Scene& changed) const {
    for (DrawId id = 0; id < std::min(scene_.draws.size(), changed.draws.size()); ++id) {
      if (std::ranges::binary_search(chosen_.draws(), id) || has_same_handles(scene_.draws[id], changed.draws[id]))
        continue;
      throw std::runtime_error(fmt::format("it changed {}, which it was not given", scene_.draws[id].name));
    }
  }

  std::string name_of(const DrawLevel& at) const { return foredraw::name_of(scene_.draws[at.draw], at.level); }
  static About about_of(const DrawLevel& at) { return {.draw = at.draw, .level = at.level}; }

  const PlannedStage& stage_;
  std::size_t number_;
  Scene& scene_;
  const Scene& original_;
  const Plan& plan_;
  const Surroundings& surroundings_;
  const Executor executor_;
  StageRecord& record_;
  StageBook book_;
  StageProducts products_;
  const StageLevels chosen_;
  std::function<void(double)> progress_;
};

}  // namespace

std::vector<Measured> run_stage(const PlannedStage& stage, std::size_t number, Scene& scene, const Scene& original,
                                const Plan& plan, const Surroundings& surroundings, StageRecord& record,
                                Diagnostics& diagnostics) {
  return StageRunner(stage, number, scene, original, plan, surroundings, record, diagnostics).run();
}

}  // namespace foredraw
