#include <foredraw/cache/kept_milestones.h>

#include <foredraw/cache/stored_scene.h>
#include <foredraw/cache/stored_steps.h>
#include <foredraw/platform/thread_clock.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

// What keeping costs, about: for an entry and its list, and for each byte that is hashed and written.
constexpr double seconds_an_entry = 0.001, seconds_a_byte = 2.5e-9;

enum Content : std::size_t { measures, stages, scene, contents };

/// Nothing where the entry is none, or is damaged.
std::optional<Milestone> milestone_in(const Cache::Entry& entry, std::size_t behind, bool has_measures,
                                      const Scene& input, const ProductRows& rows) {
  if (entry.size() != contents) return std::nullopt;
  const auto steps_in = [&](Content content) {
    const auto bytes = entry.read(content);
    if (!bytes) throw std::runtime_error("it is damaged");
    return restored_steps(*bytes);
  };
  try {
    Milestone milestone;
    if (has_measures) milestone.measures = steps_in(measures);
    milestone.stages = steps_in(stages);
    const auto bytes = entry.read(scene);
    if (!bytes || milestone.stages.size() != behind) return std::nullopt;
    milestone.scene = restored_scene(*bytes, input, rows);
    return milestone;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace

Work KeptMilestones::work_behind(std::size_t stages) const {
  const std::string kind = surroundings_.input.extension().string();  // that decides who reads it
  const Stamp how = combine(std::vector{surroundings_.keys.stages[stages - 1], content_hash(std::span(kind))});
  return {how, surroundings_.input, {}};
}

std::optional<Milestone> KeptMilestones::furthest(const Plan& plan, const Scene& input) {
  input_ = input;
  kept_last_ = thread_seconds();
  std::vector<Work> works;
  for (std::size_t behind = 1; behind < plan.stages.size(); ++behind) works.push_back(work_behind(behind));
  const std::vector<FileRead> read = surroundings_.own->all();
  const auto file = std::ranges::find(read, surroundings_.input, &FileRead::path);
  if (file == read.end() || file->found != FileRead::Found::content) return std::nullopt;
  Diagnostics damaged;
  const auto found = find_last_result(surroundings_.cache, works, file->stamp, damaged);
  std::optional<Milestone> milestone;
  if (found) {
    const bool has_measures = found->result.entry.about() == to_text(surroundings_.keys.measures);
    milestone = milestone_in(found->result.entry, found->number + 1, has_measures, input, plan.products);
    if (milestone) {
      read_before_ = found->result.own;
    } else {
      tell_damaged(surroundings_.cache.place_of(found->result.key), damaged);
    }
  }
  surroundings_.damaged(damaged);
  return milestone;
}

std::string KeptMilestones::reached(const Plan& plan, const Milestone& milestone) {
  const double taken = thread_seconds() - kept_last_;
  if (taken < surroundings_.least_gain * seconds_an_entry) return {};
  auto stored = stored_scene(milestone.scene, input_, plan.products);
  if (auto* why = std::get_if<std::string>(&stored)) return std::move(*why);
  const auto& bytes = std::get<std::vector<std::byte>>(stored);
  const double cost = seconds_an_entry + seconds_a_byte * static_cast<double>(bytes.size());
  if (taken < surroundings_.least_gain * cost) return {};
  const std::vector<std::byte> of_input = stored_steps(milestone.measures), behind = stored_steps(milestone.stages);
  const std::vector<std::span<const std::byte>> parts{of_input, behind, bytes};
  const std::vector<FileRead> lent = surroundings_.lent ? surroundings_.lent->all() : std::vector<FileRead>();
  surroundings_.not_kept(keep_result(surroundings_.cache, work_behind(milestone.stages.size()),
                                     {joined(surroundings_.own->all(), read_before_), lent}, false,
                                     to_text(surroundings_.keys.measures), parts));
  kept_last_ = thread_seconds();
  return {};
}

}  // namespace foredraw
