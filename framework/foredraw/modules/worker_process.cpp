#include <foredraw/modules/worker_process.h>

#include <foredraw/base/printable.h>
#include <foredraw/modules/blocks.h>
#include <foredraw/platform/shared_library.h>
#include <foredraw/platform/supervised.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

namespace foredraw {

namespace {

namespace fs = std::filesystem;
constexpr double seconds_to_cancel = 2;
/// An interpreter takes a while to begin, on a busy machine above all.
double seconds_to_load(const ModuleLimits& limits) { return std::clamp(limits.seconds, 5.0, 60.0); }
/// Pages that nobody touches cost nothing, and a larger question would cost a new process.
constexpr std::size_t least_block = std::size_t{64} << 20;

std::size_t block_for(std::size_t bytes) { return std::max(least_block, 2 * bytes); }

AskedCall& asked_in(const SharedBlock& block) { return *reinterpret_cast<AskedCall*>(block.data()); }
AnsweredCall& answered_in(const SharedBlock& block) { return *reinterpret_cast<AnsweredCall*>(block.data()); }

fs::path found_worker(const ModuleLimits& limits) {
  if (!limits.worker.empty()) return limits.worker;
  const fs::path found = module_worker();
  if (found.empty()) {
    throw std::runtime_error(
        "the program foredraw-module, in which modules run, is not there: install it beside foredraw, or name it in "
        "the environment variable FOREDRAW_MODULE_WORKER");
  }
  return found;
}

}  // namespace

fs::path module_worker() {
  const char* named = std::getenv("FOREDRAW_MODULE_WORKER");
  if (named != nullptr && *named != '\0') return named;
  std::error_code error;
  for (const fs::path& from : {program_folder(), own_folder()}) {
    for (const char* way : {"", "../libexec/foredraw", "../../libexec/foredraw"}) {
      const fs::path place = from / way / "foredraw-module";
      if (!from.empty() && fs::exists(place, error)) return place.lexically_normal();
    }
  }
  return {};
}

WorkerProcess::WorkerProcess(const fs::path& module, const ModuleLimits& limits, std::size_t question_bytes,
                             std::size_t numbers)
    : seconds_(limits.seconds),
      memory_(limits.memory),
      asked_(block_for(question_bytes), true),
      answered_(block_for(values_place + numbers * sizeof(std::uint32_t)), false),
      process_(found_worker(limits),
               {std::to_string(process_number()), std::to_string(limits.memory), fs::absolute(module).string()},
               std::array{asked_.descriptor(), answered_.descriptor()}) {
  wait_for_turn(Clock::now(), seconds_to_load(limits), nullptr);
  if (answered_in(answered_).refused != 0) throw std::invalid_argument(printable(tables()));
}

bool WorkerProcess::has_room_for(std::size_t question_bytes, std::size_t numbers) const {
  return question_bytes <= asked_.size() && values_place + numbers * sizeof(std::uint32_t) <= answered_.size();
}

std::string WorkerProcess::tables() const {
  const std::size_t bytes = std::min<std::size_t>(answered_in(answered_).said_bytes, said_room);
  return {reinterpret_cast<const char*>(answered_.data() + said_place), bytes};
}

WorkerProcess::Answer WorkerProcess::ask(const ForeignQuestion& question, const foredraw_host& host,
                                         const foredraw_answer& answer) {
  pack(question, asked_.data());
  const auto* shared = reinterpret_cast<const std::uint32_t*>(answered_.data() + values_place);
  std::fill_n(reinterpret_cast<std::uint32_t*>(answered_.data() + values_place), question.room + question.vertex_room,
              ~std::uint32_t{0});
  AnsweredCall& call = answered_in(answered_);
  call.status = FOREDRAW_FAILED;
  const auto begin = Clock::now();
  for (BlockTurn was = BlockTurn::program;; was = BlockTurn::counts) {
    // Unless the worker ended meanwhile: whoever watches it has said how.
    replace_and_wake(call.turn, static_cast<std::uint32_t>(was), static_cast<std::uint32_t>(BlockTurn::worker));
    wait_for_turn(begin, seconds_, &host);
    if (call.turn.load() != static_cast<std::uint32_t>(BlockTurn::counts)) break;
    count_overdraw(question, host);
  }
  // What it left behind may still write there.
  Answer answered{call.status, call.count, call.vertex_count, tables(), call.left_out};
  std::copy_n(shared, question.room, answer.values);
  std::copy_n(shared + question.room, question.vertex_room, answer.vertex_from);
  return answered;
}

void WorkerProcess::count_overdraw(const ForeignQuestion& question, const foredraw_host& host) {
  AskedCall& call = asked_in(asked_);
  call.counted = FOREDRAW_MISTAKE;
  if (!question.may_count) return;
  const auto* shared =
      reinterpret_cast<const std::uint32_t*>(answered_.data() + values_place) + question.room + question.vertex_room;
  const std::vector<std::uint32_t> order(shared, shared + question.draw.triangle_count);  // which may change meanwhile
  const bool has_order = answered_in(answered_).has_order != 0 && !order.empty();
  call.counted = host.count_overdraw(host.self, has_order ? order.data() : nullptr, &call.shaded, &call.visible);
}

void WorkerProcess::wait_for_turn(Clock::time_point begin, double seconds, const foredraw_host* host) {
  using namespace std::chrono_literals;
  const SharedWord& turn = answered_in(answered_).turn;
  std::optional<Clock::time_point> cancelled;
  const auto since = [](Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); };
  for (;;) {
    const std::uint32_t whose = turn.load();
    if (whose == static_cast<std::uint32_t>(BlockTurn::program)) return;
    if (whose == static_cast<std::uint32_t>(BlockTurn::counts) && host != nullptr) return;
    if (whose == static_cast<std::uint32_t>(BlockTurn::ended)) throw WorkerEnded(how_it_ended());
    // Nobody wakes us where the process is killed that watches the worker.
    if (process_.ended_within(0ms) && turn.load() == whose) throw WorkerEnded("its process is no more");
    if (!cancelled && host != nullptr && host->cancelled(host->self) != 0) {
      asked_in(asked_).cancelled = 1;
      cancelled = Clock::now();
    }
    if (cancelled && since(*cancelled) > seconds_to_cancel) throw WorkerEnded("cancelled");
    if (since(begin) > seconds) throw WorkerEnded(fmt::format("it gave no answer within {} seconds", seconds));
    wait_while(turn, whose, 50);
  }
}

std::string WorkerProcess::how_it_ended() const {
  const AnsweredCall& call = answered_in(answered_);
  const int code = call.code;
  std::string text = call.by_signal != 0 ? fmt::format("its process was ended by {}", signal_name(code))
                                         : fmt::format("its process left without an answer (exit code {})", code);
  if (memory_ != 0 && call.peak_memory > memory_ / 10 * 9) {
    text += fmt::format(", holding all of the {} bytes of memory that it may have", memory_);
  }
  const std::size_t bytes = std::min<std::size_t>(call.last_words_bytes, sizeof call.last_words);
  std::string words = printable(std::string_view(call.last_words, bytes), "\n");
  while (!words.empty() && words.back() == '\n') words.pop_back();
  return words.empty() ? text : text + "; it wrote: " + words;
}

}  // namespace foredraw
