#include "crowd_pipelines.h"

#include <foredraw/displaced/tessellation_pattern.h>

#include <algorithm>

namespace foredraw {

namespace {

TessellationSpacing spacing_of(foredraw_spacing spacing) {
  constexpr TessellationSpacing all[] = {TessellationSpacing::equal, TessellationSpacing::fractional_odd,
                                         TessellationSpacing::fractional_even};
  return all[static_cast<int>(spacing)];
}

/// Of all attributes of a vertex.
std::uint64_t stored_bytes(const Level& level) {
  std::uint64_t sum = 0;
  for (const VertexStream& stream : level.vertices->base) sum += stream.format.bytes;
  return sum;
}

/// How often vertices of one draw are fetched in a pass, where its triangles are divided.
std::uint64_t fetches(const CrowdLevel& row, const CrowdLevel& plain, foredraw_spacing spacing,
                      CrowdFetching fetching) {
  const bool is_divided = row.kind == CrowdClass::tessellated && row.triangles != plain.triangles;
  if (!is_divided || fetching == CrowdFetching::by_patch) return row.vertices;
  const auto level = static_cast<float>(row.number);
  const std::uint64_t points = tessellation_counts({{level, level, level}, level}, spacing_of(spacing)).points;
  return 3 * points * plain.triangles;
}

PipelineCost cost_of(CrowdPipeline pipeline, const CrowdLevel& row, std::uint64_t fetches, std::uint64_t stored,
                     std::uint64_t passes) {
  PipelineCost cost;
  cost.triangles = passes * row.triangles;
  if (pipeline == CrowdPipeline::plain || pipeline == CrowdPipeline::single_pass) {
    cost.posed = passes * fetches;
    cost.fetched = passes * fetches * stored;
    return cost;
  }
  const std::uint64_t bytes = pipeline == CrowdPipeline::packed ? packed_bytes : posed_bytes;
  cost.posed = row.vertices;
  cost.written = row.vertices * bytes;
  cost.fetched = row.vertices * stored + passes * fetches * bytes;
  return cost;
}

}  // namespace

void PipelineCost::add(const PipelineCost& other, std::uint64_t times) {
  triangles += times * other.triangles;
  posed += times * other.posed;
  written += times * other.written;
  fetched += times * other.fetched;
}

std::array<std::vector<PipelineCost>, 4> pipeline_costs(const Scene& scene, const CrowdLevels& levels,
                                                        const Crowd& crowd, CrowdFetching fetching, int passes) {
  std::array<std::vector<PipelineCost>, 4> costs;
  for (auto& of : costs) of.resize(crowd.levels.size());
  for (const CrowdLevels::OfDraw& draw : levels.draws) {
    if (std::ranges::find(crowd.draws, draw.draw) == crowd.draws.end()) continue;
    const CrowdLevel& plain = *std::ranges::find(draw.levels, CrowdClass::plain, &CrowdLevel::kind);
    for (std::size_t l = 0; l < draw.levels.size(); ++l) {
      for (const CrowdPipeline pipeline : all_crowd_pipelines) {
        const CrowdLevel& row = pipeline == CrowdPipeline::plain ? plain : draw.levels[l];
        const std::size_t level = row.kind == CrowdClass::simplified ? row.number : 0;
        const std::uint64_t stored = stored_bytes(scene.draws[draw.draw].level(level));
        costs[static_cast<std::size_t>(pipeline)][l].add(
            cost_of(pipeline, row, fetches(row, plain, levels.spacing, fetching), stored,
                    static_cast<std::uint64_t>(passes)),
            1);
      }
    }
  }
  return costs;
}

}  // namespace foredraw
