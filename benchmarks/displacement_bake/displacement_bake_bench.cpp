// A cage with heights, and how many bytes meshoptimizer's simplification takes for the same error.
//   displacement-bake-bench BEFORE.glb BAKED.glb...
//
// Each BAKED.glb is BEFORE.glb after displacement-bake. Its distance from BEFORE is measured, root of the mean square
// over both surfaces; then meshopt_simplify (attributes left out, no error limit) is asked for the fewest triangles
// that come as near. Raw bytes are positions of 16 bits and indices as narrow as they allow, and for the cage levels
// and heights as well. Compressed bytes are those of meshoptimizer's codecs and deflate (level 9); levels and heights,
// which have no codec, go to deflate alone.

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/displaced/baked_heights.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/technique/built_in_plugins.h>
#include <foredraw/viewing/displaced_draw.h>

#include <fmt/format.h>
#include <meshoptimizer.h>
#include <zlib.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>

namespace foredraw::bench {
namespace {

using Positions = std::vector<glm::vec3>;
using Indices = std::vector<std::uint32_t>;

Scene read(const std::string& path) {
  Registry registry;
  add_built_in_plugins(registry);
  Diagnostics diagnostics;
  auto file = read_scene(path, diagnostics, {.products = registry.products()});
  if (!file || file->scene.draws.size() != 1) throw std::runtime_error(path + " is no scene of one draw");
  return std::move(file->scene);
}

std::size_t deflated(std::span<const std::byte> bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<Bytef> out(size);
  if (compress2(out.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9) != Z_OK)
    throw std::runtime_error("zlib fails");
  return size;
}

struct Bytes {
  std::size_t raw = 0, compressed = 0;
};

/// Positions of 16 bits over the box, and triangles, in meshoptimizer's orders.
Bytes bytes_of(const Positions& all, Indices indices) {
  meshopt_optimizeVertexCache(indices.data(), indices.data(), indices.size(), all.size());
  Positions positions(all.size());
  positions.resize(meshopt_optimizeVertexFetch(positions.data(), indices.data(), indices.size(), all.data(), all.size(),
                                               sizeof(glm::vec3)));
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (const glm::vec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::vector<std::array<std::uint16_t, 4>> rows;
  const glm::vec3 size = glm::max(high - low, glm::vec3(1e-30f));
  for (const glm::vec3& p : positions) {
    const glm::vec3 at = glm::round((p - low) / size * 65535.0f);
    rows.push_back(
        {static_cast<std::uint16_t>(at.x), static_cast<std::uint16_t>(at.y), static_cast<std::uint16_t>(at.z), 0});
  }
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(rows.size(), 8));
  vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), rows.data(), rows.size(), 8));
  std::vector<unsigned char> triangles(meshopt_encodeIndexBufferBound(indices.size(), positions.size()));
  triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), indices.data(), indices.size()));
  return {6 * positions.size() + indices.size() * (positions.size() <= 65536 ? 2 : 4),
          deflated(std::as_bytes(std::span(vertices))) + deflated(std::as_bytes(std::span(triangles)))};
}

Bytes bytes_of(const DrawHeights& heights) {
  std::vector<std::byte> packed((heights.heights.size() * heights.bits + 7) / 8, std::byte{0});
  std::size_t bit = 0;
  for (const std::uint16_t height : heights.heights.view()) {
    for (std::uint32_t b = 0; b < heights.bits; ++b, ++bit) {
      if (height >> b & 1) packed[bit / 8] |= std::byte{1} << (bit % 8);
    }
  }
  // Neighbours in the stream are neighbours on the surface: differences, low and high bytes apart.
  std::vector<std::byte> differences;
  for (const int shift : {0, 8}) {
    std::uint16_t last = 0;
    for (const std::uint16_t height : heights.heights.view()) {
      differences.push_back(static_cast<std::byte>(static_cast<std::uint16_t>(height - last) >> shift));
      last = height;
    }
  }
  return {packed.size() + heights.levels.size(),
          std::min(deflated(packed), deflated(differences)) + deflated(std::as_bytes(heights.levels.view()))};
}

struct Distance {
  double rms = 0, largest = 0;
};

class Original {
 public:
  explicit Original(const Scene& scene) : seen_(seen_surface(scene, {0, {}}, {}, analyses_)) {
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const glm::vec3& p : seen_.positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    diagonal = glm::length(high - low);
  }

  Distance to(const Positions& positions, std::span<const std::uint32_t> indices) const {
    const auto distance = surface_distance({seen_.positions, seen_.indices}, {positions, indices},
                                           {.samples = 200'000, .seed = 1}, executor_);
    return distance ? Distance{distance->rms / diagonal, distance->largest / diagonal} : Distance{INFINITY, INFINITY};
  }

  Indices simplified(std::size_t triangles) const {
    Indices indices(seen_.indices.size());
    indices.resize(meshopt_simplify(indices.data(), seen_.indices.data(), seen_.indices.size(), &seen_.positions[0].x,
                                    seen_.positions.size(), sizeof(glm::vec3), 3 * triangles, 1e9f));
    return indices;
  }

  const Positions& positions() const { return seen_.positions; }
  std::size_t triangles() const { return seen_.indices.size() / 3; }
  double diagonal = 0;

 private:
  Analyses analyses_;
  Executor executor_{2};
  SeenSurface seen_;
};

void compare(const Original& original, const std::string& path) {
  const Scene scene = read(path);
  const DrawHeights* heights = heights_of(scene, 0);
  if (heights == nullptr) throw std::runtime_error(path + " has no baked heights");
  Analyses analyses;
  const SeenSurface baked = seen_surface(scene, {0, {}}, {}, analyses);
  const Distance near = original.to(baked.positions, baked.indices);
  const Level& cage = scene.draws[0].full();
  const auto of_cage = bytes_of(decode_vec3(*cage.vertices->find("POSITION")),
                                {cage.stream().indices.view().begin(), cage.stream().indices.view().end()});
  const Bytes of_heights = bytes_of(*heights);

  std::size_t enough = original.triangles(), few = 0;
  while (enough - few > std::max<std::size_t>(1, enough / 200)) {
    const std::size_t middle = (enough + few) / 2;
    (original.to(original.positions(), original.simplified(middle)).rms <= near.rms ? enough : few) = middle;
  }
  const Indices simplified = original.simplified(enough);
  const Distance peer = original.to(original.positions(), simplified);
  const Bytes of_peer = bytes_of(original.positions(), simplified);
  const Bytes ours{of_cage.raw + of_heights.raw, of_cage.compressed + of_heights.compressed};
  fmt::print("{}\n  cage:      {} triangles, {} drawn, rms {:.2e}, largest {:.2e}, raw {}, compressed {}\n", path,
             heights->levels.size(), baked.indices.size() / 3, near.rms, near.largest, ours.raw, ours.compressed);
  fmt::print("  simplify:  {} triangles, rms {:.2e}, largest {:.2e}, raw {}, compressed {}\n", simplified.size() / 3,
             peer.rms, peer.largest, of_peer.raw, of_peer.compressed);
  fmt::print("  simplify / cage: raw {:.2f}, compressed {:.2f}; largest of the cage / of simplify {:.2f}\n",
             double(of_peer.raw) / double(ours.raw), double(of_peer.compressed) / double(ours.compressed),
             near.largest / peer.largest);
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  try {
    if (argc < 3) throw std::runtime_error("displacement-bake-bench BEFORE.glb BAKED.glb...");
    const foredraw::Scene before = foredraw::bench::read(argv[1]);
    const foredraw::bench::Original original(before);
    for (int i = 2; i < argc; ++i) foredraw::bench::compare(original, argv[i]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}
