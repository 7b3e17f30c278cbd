#include "by_keyframe.h"

#include "bench_meshes.h"

#include <evaluators/overdraw_raster/overdraw_raster.h>
#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/io/image/images.h>
#include <foredraw/overdraw/fragment_layers.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/subject_geometry.h>
#include <plugins/orderers/dot_rule/dot_rule.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace foredraw::bench {

namespace {

/// Fragments that pass in a list where every draw's own are drawn front to back: the nearest of each draw, but for what
/// hides behind an earlier draw.
template <class Owner>
std::uint64_t least_passing(std::span<const Owner> list, std::span<const std::uint32_t> part_of) {
  std::uint64_t passing = 0;
  std::uint32_t earliest = ~std::uint32_t{0};
  for (const Owner owner : list) {
    const std::uint32_t part = part_of[owner & static_cast<Owner>(~tie_bit<Owner>)];
    if (part >= earliest) continue;
    earliest = part;
    ++passing;
  }
  return passing;
}

}  // namespace

Figures dot_rule_per_keyframe(Lab& lab, const Scene& patches, int keyframes) {
  const Views views = held_out_views();
  const Poses poses = make_poses(patches, {.poses = std::to_string(keyframes)});
  Analyses analyses(image_decoder({}));
  Figures figures;
  OverdrawCount sum;
  CacheCount cache;
  for (const Subject& subject : subjects_of(patches)) {
    for (const Pose& pose : poses.poses) {
      SubjectGeometry drawn = subject_geometry(patches, subject, Faces::front, posed_nodes(patches, pose), analyses);
      std::vector<std::vector<std::uint32_t>> sorted(drawn.parts.size());
      const auto begin = std::chrono::steady_clock::now();
      for (std::size_t part = 0; part < drawn.parts.size(); ++part) {
        const IndexStream& stream = patches.draws[subject.parts[part].draw].levels[0].orders[0];
        if (drawn.parts[part].indices.empty()) continue;
        const auto sequence = dot_rule(drawn.positions[part], stream.indices.view(), *stream.clusters);
        sorted[part] = reordered(stream.indices.view(), in_sequence(*stream.clusters, sequence));
      }
      figures.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      for (std::size_t part = 0; part < drawn.parts.size(); ++part) {
        if (sorted[part].empty()) continue;
        drawn.parts[part].indices = sorted[part];
        const CacheCount count = count_fifo(sorted[part], drawn.positions[part].size(), cache_size);
        cache.misses += count.misses;
        cache.triangles += count.triangles;
      }
      for (const auto& of_part : overdraw_raster(drawn.parts, views, lab.executor())) {
        for (const OverdrawCount& count : of_part) sum += count;
      }
    }
  }
  figures.acmr = static_cast<double>(cache.misses) / static_cast<double>(cache.triangles);
  figures.ratio = static_cast<double>(sum.shaded) / static_cast<double>(sum.visible);
  return figures;
}

Figures least_of_sequence(Lab& lab, const Scene& scene, int keyframes) {
  const Poses poses = make_poses(scene, {.poses = std::to_string(keyframes)});
  Views views = held_out_views();
  const std::vector<View> all = std::exchange(views.views, {});
  constexpr std::size_t at_once = 25;
  Analyses analyses(image_decoder({}));
  std::uint64_t shaded = 0, visible = 0;
  for (const Subject& subject : subjects_of(scene)) {
    for (const Pose& pose : poses.poses) {
      const SubjectGeometry drawn = subject_geometry(scene, subject, Faces::front, posed_nodes(scene, pose), analyses);
      std::vector<std::uint32_t> part_of;
      for (std::uint32_t part = 0; part < drawn.parts.size(); ++part) {
        part_of.resize(part_of.size() + drawn.parts[part].indices.size() / 3, part);
      }
      for (std::size_t first = 0; first < all.size(); first += at_once) {
        views.views.assign(all.begin() + static_cast<std::ptrdiff_t>(first),
                           all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), first + at_once)));
        const auto layers = fragment_layers(drawn.parts, views, lab.executor());
        for (const ViewLayers& view : layers.value().views) {
          visible += view.always.visible;
          shaded += view.always.shaded;
          for_each_batch(view, [&](const LayerBatch& batch, const auto* list) {
            for (std::uint32_t i = 0; i < batch.lists; ++i, list += batch.length) {
              shaded += batch.weight * least_passing(std::span(list, batch.length), std::span(std::as_const(part_of)));
            }
          });
        }
      }
    }
  }
  return {0, static_cast<double>(shaded) / static_cast<double>(visible)};
}

}  // namespace foredraw::bench
