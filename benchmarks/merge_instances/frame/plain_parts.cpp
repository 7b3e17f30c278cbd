#include "content_parts.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace foredraw::bench {

namespace {

/// Where a primitive lies in the buffers of its part.
struct DrawPlace {
  std::uint32_t first_index = 0;
  std::uint32_t index_count = 0;
  std::int32_t vertex_offset = 0;
};

/// The vertices of several primitives of one layout, one behind the other, and their indices as they are.
class MeshBuffers {
 public:
  explicit MeshBuffers(const Scene& scene) : scene_(scene) {}

  const DrawPlace& place_of(DrawId id) {
    const auto [place, is_new] = places_.try_emplace(id);
    if (!is_new) return place->second;
    const Level& level = scene_.draws[id].levels[0];
    const auto indices = level.orders[0].indices.view();
    place->second = {static_cast<std::uint32_t>(indices_.size()), static_cast<std::uint32_t>(indices.size()),
                     static_cast<std::int32_t>(offset_of(*level.vertices))};
    indices_.insert(indices_.end(), indices.begin(), indices.end());
    return place->second;
  }

  void move_into(FramePart& part) {
    VertexStreams vertices;
    vertices.count = vertex_count_;
    if (!streams_.empty()) {
      for (std::size_t s = 0; s < streams_[0]->base.size(); ++s) {
        std::vector<std::byte> bytes;
        for (const VertexStreams* streams : streams_) {
          const auto more = streams->base[s].bytes.view();
          bytes.insert(bytes.end(), more.begin(), more.end());
        }
        vertices.base.push_back({streams_[0]->base[s].semantic, streams_[0]->base[s].format, Shared(std::move(bytes))});
      }
    }
    part.vertices = std::make_shared<const VertexStreams>(std::move(vertices));
    const bool are_small = std::ranges::all_of(indices_, [](std::uint32_t index) { return index < 65536; });
    part.index_bytes = are_small ? 2 : 4;
    part.indices = std::move(indices_);
  }

 private:
  std::uint32_t offset_of(const VertexStreams& streams) {
    const auto [offset, is_new] = offsets_.try_emplace(&streams, vertex_count_);
    if (is_new) {
      streams_.push_back(&streams);
      vertex_count_ += streams.count;
    }
    return offset->second;
  }

  const Scene& scene_;
  std::map<DrawId, DrawPlace> places_;
  std::map<const VertexStreams*, std::uint32_t> offsets_;
  std::vector<const VertexStreams*> streams_;
  std::vector<std::uint32_t> indices_;
  std::uint32_t vertex_count_ = 0;
};

bool is_one_by_one(DrawWay way) { return way == DrawWay::each || way == DrawWay::indirect_each; }
bool is_indirect(DrawWay way) { return way == DrawWay::indirect || way == DrawWay::indirect_each; }

/// What one call can draw has the same key.
auto key_of(const PlacedDraw& placed, DrawWay way) {
  const bool by_node = way == DrawWay::gpu_instancing;
  const std::uint32_t group = way == DrawWay::group_instanced ? placed.group : 0;
  return std::tuple(group, placed.is_mirrored, by_node ? placed.place.node : placed.draw,
                    by_node ? placed.place.primitive : 0);
}

FramePart plain_part(const Scene& scene, std::span<const PlacedDraw> placed, DrawWay way) {
  FramePart part;
  MeshBuffers meshes(scene);
  std::vector<DirectCall> calls;
  for (std::uint32_t i = 0; i < placed.size(); ++i) {
    part.transforms.push_back(rows_of(placed[i].world));
    part.materials.push_back(look_of(scene, placed[i].draw));
    part.places.push_back(hash_of(placed[i].place));
    if (i > 0 && !is_one_by_one(way) && key_of(placed[i], way) == key_of(placed[i - 1], way)) {
      ++calls.back().command.instance_count;
      continue;
    }
    const DrawPlace& at = meshes.place_of(placed[i].draw);
    DirectCall& call = calls.emplace_back();
    call.command = {at.index_count, 1, at.first_index, at.vertex_offset, way == DrawWay::each ? 0 : i};
    call.first = way == DrawWay::each ? i : 0;
    call.is_mirrored = placed[i].is_mirrored;
  }
  meshes.move_into(part);
  if (!is_indirect(way)) {
    part.direct = std::move(calls);
    return part;
  }
  for (const DirectCall& call : calls) {
    const auto number = static_cast<std::uint32_t>(part.commands.size());
    const bool goes_on = !part.indirect.empty() && part.indirect.back().is_mirrored == call.is_mirrored;
    if (!goes_on) part.indirect.push_back({number, 0, call.is_mirrored});
    ++part.indirect.back().commands;
    part.commands.push_back(call.command);
  }
  return part;
}

}  // namespace

void add_plain_parts(const Scene& scene, std::vector<PlacedDraw> placed, DrawWay way, bool is_ordered,
                     FrameContent& content) {
  std::map<Stamp, std::uint32_t> numbers;
  std::vector<std::uint32_t> layout;  // [draw]
  for (const Draw& draw : scene.draws) {
    layout.push_back(numbers.try_emplace(draw.levels[0].vertices->layout_stamp(), numbers.size()).first->second);
  }
  if (is_ordered) {
    std::ranges::stable_sort(placed, {}, [&](const PlacedDraw& one) { return layout[one.draw]; });
  } else {
    std::ranges::sort(placed, {},
                      [&](const PlacedDraw& one) { return std::tuple(layout[one.draw], key_of(one, way), one.place); });
  }
  for (auto first = placed.begin(); first != placed.end();) {
    const auto end = std::find_if(first, placed.end(),
                                  [&](const PlacedDraw& one) { return layout[one.draw] != layout[first->draw]; });
    content.parts.push_back(plain_part(scene, {first, end}, way));
    first = end;
  }
  for (const PlacedDraw& one : placed) content.sequence.push_back(one.place);
}

}  // namespace foredraw::bench
