#include <foredraw/modules/runs_apart.h>

#include <foredraw/modules/blocks.h>
#include <foredraw/modules/wire.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr int most_deaths = 3;

/// Tells the host what the worker said, message by message.
void repeat(std::string_view said, const foredraw_host& host) {
  const auto text = [](const std::optional<std::string>& words) { return words ? words->c_str() : nullptr; };
  for (WireReader in(said); !in.at_end();) {
    const auto what = static_cast<WorkerSaid>(in.number<std::uint32_t>());
    const auto first = in.text();
    switch (what) {
      case WorkerSaid::keep: host.keep(host.self, text(first)); break;
      case WorkerSaid::fail: host.fail(host.self, text(first)); break;
      case WorkerSaid::note: {
        const auto message = in.text();
        host.note(host.self, text(first), text(message));
        break;
      }
      case WorkerSaid::count: host.count(host.self, text(first), in.number<double>()); break;
      case WorkerSaid::measure: {
        const auto numerator = in.number<double>(), denominator = in.number<double>(), error = in.number<double>();
        host.measure(host.self, text(first), numerator, denominator, error);
        break;
      }
      default: throw std::runtime_error("it sent what is no message");
    }
  }
}

}  // namespace

std::string ModuleWorkers::tables() {
  auto worker = worker_for(0, 0);
  std::string tables = worker->tables();
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(worker));
  return tables;
}

std::unique_ptr<WorkerProcess> ModuleWorkers::worker_for(std::size_t question_bytes, std::size_t numbers) {
  {
    const std::scoped_lock lock(mutex_);
    if (deaths_ >= most_deaths) {
      throw std::runtime_error(
          fmt::format("its module is left out, because {} of its processes ended without an answer", most_deaths));
    }
    std::erase_if(idle_, [](const auto& worker) { return !worker->is_ours(); });  // this process is a fork of theirs
    const auto fitting =
        std::ranges::find_if(idle_, [&](const auto& worker) { return worker->has_room_for(question_bytes, numbers); });
    if (fitting != idle_.end()) {
      auto worker = std::move(*fitting);
      idle_.erase(fitting);
      return worker;
    }
    if (!idle_.empty()) idle_.pop_back();  // a larger one takes its place
  }
  return std::make_unique<WorkerProcess>(module_, limits_, question_bytes, numbers);
}

WorkerProcess::Answer ModuleWorkers::ask(const ForeignQuestion& question, const foredraw_host& host,
                                         const foredraw_answer& answer) {
  try {
    auto worker = worker_for(packed_size(question), question.numbers());
    auto answered = worker->ask(question, host, answer);
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(worker));
    return answered;
  } catch (const WorkerEnded&) {
    const std::scoped_lock lock(mutex_);
    ++deaths_;
    throw;
  }
}

void ModuleWorkers::rest() {
  std::vector<std::unique_ptr<WorkerProcess>> resting;
  {
    const std::scoped_lock lock(mutex_);
    resting.swap(idle_);
  }
  for (const auto& worker : resting) worker->begin_to_end();
}

int RunsApart::run(const foredraw_draw& draw, std::span<const foredraw_value> options, foredraw_answer& answer,
                   const foredraw_host& host) const {
  const auto answered =
      workers_->ask({plugin_, draw, options, host.seed, answer.count, answer.vertex_count, may_count_}, host, answer);
  repeat(answered.said, host);
  answer.count = answered.count;
  answer.vertex_count = answered.vertex_count;
  if (answered.left_out > 0) {
    host.note(host.self, "messages-left-out",
              fmt::format("{} messages more than there is room for", answered.left_out).c_str());
  }
  return answered.status;
}

}  // namespace foredraw
