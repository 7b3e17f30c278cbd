#include "level_model.h"

#include <foredraw/collapses/collapse_product.h>
#include <foredraw/collapses/collapse_sequences.h>
#include <foredraw/collapses/cut.h>
#include <foredraw/collapses/refine_records.h>
#include <foredraw/io/scene_file.h>

#include <plugins/processors/geomorphs/geomorph_product.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>

/// What the engine keeps of the file.
struct level_model {
  foredraw::Draw draw;
  foredraw::DrawGeomorph morph;
  foredraw::JoinedMesh mesh;  // the draw alone, so that its vertices keep their numbers
  foredraw::RefineRecords records;
  foredraw_refine_mesh refine = records.mesh();
};

namespace {

/// The first draw that becomes coarser by itself and has levels with geomorphs.
level_model* model_of(const foredraw::Scene& scene) {
  const auto* sequences = scene.products.find<foredraw::CollapseSequences>();
  const auto* geomorphs = scene.products.find<foredraw::Geomorphs>();
  if (sequences == nullptr || geomorphs == nullptr) {
    throw std::runtime_error("no sequence of collapses, or no geomorphs: keep them, as docs/reference/levels.md says");
  }
  foredraw::Analyses analyses;
  for (const foredraw::DrawsCollapse& one : sequences->meshes) {
    const auto morph = std::ranges::find(geomorphs->draws, one.draws.front(), &foredraw::DrawGeomorph::draw);
    if (one.draws.size() != 1 || morph == geomorphs->draws.end()) continue;
    auto mesh = joined_mesh(scene, one.draws, analyses);
    if (!mesh || !leaves_vertices(*one.sequence, *mesh)) continue;
    foredraw::RefineRecords records = refine_records(*one.sequence, mesh->positions, mesh->indices);
    return new level_model{scene.draws[one.draws.front()], *morph, std::move(*mesh), std::move(records)};
  }
  throw std::runtime_error("no draw has all three: a sequence of collapses whose vertices stay, levels, and geomorphs");
}

}  // namespace

level_model* level_model_load(const char* path) {
  try {
    foredraw::Diagnostics diagnostics;
    const auto file = foredraw::read_scene(path, diagnostics,
                                           {.products = {foredraw::collapse_product(), foredraw::geomorph_product()}});
    std::fprintf(stderr, "%s", foredraw::to_text(diagnostics).c_str());
    return file ? model_of(file->scene) : nullptr;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "level_walk: %s: %s\n", path, error.what());
    return nullptr;
  }
}

void level_model_free(level_model* model) { delete model; }

uint32_t level_model_vertices(const level_model* model) { return static_cast<uint32_t>(model->mesh.positions.size()); }

const float* level_model_positions(const level_model* model) { return &model->mesh.positions.front().x; }

uint32_t level_model_levels(const level_model* model) { return static_cast<uint32_t>(model->draw.levels.size()); }

model_level level_model_level(const level_model* model, uint32_t level) {
  const foredraw::Level& of = model->draw.levels[level];
  const auto& ancestors = model->morph.ancestors;
  return {static_cast<uint32_t>(of.stream().triangle_count()), of.error,
          level < ancestors.size() ? ancestors[level].view().data() : nullptr};
}

void level_model_ball(const level_model* model, float centre[3], float* radius) {
  glm::vec3 low = model->mesh.positions.front(), high = low;
  for (const glm::vec3& p : model->mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  for (int k = 0; k < 3; ++k) centre[k] = (low[k] + high[k]) / 2;
  *radius = std::hypot(high.x - low.x, high.y - low.y, high.z - low.z) / 2;
}

const uint32_t* level_model_vertex(const level_model* model) { return model->records.progressive.vertex.data(); }

foredraw_progressive_mesh level_model_progressive(level_model* model) {
  foredraw::ProgressiveRecords& records = model->records.progressive;
  return {records.splits.data(),
          records.splits.size() - 1,
          records.patches.data(),
          records.indices.data(),
          static_cast<uint32_t>(records.vertex.size()),
          static_cast<uint32_t>(records.triangle.size()),
          records.splits.size() - 1};
}

const foredraw_refine_mesh* level_model_refine(const level_model* model) { return &model->refine; }
