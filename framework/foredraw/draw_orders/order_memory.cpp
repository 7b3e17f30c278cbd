#include <foredraw/draw_orders/order_memory.h>

#include <foredraw/base/counted.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

/// "432 KB", "6.5 MB": thousands, as disks and papers count.
std::string size_text(std::uint64_t bytes) {
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  double size = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  for (; size >= 999.5 && unit < 2; ++unit) size /= 1000;
  constexpr const char* units[] = {"KB", "MB", "GB"};
  return fmt::format("{:.{}f} {}", size, size < 9.95 ? 1 : 0, units[unit]);
}

}  // namespace

OrderMemory memory_of(const Scene& scene, const OrderTable& table) {
  OrderMemory memory;
  for (const DrawId id : table.draws) {
    const Level& level = scene.draws[id].full();
    const std::size_t width = level.vertices->count <= 0xffff ? 2 : 4;
    const std::uint64_t one = level.stream().indices.size() * width;
    memory.orders = std::max(memory.orders, level.orders.size());
    memory.triangles += level.stream().triangle_count();
    memory.bytes += level.orders.size() * one;
    memory.bytes_for_each_keyframe += table.keyframes() * one;
  }
  return memory;
}

std::string memory_text(const OrderMemory& memory, std::size_t keyframes) {
  std::string text = fmt::format("{} of {}: {}", counted(memory.orders, "order"), counted(memory.triangles, "triangle"),
                                 size_text(memory.bytes));
  if (keyframes > 1) {
    text += fmt::format("; one for each of {} keyframes would take {}", keyframes,
                        size_text(memory.bytes_for_each_keyframe));
  }
  return text;
}

}  // namespace foredraw
