#include <foredraw/c/checked_input.h>
#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/image/found_traits.h>
#include <foredraw/io/file_lender.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/scene/triangle_draw.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace foredraw::c {

namespace {

/// What the stages of a line answer with.
enum class Answer { triangles, vertices, nothing };

Answer answer_of(const PlannedStage& stage) {
  if (std::holds_alternative<std::unique_ptr<VertexOrderer>>(*stage.technique)) return Answer::vertices;
  const bool moves_triangles = stage.plugin->kind == Kind::orderer || stage.plugin->kind == Kind::clusterer;
  return moves_triangles ? Answer::triangles : Answer::nothing;
}

/// What all stages together answer with; nothing, and a diagnostic, where that is no order.
std::optional<Answer> answer_of(const Plan& plan, bool wants_clusters, Diagnostics& diagnostics) {
  bool clusters = false;
  std::optional<Answer> all;
  for (const PlannedStage& stage : plan.stages) {
    const Answer answer = answer_of(stage);
    clusters = clusters || stage.plugin->kind == Kind::clusterer;
    if (answer == Answer::nothing || (all && *all != answer)) {
      diagnostics.error(stage.stage.where, "no-order",
                        answer == Answer::nothing
                            ? fmt::format("'{}' neither orders nor clusters triangles", stage.label)
                            : fmt::format("'{}' orders {}, the stages before it {}", stage.label,
                                          answer == Answer::vertices ? "vertices" : "triangles",
                                          answer == Answer::vertices ? "triangles" : "vertices"),
                        "make a scene of the draw, and run the stages on it");
      return std::nullopt;
    }
    all = answer;
  }
  if (wants_clusters && !clusters) {
    diagnostics.error({}, "no-clusters", "no stage clusters triangles", "put a clusterer behind the others");
    return std::nullopt;
  }
  return all.value_or(Answer::triangles);
}

/// [new] = old of so many: of origins, which are none where all is as it was.
std::vector<std::uint32_t> order_of(std::span<const std::uint32_t> origins, std::size_t count) {
  if (!origins.empty()) return {origins.begin(), origins.end()};
  std::vector<std::uint32_t> same(count);
  std::iota(same.begin(), same.end(), 0u);
  return same;
}

std::vector<std::uint32_t> inverse_of(std::span<const std::uint32_t> destination, std::size_t count) {
  std::vector<std::uint32_t> order = order_of({}, count);
  for (std::uint32_t old = 0; old < destination.size(); ++old) order[destination[old]] = old;
  return order;
}

struct Outputs {
  std::uint32_t* order = nullptr;
  std::uint32_t* offsets = nullptr;
  std::uint32_t* cluster_count = nullptr;

  bool wants_clusters() const { return cluster_count != nullptr; }
};

Scene scene_of(const CheckedTriangles& triangles, const foredraw_positions* positions) {
  std::vector<glm::vec3> places;
  if (triangles.vertex_count() > 0) {
    places = elements_at<glm::vec3>(positions->first, positions->stride, triangles.vertex_count());
  }
  const auto indices = triangles.indices();
  Scene scene;
  scene.draws.push_back(triangle_draw("draw", places, {indices.begin(), indices.end()}));
  scene.meshes.push_back({.name = "draw", .draws = {0}});
  scene.nodes.push_back({.name = "draw", .mesh = 0});
  find_traits(scene);
  return scene;
}

int run(foredraw_context& context, const char* stages, const foredraw_triangles* given,
        const foredraw_positions* positions, const Outputs& outputs, foredraw_text* report) {
  Cancellable call(context);
  const FileLender lender(context.input());
  const JobSetup setup = setup_for(call, lender);
  Job job(setup, JobKind::optimize, "");
  Diagnostics diagnostics;
  const auto report_of = [&](int status) {
    put_made([&] { return to_json(job.report()); }, report);
    return status;
  };
  const auto refuse = [&](int status) {
    job.refuse(diagnostics);
    return report_of(status);
  };
  const auto refuse_draw = [&](const std::string& why) {
    diagnostics.error({}, "bad-draw", "the draw: " + why);
    return refuse(FOREDRAW_MISTAKE);
  };
  constexpr std::uint64_t most = std::uint64_t{1} << 31;
  if (given != nullptr && given->index_count / 3 > most) {  // before memory for them is asked for
    return refuse_draw(
        fmt::format("{} triangles are too many; at most {} can be ordered", given->index_count / 3, most));
  }
  const CheckedTriangles triangles(given);
  if (triangles.status() == FOREDRAW_NULL_POINTER) return FOREDRAW_NULL_POINTER;
  if (triangles.status() != FOREDRAW_DONE) return refuse_draw(foredraw_status_text(triangles.status()));
  if (const int status = positions_status(positions, triangles.vertex_count())) return status;

  const auto pipeline = parse_line(stages, diagnostics);
  if (!pipeline) return refuse(FOREDRAW_MISTAKE);
  job.take({}, scene_of(triangles, positions));
  if (!job.plan(*pipeline)) return report_of(FOREDRAW_MISTAKE);
  const auto answer = answer_of(job.plan(), outputs.wants_clusters(), diagnostics);
  if (!answer) return refuse(FOREDRAW_MISTAKE);
  const std::size_t count = *answer == Answer::vertices ? triangles.vertex_count() : triangles.triangle_count();
  if (outputs.order == nullptr && count > 0 && !outputs.wants_clusters()) return FOREDRAW_NULL_POINTER;

  if (!job.run()) return report_of(FOREDRAW_CANCELLED);
  const Level& level = job.scene().draws.front().full();
  if (level.orders.size() != 1) {
    diagnostics.error({}, "several-orders", "the stages made several orders, of which one can be answered with",
                      "set k = 1, or make a scene of the draw");
    return refuse(FOREDRAW_MISTAKE);
  }
  const auto order = *answer == Answer::vertices ? inverse_of(level.vertex_destination.view(), count)
                                                 : order_of(level.stream().triangle_origin.view(), count);
  const bool is_as_it_was = std::ranges::is_sorted(order);
  if (outputs.order == nullptr && !is_as_it_was) return FOREDRAW_NULL_POINTER;
  std::vector<std::uint32_t> offsets = {0};
  if (count > 0) offsets.push_back(static_cast<std::uint32_t>(count));  // where the clusterer left all as it was
  if (level.stream().clusters) offsets = level.stream().clusters->offsets;
  const int status = report_of(job.status() == JobStatus::in_part ? FOREDRAW_FAILED : FOREDRAW_DONE);
  if (outputs.order != nullptr) std::ranges::copy(order, outputs.order);
  if (outputs.wants_clusters()) {
    std::ranges::copy(offsets, outputs.offsets);
    *outputs.cluster_count = static_cast<std::uint32_t>(offsets.size() - 1);
  }
  return status;
}

}  // namespace

}  // namespace foredraw::c

using namespace foredraw::c;

int foredraw_order(foredraw_context* context, const char* stages, const foredraw_triangles* triangles,
                   const foredraw_positions* positions, uint32_t* order, foredraw_text* report) {
  return at_border(report, [&]() -> int {
    if (context == nullptr || stages == nullptr) return FOREDRAW_NULL_POINTER;
    return run(*context, stages, triangles, positions, {.order = order}, report);
  });
}

int foredraw_cluster(foredraw_context* context, const char* stages, const foredraw_triangles* triangles,
                     const foredraw_positions* positions, uint32_t* order, uint32_t* offsets, uint32_t* cluster_count,
                     foredraw_text* report) {
  return at_border(report, [&]() -> int {
    const bool is_complete = context != nullptr && stages != nullptr && offsets != nullptr && cluster_count != nullptr;
    if (!is_complete) return FOREDRAW_NULL_POINTER;
    return run(*context, stages, triangles, positions, {order, offsets, cluster_count}, report);
  });
}
