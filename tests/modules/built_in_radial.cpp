// The program with the example's technique built in: what modules have to equal, byte by byte.
#include <commands.h>

#include <foredraw/technique/built_in_plugins.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

namespace {

struct RadialOptions {
  double height = 1;
};

class Radial final : public DrawOrderer {
 public:
  explicit Radial(RadialOptions options) : options_(options) {}

  IndexOrder order(const DrawView& draw, Run& run) const override {
    const auto positions = positions_of(run.analyses, draw.vertices());
    std::vector<double> distances(draw.triangle_count());
    for (std::size_t t = 0; t < distances.size(); ++t) {
      double sum = 0;
      for (const std::uint32_t v : draw.indices().subspan(3 * t, 3)) {
        const glm::vec3& p = positions->values[v];
        const double x = p.x, y = options_.height * p.y, z = p.z;
        sum += x * x + y * y + z * z;
      }
      distances[t] = sum >= 0 ? sum : -1;
    }
    IndexOrder order(distances.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, [&](auto a, auto b) { return distances[a] > distances[b]; });
    return order;
  }

 private:
  RadialOptions options_;
};

}  // namespace

}  // namespace foredraw

int main(int argc, char** argv) {
  using namespace foredraw;
  Registry registry;
  add_built_in_plugins(registry);
  Plugin plugin;
  plugin.card = {.name = "acme-radial",
                 .summary = "Draws triangles far from the origin first",
                 .reference = "own",
                 .acts_on = {traits::triangles},
                 .provides = {traits::overdraw_ordered},
                 .breaks = {traits::cache_ordered, traits::fetch_ordered, traits::clustered}};
  OptionTable<RadialOptions> table;
  table.row(&RadialOptions::height, "height", "How much height counts", {0, 10, ""});
  bind_options(plugin, table, [](const RadialOptions& options) { return std::make_unique<Radial>(options); });
  registry.add(std::move(plugin));
  return cli::main(argc, argv, registry);
}
