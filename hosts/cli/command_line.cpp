// From the words of a command line to an exit code.
#include "arguments.h"
#include "session.h"

#include <foredraw/base/counted.h>
#include <foredraw/base/diagnostics.h>
#include <foredraw/modules/load_modules.h>
#include <foredraw/platform/interruption.h>
#include <foredraw/platform/memory.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <optional>

namespace foredraw::cli {

namespace {

/// The first word that looks like an option and is none; or nothing.
std::string unknown_option(const Misunderstood& no) {
  for (const std::string& word : no.words) {
    if (word == "--") break;
    const std::string name = word.substr(0, word.find('='));
    const bool looks_like_one = word.size() > 1 && word[0] == '-' && std::isdigit(word[1]) == 0;
    if (looks_like_one && std::ranges::find(no.options, name) == no.options.end()) return name;
  }
  return {};
}

void tell_mistake(const Misunderstood& no) {
  const auto say = [](const std::string& mistake, const std::string& hint) {
    fmt::print(stderr, "foredraw: error: {}\n    hint: {}\n", mistake, hint);
  };
  const auto did_you_mean = [](std::string_view near, const std::string& else_say) {
    return near.empty() ? else_say : fmt::format("did you mean '{}'?", near);
  };
  const std::string all = fmt::format("there are {}", fmt::join(no.commands, ", "));
  const std::string help = fmt::format("foredraw {}--help", no.command.empty() ? "" : no.command + ' ');
  if (!no.unknown_command.empty()) {
    say(fmt::format("there is no command '{}'", no.unknown_command),
        did_you_mean(nearest(no.unknown_command, no.commands), all));
  } else if (no.words.empty()) {
    say("a command is missing", all + "; " + help + " explains them");
  } else if (const std::string unknown = unknown_option(no); !unknown.empty()) {
    const bool is_a_letter = !unknown.starts_with("--");  // of which all others are near
    const std::string_view near = is_a_letter ? std::string_view() : nearest(unknown, no.options);
    say(fmt::format("there is no option '{}'", unknown), did_you_mean(near, help + " lists all options"));
  } else if (!no.input_too_many.empty()) {
    say(fmt::format("there is one input too many: '{}'", no.input_too_many),
        "name the output with -o, or put several inputs into a folder");
  } else {
    say(no.why, help + " lists commands and options");
  }
}

void tell_lack_of_memory(const OutOfMemory& lack, std::uint64_t limit) {
  end_progress();
  fmt::print(stderr, "{}: error: there is not enough memory to {}", lack.file, lack.doing);
  if (limit == 0) {
    fmt::print(stderr, "\n    hint: close other programs, or use a machine with more\n");
  } else {
    fmt::print(stderr, ": --memory-limit is {}\n    hint: raise --memory-limit\n", counted(limit, "byte"));
  }
}

/// Those that the arguments and the environment name. One that can not be loaded is told, and the run goes on without.
Exit load_modules(Modules which, const CommonArguments& arguments, Registry& registry) {
  if (which == Modules::none) return done;
  ModuleChoice choice;
  for (const std::string& module : arguments.modules) choice.places.emplace_back(module);
  if (which == Modules::all) {
    for (auto& place : modules_of_environment()) choice.places.push_back(std::move(place));
  }
  if (choice.places.empty()) return done;
  choice.inside = arguments.modules_inside;
  if (arguments.module_seconds > 0) choice.limits.seconds = arguments.module_seconds;
  if (arguments.module_memory > 0) choice.limits.memory = arguments.module_memory;
  Diagnostics diagnostics;
  add_modules(choice, Executor(arguments.threads), registry, diagnostics);
  tell(diagnostics);
  return diagnostics.has_errors() ? something_failed : done;
}

Exit run(const Asked& asked, const Registry& registry) {
  CommonArguments& arguments = *asked.arguments;
  std::optional<Interruption> interruption;
  if (asked.is_interruptible) arguments.interruption = &interruption.emplace();  // before there are threads
  if (arguments.memory_limit != 0 && !limit_memory(arguments.memory_limit)) {
    fmt::print(stderr, "foredraw: error: --memory-limit: this system cannot limit memory\n");
    return something_failed;
  }
  if (arguments.memory_limit == 0) {
    keep_freed_memory();
  } else {
    // Each thread has a stack and a heap of its own, which must not be what the limit goes on.
    constexpr std::uint64_t for_a_thread = std::uint64_t{64} << 20;
    const auto most = static_cast<int>(std::clamp<std::uint64_t>(arguments.memory_limit / for_a_thread, 1, 1024));
    arguments.threads = arguments.threads == 0 ? most : std::min(arguments.threads, most);
  }
  try {
    // Steps of their own say what they lacked it for.
    const Exit exit = with_memory(arguments.inputs.empty() ? "foredraw" : arguments.inputs[0], "begin", [&] {
      Registry known = registry;
      const Exit loaded = load_modules(asked.modules, arguments, known);
      return std::max(asked.command(known), loaded);
    });
    if (exit == interrupted) interruption->end_process();
    return exit;
  } catch (const OutOfMemory& lack) {
    tell_lack_of_memory(lack, arguments.memory_limit);
    return something_failed;
  }
}

}  // namespace

int main(int argc, char** argv, const Registry& registry) {
  try {
    const auto words = asked(argc, argv, registry);
    if (const auto* no = std::get_if<Misunderstood>(&words)) {
      tell_mistake(*no);
      return users_mistake;
    }
    const Asked& what = std::get<Asked>(words);
    return what.arguments == nullptr ? done : run(what, registry);
  } catch (const std::exception& problem) {  // no memory, most likely
    fmt::print(stderr, "foredraw: error: {}\n", problem.what());
    return something_failed;
  }
}

}  // namespace foredraw::cli
