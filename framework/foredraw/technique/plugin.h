#pragma once
// A plugin: a card, an option table, and a maker of the technique.

#include <foredraw/scene/product_row.h>
#include <foredraw/technique/clusterer.h>
#include <foredraw/technique/evaluator.h>
#include <foredraw/technique/options.h>
#include <foredraw/technique/orderer.h>
#include <foredraw/technique/processor.h>

#include <functional>
#include <memory>
#include <variant>

namespace foredraw {

class OverdrawService;  // measuring/overdraw_service.h

enum class Kind { orderer, clusterer, processor, evaluator };
std::string_view to_text(Kind kind);

/// A technique of any shape. Working never changes it, so several threads and several runs may use it at once.
using Technique =
    std::variant<std::unique_ptr<DrawOrderer>, std::unique_ptr<SubjectOrderer>, std::unique_ptr<VertexOrderer>,
                 std::unique_ptr<Clusterer>, std::unique_ptr<Processor>, std::unique_ptr<DrawProcessor>,
                 std::unique_ptr<Evaluator>, std::unique_ptr<DrawEvaluator>>;

struct Metric {
  std::string name;  ///< "acmr"
  std::string unit;  ///< "misses per triangle"
  std::string doc;
  bool lower_is_better = true;
  bool worst_stands = false;  ///< over several places the worst one stands, not their sum
  bool is_neutral = false;    ///< no gain and no loss where it changes: a count of what other figures leave out
};

/// What a plugin says of itself before it is made.
struct Card {
  std::string name;            ///< "dot-rule"
  std::string summary;         ///< one sentence
  std::string reference;       ///< paper and section; "own" where it is ours
  Traits acts_on;              ///< a draw without these is skipped
  Traits needs;                ///< a plan without these is refused
  Traits wants;                ///< does far better with these: a plan without them gets a warning
  Traits uses;                 ///< works with these where a draw has them, and as well without
  Traits provides;             ///< hold afterwards
  Traits breaks;               ///< no longer hold afterwards
  std::string pays_if;         ///< where it asks at run time whether anything can be gained: when that is; else empty
  bool uses_overdraw = false;  ///< asks run.overdraw
  bool lossless = false;       ///< a processor that promises the same triangles with the same vertex data: certified
  std::vector<std::string> measured_by;  ///< evaluators that show what it gains; none: those of @default do
  std::vector<Metric> metrics;
};

struct Plugin {
  Card card;
  Kind kind = Kind::orderer;
  std::vector<OptionSpec> options;
  std::function<Technique(const Settings&)> create;
  /// Why this machine can not run it ("no Vulkan device"); nothing, or no function: it can.
  std::function<std::optional<std::string>()> unavailable = {};
  /// The device that its answers depend on under these settings, as its driver names it; empty, or no function: they
  /// depend on scene and options alone, and are the same everywhere.
  std::function<std::string(const Settings&)> device = {};
  /// An evaluator that can answer for measured overdraw makes its service here, with options of the service's own: who
  /// asks brings views and scene.
  std::function<std::unique_ptr<OverdrawService>(const Settings&)> overdraw_service = {};
  bool exact = false;  ///< its service counts exactly: asked first where a pipeline names none
  std::vector<OptionSpec> service_options = {};
  /// Of what it makes beside triangles and vertices. Several plugins may make the same product.
  ProductRows products = {};
};

/// An option table bound to a maker: plugin.create reads the settings into Options and calls make(options).
template <class Options, class Make>
void bind_options(Plugin& plugin, OptionTable<Options> table, Make make) {
  plugin.options = table.specs();
  plugin.create = [table = std::move(table), make = std::move(make)](const Settings& settings) -> Technique {
    return make(table.read(settings));
  };
}

}  // namespace foredraw
