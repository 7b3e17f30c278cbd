#pragma once
// What a frame of a scene consists of, in one of the ways in which engines draw many placed primitives: its buffers and
// its calls. Nothing here needs a device.

#include <foredraw/instances/merged_instances.h>

#include "placed_draws.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw::bench {

/// In all ways the meshes lie in one vertex and one index buffer and materials are looked up by the shader, so that
/// between two calls nothing is bound but what the way itself needs.
enum class DrawWay : std::uint8_t {
  each,             ///< a call for each placed primitive, whose number is a push constant
  instanced,        ///< a call with instances for each primitive of a mesh
  group_instanced,  ///< the same within each group of merged draws, so that groups can be culled
  gpu_instancing,   ///< a call for each node and primitive, with the node's instances (EXT_mesh_gpu_instancing)
  indirect,         ///< one call, whose buffer holds a command for each primitive of a mesh
  indirect_each,    ///< one call, whose buffer holds a command for each placed primitive, as those have who cull on the
                    ///< GPU
  duplicated,       ///< a call for each group of merged draws, all of whose instances are vertices of their own
  merged,           ///< Scene::merged
};
inline constexpr DrawWay all_draw_ways[] = {DrawWay::each,           DrawWay::instanced, DrawWay::group_instanced,
                                            DrawWay::gpu_instancing, DrawWay::indirect,  DrawWay::indirect_each,
                                            DrawWay::duplicated,     DrawWay::merged};
std::string_view to_text(DrawWay way);  ///< "gpu-instancing"

/// As vkCmdDrawIndexedIndirect reads it.
struct IndexedCommand {
  std::uint32_t index_count = 0;
  std::uint32_t instance_count = 1;
  std::uint32_t first_index = 0;
  std::int32_t vertex_offset = 0;
  std::uint32_t first_instance = 0;
};

struct DirectCall {
  IndexedCommand command;
  std::uint32_t first = 0;  ///< the push constant: added to the instance's number
  bool is_mirrored = false;
};

struct IndirectCall {
  std::uint32_t first_command = 0;
  std::uint32_t commands = 0;
  bool is_mirrored = false;
};

/// How the vertex shader comes by its vertex and its instance.
enum class VertexFetch : std::uint8_t {
  indexed,   ///< by vertex and index buffers; the instance's number is the device's, plus the push constant
  in_world,  ///< by these too; vertices stand in the world already, and each says its instance
  merged,    ///< by itself, from slots
};

/// What is drawn from one set of buffers.
struct FramePart {
  VertexFetch fetch = VertexFetch::indexed;
  std::shared_ptr<const VertexStreams> vertices;
  std::vector<std::uint32_t> indices;
  std::size_t index_bytes = 4;              ///< of one: 2 where all are below 65,536
  std::vector<MergedTransform> transforms;  ///< [instance]
  std::vector<std::uint32_t> materials;     ///< [instance]; none of merged draws that share one
  std::vector<MergedSlot> slots;
  std::vector<IndexedCommand> commands;   ///< of indirect calls
  std::uint32_t merged_set = 0;           ///< which of Scene::merged
  std::optional<std::uint32_t> material;  ///< of all; none: each instance's

  // What tells placed primitives apart in pictures; no engine needs them, and they do not count.
  std::vector<std::uint32_t> places;     ///< [instance] hash
  std::vector<std::uint32_t> instances;  ///< [vertex] of those that stand in the world

  std::vector<DirectCall> direct;
  std::vector<IndirectCall> indirect;
  std::vector<MergedDraw> merged;

  std::size_t calls() const { return direct.size() + indirect.size() + merged.size(); }
};

/// Bytes of buffers, by what they hold.
struct FrameBytes {
  std::uint64_t vertices = 0;
  std::uint64_t indices = 0;
  std::uint64_t transforms = 0;  ///< and numbers of materials, where instances have different ones
  std::uint64_t slots = 0;
  std::uint64_t commands = 0;  ///< of indirect draws
  std::uint64_t all() const { return vertices + indices + transforms + slots + commands; }
};

struct FrameContent {
  DrawWay way = DrawWay::each;
  std::vector<FramePart> parts;
  FrameBytes bytes;
  std::vector<MergedPlace> sequence;  ///< what is drawn, in the sequence in which it is
  bool is_complete =
      true;  ///< false: the buffers of duplicated vertices were too large to be made and are only counted

  std::size_t calls() const;
};

/// The scene's merged draws stand for their places in the ways `merged` and `duplicated`; what they do not show is
/// drawn instanced. Other ways draw the nodes. `most_duplicated`: bytes of vertices and indices up to which the buffers
/// of `duplicated` are made.
FrameContent frame_content(const Scene& scene, DrawWay way, std::uint64_t most_duplicated = 1u << 28);

/// A call for each placed primitive, in this sequence (as far as the vertex layouts are the same).
FrameContent frame_content_of_each(const Scene& scene, std::span<const MergedPlace> sequence);

}  // namespace foredraw::bench
