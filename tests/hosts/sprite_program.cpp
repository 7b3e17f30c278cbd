// The program with one more plugin: it draws each sprite as a hexagon. So what becomes of sprites is tested without any
// technique that decides about them.
#include "commands.h"

#include <foredraw/technique/built_in_plugins.h>

#include "support/sprites.h"

namespace {

struct NoOptions {};

class Hexagons final : public foredraw::DrawProcessor {
 public:
  foredraw::Draw process(const foredraw::DrawView& view, foredraw::Run&) const override {
    foredraw::Draw draw = view.draw();
    foredraw::testing::trim(draw, 6);
    return draw;
  }
};

foredraw::Plugin hexagons() {
  foredraw::Plugin plugin;
  plugin.kind = foredraw::Kind::processor;
  plugin.card = {.name = "hexagons", .summary = "Draws each sprite as a hexagon.", .reference = "own"};
  plugin.card.acts_on = {foredraw::traits::sprite};
  plugin.card.provides = {foredraw::traits::trimmed};
  bind_options(plugin, foredraw::OptionTable<NoOptions>(), [](NoOptions) { return std::make_unique<Hexagons>(); });
  return plugin;
}

}  // namespace

int main(int argc, char** argv) {
  foredraw::Registry registry;
  foredraw::add_built_in_plugins(registry);
  registry.add(hexagons());
  return foredraw::cli::main(argc, argv, registry);
}
