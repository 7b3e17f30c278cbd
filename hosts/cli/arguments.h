#pragma once
// What the words of a command line ask for.

#include "commands.h"

#include <variant>

namespace foredraw::cli {

using Command = Exit (*)(const Arguments& arguments, const Registry& registry);

struct Asked {
  Command command = nullptr;  ///< nullptr: for help or the version alone, which was printed
  Arguments arguments;
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
