#include <foredraw/modules/foreign_technique.h>

#include <foredraw/base/printable.h>
#include <foredraw/modules/draws_for_c.h>
#include <foredraw/modules/foreign_host.h>
#include <foredraw/modules/remeshed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <stdexcept>

namespace foredraw {

namespace {

/// Values of options as C takes them, with the texts that they refer to.
class ForeignValues {
 public:
  ForeignValues(const std::vector<OptionSpec>& options, const Settings& settings) {
    for (const OptionSpec& option : options) {
      const auto set = settings.find(option.name);
      const OptionValue& chosen = set == settings.end() ? option.default_value : set->second;
      foredraw_value& value = values_.emplace_back();
      if (const auto* flag = std::get_if<bool>(&chosen)) value.integer = *flag ? 1 : 0;
      if (const auto* whole = std::get_if<std::int64_t>(&chosen)) value.integer = *whole;
      if (const auto* real = std::get_if<double>(&chosen)) value.number = *real;
      if (const auto* text = std::get_if<std::string>(&chosen)) value.text = texts_.emplace_back(*text).c_str();
    }
  }
  ForeignValues(ForeignValues&&) = default;  // a copy's values would refer to the other one's texts

  std::span<const foredraw_value> values() const { return values_; }

 private:
  std::vector<foredraw_value> values_;
  std::deque<std::string> texts_;
};

/// A technique with its options.
class ForeignCall {
 public:
  ForeignCall(const ForeignKind& kind, const Settings& settings, std::shared_ptr<const ForeignRunner> runner)
      : options_(kind.options, settings), metrics_(kind.metrics), runner_(std::move(runner)) {}

  /// The first `room` numbers of what it wrote, or as many as it says. Throws what it failed of. `overdraw`: null where
  /// it may not ask.
  std::vector<std::uint32_t> run(const foredraw_draw& draw, std::size_t room, Run& run,
                                 DrawOverdraw* overdraw = nullptr) const {
    return remesh(draw, room, 0, run, overdraw).indices;
  }

  /// The same with numbers of vertices besides.
  Remesh remesh(const foredraw_draw& draw, std::size_t room, std::size_t vertex_room, Run& run,
                DrawOverdraw* overdraw = nullptr) const {
    std::vector<std::uint32_t> values(room, ~std::uint32_t{0}), vertex_from(vertex_room, ~std::uint32_t{0});
    foredraw_answer answer{values.data(), room, vertex_room == 0 ? nullptr : vertex_from.data(), vertex_room};
    ForeignHost host(run, metrics_, overdraw);
    const int status = runner_->run(draw, options_.values(), answer, host.table());
    host.end();
    if (status == FOREDRAW_CANCELLED) throw std::runtime_error("cancelled");
    if (host.failure() || status != FOREDRAW_DONE) {
      throw std::runtime_error(host.failure().value_or(fmt::format("it returned {}", status)));
    }
    check_room(answer.count, room, "numbers");
    check_room(answer.vertex_count, vertex_room, "vertices");
    values.resize(answer.count), vertex_from.resize(answer.vertex_count);
    return {std::move(values), std::move(vertex_from)};
  }

 private:
  static void check_room(std::uint64_t count, std::size_t room, const char* what) {
    if (count <= room) return;
    throw std::runtime_error(fmt::format("its answer has {} {}, but there is room for {}", count, what, room));
  }

  ForeignValues options_;
  std::vector<Metric> metrics_;
  std::shared_ptr<const ForeignRunner> runner_;
};

/// A draw as it is handed over, with what it refers to.
struct HandedDraw {
  HandedDraw(const VertexStreams& vertices, std::span<const std::uint32_t> indices, const Clusters* clusters, Run& run)
      : positions(positions_of(run.analyses, vertices)),
        streams(streams_for_c(vertices)),
        draw(draw_for_c(vertices, indices, positions->values.empty() ? nullptr : &positions->values.front().x, streams,
                        clusters)) {}
  HandedDraw(const DrawView& view, Run& run)
      : HandedDraw(view.vertices(), view.indices(), view.stream().clusters ? &*view.stream().clusters : nullptr, run) {
    draw.name = view.draw().name.c_str();
  }

  std::shared_ptr<const Positions> positions;
  std::vector<foredraw_stream> streams;
  foredraw_draw draw;
};

struct ForeignOrderer final : DrawOrderer {
  explicit ForeignOrderer(ForeignCall what) : call(std::move(what)) {}
  IndexOrder order(const DrawView& view, Run& run) const override {
    DrawOverdraw overdraw(view, run);
    return call.run(HandedDraw(view, run).draw, view.triangle_count(), run,
                    run.overdraw == nullptr ? nullptr : &overdraw);
  }
  ForeignCall call;
};

struct ForeignVertexOrderer final : VertexOrderer {
  explicit ForeignVertexOrderer(ForeignCall what) : call(std::move(what)) {}
  VertexOrder order(const VertexUse& use, Run& run) const override {
    std::vector<std::uint32_t> indices;
    for (const auto& stream : use.index_streams) indices.insert(indices.end(), stream.begin(), stream.end());
    return call.run(HandedDraw(use.vertices, indices, nullptr, run).draw, use.vertices.count, run);
  }
  ForeignCall call;
};

struct ForeignClusterer final : Clusterer {
  explicit ForeignClusterer(ForeignCall what) : call(std::move(what)) {}
  Clusters cluster(const DrawView& view, Run& run) const override {
    return {call.run(HandedDraw(view, run).draw, view.triangle_count() + 1, run)};
  }
  ForeignCall call;
};

struct ForeignEvaluator final : DrawEvaluator {
  explicit ForeignEvaluator(ForeignCall what) : call(std::move(what)) {}
  void evaluate(const DrawView& view, Run& run) const override {
    DrawOverdraw overdraw(view, run);
    call.run(HandedDraw(view, run).draw, 0, run, run.overdraw == nullptr ? nullptr : &overdraw);
  }
  ForeignCall call;
};

struct ForeignRemesher final : DrawProcessor {
  explicit ForeignRemesher(ForeignCall what) : call(std::move(what)) {}
  Draw process(const DrawView& view, Run& run) const override {
    Remesh answer = call.remesh(HandedDraw(view, run).draw, 3 * view.triangle_count(), view.vertex_count(), run);
    return run.keeps() ? view.draw() : remeshed(view.draw(), std::move(answer));
  }
  ForeignCall call;
};

}  // namespace

Technique foreign_technique(const ForeignKind& kind, const Settings& settings,
                            std::shared_ptr<const ForeignRunner> runner) {
  ForeignCall call(kind, settings, std::move(runner));
  switch (kind.kind) {
    case FOREDRAW_TRIANGLE_ORDERER: return std::make_unique<ForeignOrderer>(std::move(call));
    case FOREDRAW_VERTEX_ORDERER: return std::make_unique<ForeignVertexOrderer>(std::move(call));
    case FOREDRAW_CLUSTERER: return std::make_unique<ForeignClusterer>(std::move(call));
    case FOREDRAW_REMESHER: return std::make_unique<ForeignRemesher>(std::move(call));
    default: return std::make_unique<ForeignEvaluator>(std::move(call));
  }
}

std::string text_from_c(const char* text) {
  constexpr std::size_t most = 4000;
  return text == nullptr ? std::string() : printable(std::string_view(text, strnlen(text, most)));
}

}  // namespace foredraw
