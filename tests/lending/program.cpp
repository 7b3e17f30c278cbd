// The program with one plugin more, which compares a scene with another one.
#include "likeness.h"

#include <commands.h>
#include <foredraw/technique/built_in_plugins.h>

int main(int argc, char** argv) {
  foredraw::Registry registry;
  foredraw::add_built_in_plugins(registry);
  registry.add(foredraw::testing::likeness_plugin());
  return foredraw::cli::main(argc, argv, registry);
}
