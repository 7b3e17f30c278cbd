// Primitives that are compressed by Draco (KHR_draco_mesh_compression). Their buffers are decoded on the way, and what
// follows sees accessors with bytes, and no trace of the extension. What accessors and buffers claim is held against
// each other, and against the bytes that there are.
#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/codecs/private/draco_uses.h>

#include <fmt/format.h>

namespace foredraw::gltf {

namespace {

constexpr const char* export_again = "export the file again; it was damaged on its way, or its exporter is wrong";

bool is_affordable(Gate& gate, const std::vector<DracoBuffer>& buffers) {
  const std::uint64_t most = most_claimed(gate, 256);
  std::uint64_t claimed = 0;
  for (const DracoBuffer& buffer : buffers) {
    claimed += buffer.claim.bytes();
    if (claimed <= most) continue;
    gate.error(buffer.place, "compressed-count",
               fmt::format("the accessors up to these claim {} bytes, more than a file of this size can hold",
                           counted(claimed)),
               export_again);
    return false;
  }
  return true;
}

bool all_decoded(Gate& gate, const std::vector<DracoBuffer>& buffers) {
  bool all = true;
  for (const DracoBuffer& buffer : buffers) {
    const auto* fault = std::get_if<DracoFault>(&buffer.held);
    if (fault == nullptr) continue;
    gate.error(buffer.place, fault->code, fault->message, export_again);
    all = false;
  }
  return all;
}

}  // namespace

bool check_draco(Gate& gate, const Executor& executor) {
  DracoUses found = draco_uses(gate);
  if (!gate.sound()) return !found.is_used;
  if (found.is_used && is_affordable(gate, found.buffers)) {
    executor.for_each(found.buffers.size(), [&](std::size_t i) {
      DracoBuffer& buffer = found.buffers[i];
      buffer.held = draco_decoded(gate.document().views[buffer.view].bytes, buffer.claim);
    });
    if (all_decoded(gate, found.buffers)) place_draco(gate, found);
  }
  unlist_extension(gate.document().json, draco_extension);
  return gate.sound();
}

}  // namespace foredraw::gltf
