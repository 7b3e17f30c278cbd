#include "vertex_cache.h"

#include <algorithm>
#include <charconv>

namespace foredraw {

namespace {

/// The numbers of "-16" or "-32-64-0"; nothing where it is of another form or one is too large.
std::optional<std::vector<std::uint32_t>> numbers(std::string_view text) {
  constexpr std::uint32_t most = 65535;
  std::vector<std::uint32_t> values;
  while (!text.empty()) {
    if (text.front() != '-') return std::nullopt;
    std::uint32_t value = 0;
    const char* end = text.data() + text.size();
    const auto [after, error] = std::from_chars(text.data() + 1, end, value);
    if (error != std::errc() || value > most) return std::nullopt;
    values.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(after - text.data()));
  }
  return values;
}

}  // namespace

std::optional<CacheModel> cache_model(std::string_view name) {
  using Kind = CacheModel::Kind;
  for (const BatchModel& vendor : batch_models) {
    if (name != vendor.name) continue;
    return CacheModel{std::string(name), Kind::batches, vendor.cache_size, vendor.warp_size, vendor.primitive_group};
  }
  const std::string_view kind = name.substr(0, name.find('-'));
  const auto sizes = numbers(name.substr(kind.size()));
  if (!sizes || sizes->empty() || sizes->front() == 0) return std::nullopt;
  if (kind == "fifo" && sizes->size() == 1) return CacheModel{std::string(name), Kind::fifo, (*sizes)[0]};
  if (kind == "lru" && sizes->size() == 1) return CacheModel{std::string(name), Kind::lru, (*sizes)[0]};
  if (kind == "batches" && sizes->size() == 3) {
    return CacheModel{std::string(name), Kind::batches, (*sizes)[0], (*sizes)[1], (*sizes)[2]};
  }
  return std::nullopt;
}

CacheCount count(std::span<const std::uint32_t> indices, std::size_t vertex_count, const CacheModel& model) {
  switch (model.kind) {
    case CacheModel::Kind::fifo: return count_fifo(indices, vertex_count, model.cache_size);
    case CacheModel::Kind::lru: return count_lru(indices, vertex_count, model.cache_size);
    case CacheModel::Kind::batches: break;
  }
  return count_batches(indices, vertex_count, {model.name, model.cache_size, model.warp_size, model.primitive_group});
}

}  // namespace foredraw
