#include "frame_ways.h"

#include <foredraw/runtime/lod_benefit.h>

#include <algorithm>
#include <optional>

namespace foredraw::evaluators::lod_walk {

namespace {

constexpr float base_error = 0.5f;  // as the paper has it

MeshWays ways_of(const FrameMesh& mesh) {
  MeshWays ways;
  ways.levels.resize(mesh.levels);
  ways.triangles.resize(mesh.levels);
  for (std::size_t number = 0; number < mesh.levels; ++number) {
    MeshWays::Level& level = ways.levels[number];
    for (const FrameDraw& draw : mesh.draws) {
      const FrameLevel& drawn = draw.levels[std::min(number, draw.levels.size() - 1)];
      ways.triangles[number] += static_cast<std::uint32_t>(drawn.indices.size() / 3);
      level.vertices += static_cast<std::uint32_t>(drawn.vertices);
      ++level.draws;
      level.error = std::max(level.error, drawn.error);
    }
  }
  for (const FrameDraw& draw : mesh.draws) ways.has_normal_map |= draw.surface.normal_map != nullptr;
  return ways;
}

/// Of a pixel that the object covers. By pictures it is below 0: what the pixel loses.
double accuracy_of(const MeshWays& mesh, std::uint32_t level, std::size_t rendering, const SeenObject& object,
                   Accuracy accuracy) {
  const auto across = static_cast<double>(object.across);
  switch (accuracy) {
    case Accuracy::errors:
      return mesh.accuracies[rendering] * static_cast<double>(foredraw_lod_accuracy_of_error(
                                              static_cast<float>(mesh.levels[level].error) * object.pixels_a_unit));
    case Accuracy::samples:
      return mesh.accuracies[rendering] * static_cast<double>(foredraw_lod_accuracy_of_samples(
                                              static_cast<float>(mesh.levels[level].vertices), base_error, 2));
    case Accuracy::pictures: break;
  }
  constexpr double hundredths = 100;  // so that little is left when benefits become whole numbers
  return -hundredths * PictureLosses::at(mesh.losses.of[level][rendering], across);
}

}  // namespace

std::vector<MeshWays> mesh_ways(const FrameScene& scene, const FrameMoment& moment, bool with_losses,
                                const Executor& executor) {
  std::vector<MeshWays> meshes(scene.scene().meshes.size());
  std::vector<std::optional<std::uint32_t>> shown(meshes.size());
  for (std::uint32_t i = static_cast<std::uint32_t>(scene.objects().size()); i-- > 0;) {
    shown[scene.objects()[i].mesh] = i;
  }
  executor.for_each(meshes.size(), [&](std::size_t mesh) {
    if (!shown[mesh]) return;
    meshes[mesh] = ways_of(scene.mesh_of(*shown[mesh]));
    if (!with_losses) return;
    meshes[mesh].losses = picture_losses(scene, moment, *shown[mesh]);
    meshes[mesh].accuracies = rendering_accuracies(meshes[mesh].losses);
  });
  return meshes;
}

ObjectWork work_of(const MeshWays& mesh, const WayName& name, const SeenObject& object, bool is_posed) {
  const MeshWays::Level& level = mesh.levels[name.level];
  const bool is_full = name.rendering == Rendering::full && mesh.has_normal_map;
  return {is_full || name.rendering == Rendering::unlit ? name.rendering : Rendering::without_normal_map,
          static_cast<double>(mesh.triangles[name.level]),
          static_cast<double>(level.vertices),
          static_cast<double>(object.shown),
          static_cast<double>(level.draws),
          is_posed ? static_cast<double>(level.vertices) : 0.0};
}

FrameWays frame_ways(const FrameScene& scene, const std::vector<MeshWays>& meshes, std::vector<SeenObject> seen,
                     const std::vector<float>& speeds, const RenderingCosts& costs, const BenefitOptions& options,
                     bool with_renderings) {
  FrameWays frame;
  frame.seen = std::move(seen);
  frame.first.reserve(frame.seen.size() + 1);
  struct Way {
    foredraw_lod_way way;
    float worth;
    WayName name;
  };
  std::vector<Way> own;
  for (std::size_t i = 0; i < frame.seen.size(); ++i) {
    const SeenObject& object = frame.seen[i];
    const MeshWays& mesh = meshes[scene.objects()[object.object].mesh];
    float worth = object.shown * foredraw_lod_focus(object.from_middle, static_cast<float>(options.focus));
    if (options.motion) worth *= foredraw_lod_motion(speeds[i], std::sqrt(object.pixels));
    own.clear();
    for (std::uint32_t level = 0; level < mesh.levels.size(); ++level) {
      for (std::size_t r = 0; r < (with_renderings ? all_renderings.size() : 1); ++r) {
        const Rendering rendering = all_renderings[r];
        if (rendering == Rendering::without_normal_map && !mesh.has_normal_map) continue;
        const ObjectWork work = work_of(mesh, {level, rendering}, object, scene.objects()[object.object].is_posed);
        const float way_worth = worth * static_cast<float>(accuracy_of(mesh, level, r, object, options.accuracy));
        own.push_back(
            {{foredraw_lod_cost(static_cast<float>(object_cost(costs, work))), 0}, way_worth, {level, rendering}});
      }
    }
    // What is lost by all ways is no benefit of any.
    const float least = options.accuracy == Accuracy::pictures ? std::ranges::min(own, {}, &Way::worth).worth : 0;
    for (Way& way : own) {
      way.worth -= least;
      way.way.benefit = foredraw_lod_benefit(way.worth);
    }
    std::ranges::stable_sort(own, [](const Way& a, const Way& b) {
      return a.way.cost != b.way.cost ? a.way.cost < b.way.cost : a.worth < b.worth;
    });
    frame.first.push_back(static_cast<std::uint32_t>(frame.ways.size()));
    for (const Way& way : own) {
      frame.ways.push_back(way.way);
      frame.worth.push_back(way.worth);
      frame.names.push_back(way.name);
    }
  }
  frame.first.push_back(static_cast<std::uint32_t>(frame.ways.size()));
  return frame;
}

std::vector<foredraw_lod_way> with_hysteresis(const FrameWays& frame, const std::vector<WayName>& last, double weight) {
  std::vector<foredraw_lod_way> ways = frame.ways;
  for (std::size_t i = 0; i < frame.seen.size() && weight > 0; ++i) {
    const WayName& before = last[frame.seen[i].object];
    for (std::uint32_t way = frame.first[i]; way < frame.first[i + 1]; ++way) {
      if (frame.names[way] != before) continue;
      const float best = *std::max_element(&frame.worth[frame.first[i]], frame.worth.data() + frame.first[i + 1]);
      ways[way].benefit = foredraw_lod_benefit(foredraw_lod_held(frame.worth[way], best, static_cast<float>(weight)));
    }
  }
  return ways;
}

}  // namespace foredraw::evaluators::lod_walk
