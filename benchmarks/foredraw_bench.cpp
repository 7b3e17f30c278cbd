#include "commands.h"
#include "peers.h"

#include <foredraw/technique/built_in_plugins.h>

int main(int argc, char** argv) {
  foredraw::Registry registry;
  foredraw::add_built_in_plugins(registry);
  foredraw::add_peers(registry);
  return foredraw::cli::main(argc, argv, registry);
}
