// Indices of any width and alignment have the answers of the functions for C++.

#include <evaluators/vertex_cache/vertex_cache.h>
#include <foredraw/base/random.h>
#include <foredraw/c/functions.h>
#include <plugins/clusterers/linear_clusters/linear_clusters.h>
#include <plugins/orderers/dot_rule/dot_rule.h>
#include <plugins/orderers/forsyth/forsyth.h>
#include <plugins/orderers/lookahead/lookahead.h>
#include <plugins/orderers/tipsify/tipsify.h>
#include <plugins/orderers/vertex_fetch/vertex_fetch.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace foredraw::same_answers_test {
namespace {

struct Mesh {
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> indices;
  std::vector<glm::vec3> positions;
};

/// Triangles that share vertices at random, some of them degenerate; some positions are no numbers.
Mesh random_mesh(std::uint32_t vertices, std::size_t triangles) {
  Mesh mesh{vertices, {}, {}};
  Random random(vertices);
  for (std::size_t i = 0; i < 3 * triangles; ++i) {
    mesh.indices.push_back(static_cast<std::uint32_t>(random.below(vertices)));
  }
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const auto coordinate = [&] { return static_cast<float>(random.below(1000)); };
    mesh.positions.push_back({coordinate(), coordinate(), i % 50 == 7 ? std::nanf("") : coordinate()});
  }
  return mesh;
}

/// The indices in so many bytes each, from an address of this remainder on.
class Stored {
 public:
  Stored(const Mesh& mesh, std::uint32_t bytes, std::size_t offset)
      : memory_(mesh.indices.size() * bytes + offset),
        list_{memory_.data() + offset, mesh.indices.size(), bytes, mesh.vertex_count} {
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      std::memcpy(memory_.data() + offset + i * bytes, &mesh.indices[i], bytes);  // the low bytes come first here
    }
  }
  const foredraw_triangles* list() const { return &list_; }

 private:
  std::vector<std::byte> memory_;
  foredraw_triangles list_;
};

using Layout = std::tuple<std::uint32_t, std::size_t>;

class EveryLayout : public ::testing::TestWithParam<Layout> {
 protected:
  const Mesh mesh_ = random_mesh(std::get<0>(GetParam()) == 1 ? 256 : 500, 900);
  const Stored stored_{mesh_, std::get<0>(GetParam()), std::get<1>(GetParam())};
  const foredraw_triangles* list_ = stored_.list();
  std::vector<std::uint32_t> order_ = std::vector<std::uint32_t>(900);
};

TEST_P(EveryLayout, HasTheOrdersOfTheFunctions) {
  ASSERT_EQ(foredraw_tipsify(order_.data(), list_, 0), FOREDRAW_DONE);
  EXPECT_EQ(order_, tipsify(mesh_.indices, mesh_.vertex_count));
  ASSERT_EQ(foredraw_tipsify(order_.data(), list_, 24), FOREDRAW_DONE);
  EXPECT_EQ(order_, tipsify(mesh_.indices, mesh_.vertex_count, {.cache_size = 24}));
  ASSERT_EQ(foredraw_forsyth(order_.data(), list_, 20), FOREDRAW_DONE);
  EXPECT_EQ(order_, forsyth(mesh_.indices, mesh_.vertex_count, {.cache_size = 20}));
  ASSERT_EQ(foredraw_lookahead(order_.data(), list_, 0, 0, 0), FOREDRAW_DONE);
  EXPECT_EQ(order_, lookahead(mesh_.indices, mesh_.vertex_count));
  ASSERT_EQ(foredraw_lookahead(order_.data(), list_, FOREDRAW_LOOKAHEAD_HIGH, FOREDRAW_LOOKAHEAD_AMD, 0),
            FOREDRAW_DONE);
  EXPECT_EQ(order_, lookahead(mesh_.indices, mesh_.vertex_count,
                              {.quality = LookaheadQuality::high, .target = LookaheadTarget::amd}));
}

TEST_P(EveryLayout, HasTheClustersAndTheirSequence) {
  std::vector<std::uint32_t> offsets(901), sequence(900);
  std::uint32_t count = 0;
  ASSERT_EQ(foredraw_linear_clusters(offsets.data(), &count, list_, 0, 1.2), FOREDRAW_DONE);
  const Clusters clusters = linear_clusters(mesh_.indices, mesh_.vertex_count, 16, {.growth = 1.2});
  offsets.resize(count + 1), sequence.resize(count);
  ASSERT_EQ(offsets, clusters.offsets);
  const foredraw_positions positions{mesh_.positions.data(), 0};
  ASSERT_EQ(foredraw_dot_rule(sequence.data(), list_, &positions, offsets.data(), count), FOREDRAW_DONE);
  EXPECT_EQ(sequence, dot_rule(mesh_.positions, mesh_.indices, clusters));
  ASSERT_EQ(foredraw_order_of_clusters(order_.data(), offsets.data(), count, sequence.data()), FOREDRAW_DONE);
  EXPECT_EQ(order_, in_sequence(clusters, sequence));
}

TEST_P(EveryLayout, HasTheVerticesByFirstUseAndTheFigures) {
  std::vector<std::uint32_t> order(mesh_.vertex_count);
  std::uint32_t used = 0;
  ASSERT_EQ(foredraw_vertex_fetch(order.data(), &used, list_), FOREDRAW_DONE);
  const std::span<const std::uint32_t> indices = mesh_.indices;
  EXPECT_EQ(order, vertex_fetch({&indices, 1}, mesh_.vertex_count));
  foredraw_vertex_cache_figures figures;
  ASSERT_EQ(foredraw_vertex_cache(&figures, list_, 24), FOREDRAW_DONE);
  const CacheCount count = count_fifo(mesh_.indices, mesh_.vertex_count, 24);
  EXPECT_EQ(figures.misses, count.misses);
  EXPECT_EQ(figures.vertices, count.referenced);
  EXPECT_EQ(used, count.referenced);
  EXPECT_DOUBLE_EQ(figures.acmr, static_cast<double>(count.misses) / 900);
}

INSTANTIATE_TEST_SUITE_P(Layouts, EveryLayout,
                         ::testing::Combine(::testing::Values(1, 2, 4), ::testing::Values(0, 1, 2)));

}  // namespace
}  // namespace foredraw::same_answers_test
