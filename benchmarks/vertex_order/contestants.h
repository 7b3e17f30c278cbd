#pragma once
// Who orders triangles for the vertex cache, and with which settings: the one table of the contest.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace foredraw::bench {

using Indices = std::vector<std::uint32_t>;

/// Takes an index buffer, three a triangle, each below the number of vertices, and gives the new one.
using TriangleOrder = std::function<Indices(std::span<const std::uint32_t>, std::size_t vertex_count)>;

struct Contestant {
  std::string order;    ///< "tipsify"
  std::string setting;  ///< "cache-size=16"; empty where there is nothing to set
  TriangleOrder work;

  std::string name() const { return setting.empty() ? order : order + ' ' + setting; }
};

/// Ours and the peers', in the sequence of the tables.
std::vector<Contestant> contestants();

}  // namespace foredraw::bench
