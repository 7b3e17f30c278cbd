// The program with one evaluator more, which attaches films and charts.
#include "walk.h"

#include <commands.h>
#include <foredraw/technique/built_in_plugins.h>

int main(int argc, char** argv) {
  foredraw::Registry registry;
  foredraw::add_built_in_plugins(registry);
  registry.add(foredraw::testing::walk_plugin());
  return foredraw::cli::main(argc, argv, registry);
}
