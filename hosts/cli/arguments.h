#pragma once
// What the words of a command line ask for.

#include "commands.h"

#include <functional>
#include <memory>
#include <variant>

namespace foredraw::cli {

/// Which modules are loaded for a command.
enum class Modules {
  none,   ///< it runs no techniques
  named,  ///< those of its arguments
  all,    ///< those of the environment, too
};

struct Asked {
  std::shared_ptr<CommonArguments> arguments;  ///< nullptr: for help or the version alone, which was printed
  std::function<Exit(const Registry&)> command;
  Modules modules = Modules::all;
  bool is_interruptible = false;  ///< it may take long and write: on Ctrl-C it ends in good order
};

/// Why the words ask for nothing, and what there is to ask for.
struct Misunderstood {
  std::string why;
  std::string command;             ///< that was named; empty: none was, or none that there is
  std::string unknown_command;     ///< or empty
  std::string input_too_many;      ///< or empty
  std::vector<std::string> words;  ///< all of them
  std::vector<std::string> commands;
  std::vector<std::string> options;  ///< of the command, or those without any; with their dashes
};

/// `argv` as main() gets it.
std::variant<Asked, Misunderstood> asked(int argc, char** argv, const Registry& registry);

}  // namespace foredraw::cli
