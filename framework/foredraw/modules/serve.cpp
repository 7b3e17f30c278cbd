#include <foredraw/modules/serve.h>

#include <foredraw/modules/blocks.h>
#include <foredraw/modules/description.h>
#include <foredraw/modules/wire.h>
#include <foredraw/platform/shared_block.h>
#include <foredraw/platform/shared_library.h>
#include <foredraw/platform/watched_process.h>

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <vector>

namespace foredraw {

namespace {

/// The worker's side of the two blocks.
class Serving {
 public:
  Serving()
      : asked_(SharedBlock::handed(asked_descriptor, false)),
        answered_(SharedBlock::handed(answered_descriptor, true)),
        call_(*reinterpret_cast<const AskedCall*>(asked_.data())),
        answer_(*reinterpret_cast<AnsweredCall*>(answered_.data())),
        host_{
            .size = sizeof host_,
            .self = this,
            .cancelled = [](void* self) { return of(self).call_.cancelled.load() == 0 ? 0 : 1; },
            .keep = [](void* self, const char* reason) { of(self).say(WorkerSaid::keep, reason); },
            .fail = [](void* self, const char* message) { of(self).say(WorkerSaid::fail, message); },
            .note = [](void* self, const char* code,
                       const char* message) { of(self).say(WorkerSaid::note, code, message); },
            .count = [](void* self, const char* metric,
                        double number) { of(self).say(WorkerSaid::count, metric, number); },
            .measure = [](void* self, const char* metric, double numerator, double denominator,
                          double error) { of(self).say(WorkerSaid::measure, metric, numerator, denominator, error); },
            .count_overdraw = [](void* self, const std::uint32_t* order, std::uint64_t* shaded,
                                 std::uint64_t* visible) { return of(self).count_overdraw(order, shaded, visible); }} {}

  void begin(bool refused, const std::string& what) {
    answer_.refused = refused ? 1 : 0;
    put(what);
    set_and_wake(answer_.turn, static_cast<std::uint32_t>(BlockTurn::program));
  }

  /// Who says why it refuses is ended by the program, which may else see its end before its words.
  [[noreturn]] void refuse(const std::string& why) {
    begin(true, why);
    for (;;) wait_while(answer_.turn, answer_.turn.load(), INT_MAX);
  }

  /// No exception of the module's leaves this: nothing above could go on with one.
  [[noreturn]] void answer_calls(const foredraw_module& module) noexcept {
    for (;;) {
      wait_for_turn(BlockTurn::program);
      answer(*module.plugins[call_.plugin]);
      set_and_wake(answer_.turn, static_cast<std::uint32_t>(BlockTurn::program));
    }
  }

 private:
  /// Sleeps until the program has asked, or answered; it is its turn until then.
  void wait_for_turn(BlockTurn theirs) {
    while (answer_.turn.load() != static_cast<std::uint32_t>(BlockTurn::worker)) {
      wait_while(answer_.turn, static_cast<std::uint32_t>(theirs), INT_MAX);
    }
  }

  static Serving& of(void* self) { return *static_cast<Serving*>(self); }

  template <class T>
  const T* at(std::uint64_t place) const {
    return place == 0 ? nullptr : reinterpret_cast<const T*>(asked_.data() + place);
  }

  void answer(const foredraw_plugin& plugin) {
    streams_.clear();
    for (std::uint32_t i = 0; i < call_.stream_count; ++i) {
      const AskedStream& stream = at<AskedStream>(call_.streams)[i];
      streams_.push_back({at<char>(stream.semantic), at<std::byte>(stream.bytes), stream.stride, stream.component,
                          stream.components, stream.normalized});
    }
    options_.clear();
    for (std::uint32_t i = 0; i < call_.option_count; ++i) {
      const AskedOption& option = at<AskedOption>(call_.options)[i];
      options_.push_back({option.integer, option.number, at<char>(option.text)});
    }
    const foredraw_draw draw{.size = sizeof draw,
                             .vertex_count = call_.vertex_count,
                             .triangle_count = call_.triangle_count,
                             .name = at<char>(call_.name),
                             .indices = at<std::uint32_t>(call_.indices),
                             .positions = at<float>(call_.positions),
                             .stream_count = call_.stream_count,
                             .streams = streams_.data(),
                             .cluster_count = call_.cluster_count,
                             .cluster_offsets = at<std::uint32_t>(call_.cluster_offsets)};
    auto* values = reinterpret_cast<std::uint32_t*>(answered_.data() + values_place);
    foredraw_answer answer{values, call_.room, call_.vertex_room == 0 ? nullptr : values + call_.room,
                           call_.vertex_room};
    host_.seed = call_.seed;
    answer_.said_bytes = 0;
    answer_.left_out = 0;
    const int status = plugin.run(plugin.user, &draw, options_.data(), &answer, &host_);
    if (process_number() != self_) std::_Exit(0);  // a child that the module made, and that came back
    answer_.status = status;
    answer_.count = answer.count;
    answer_.vertex_count = answer.vertex_count;
  }

  /// The program counts; nobody else knows what is seen.
  int count_overdraw(const std::uint32_t* order, std::uint64_t* shaded, std::uint64_t* visible) {
    if (call_.may_count == 0) return FOREDRAW_MISTAKE;
    answer_.has_order = order != nullptr ? 1 : 0;
    if (order != nullptr) {
      auto* place = reinterpret_cast<std::uint32_t*>(answered_.data() + values_place) + call_.room + call_.vertex_room;
      std::copy_n(order, call_.triangle_count, place);
    }
    set_and_wake(answer_.turn, static_cast<std::uint32_t>(BlockTurn::counts));
    wait_for_turn(BlockTurn::counts);
    if (call_.counted == FOREDRAW_DONE && shaded != nullptr) *shaded = call_.shaded;
    if (call_.counted == FOREDRAW_DONE && visible != nullptr) *visible = call_.visible;
    return call_.counted;
  }

  template <class... Parts>
  void say(WorkerSaid what, Parts... parts) {
    WireWriter message;
    message.put(static_cast<std::uint32_t>(what));
    (message.put(parts), ...);
    if (!put(message.bytes())) ++answer_.left_out;
  }

  bool put(const std::string& bytes) {
    if (bytes.size() > said_room - answer_.said_bytes) return false;
    std::ranges::copy(bytes, reinterpret_cast<char*>(answered_.data() + said_place + answer_.said_bytes));
    answer_.said_bytes += static_cast<std::uint32_t>(bytes.size());
    return true;
  }

  const int self_ = process_number();
  SharedBlock asked_, answered_;
  const AskedCall& call_;
  AnsweredCall& answer_;
  foredraw_host host_;
  std::vector<foredraw_stream> streams_;
  std::vector<foredraw_value> options_;
};

using Entry = const foredraw_module*();

/// What a module of another major version exports tells of which.
std::string why_no_entry(const LoadedLibrary& library) {
  for (int major = 2; major < 10; ++major) {
    if (library.function<Entry>(fmt::format("foredraw_module_v{}", major)) == nullptr) continue;
    return fmt::format("it is for version {} of modules, but this program speaks {}.{}", major, +FOREDRAW_MODULE_MAJOR,
                       +FOREDRAW_MODULE_MINOR);
  }
  return "it exports no function foredraw_module_v1, so it is no module";
}

}  // namespace

void serve(const foredraw_module* module) {
  Serving worker;
  try {
    const std::string tables = written_down(module);
    if (tables.size() > said_room) throw std::invalid_argument("its tables are longer than a megabyte");
    worker.begin(false, tables);
  } catch (const std::invalid_argument& wrong) {
    worker.refuse(wrong.what());
  }
  worker.answer_calls(*module);
}

void serve_refusal(const std::string& why) { Serving().refuse(why); }

void serve_file(const std::filesystem::path& file) {
  try {
    const LoadedLibrary library(file);
    Entry* entry = library.function<Entry>("foredraw_module_v1");
    entry == nullptr ? serve_refusal(why_no_entry(library)) : serve(entry());
  } catch (const std::runtime_error& problem) {
    serve_refusal(problem.what());
  }
}

}  // namespace foredraw
