#include <foredraw/pipeline/sweep.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <tuple>
#include <variant>

namespace foredraw {

namespace {

constexpr std::size_t most = 1000;  // who asks for more has mistyped a step

std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (c == separator && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::optional<double> number_in(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// "1:1.5:0.05" as 1, 1.05, ... 1.5. Values are rounded to what people write, so that no 1.1500000000000001 comes up.
std::vector<std::string> values_of_range(double first, double last, double step) {
  const double steps = std::floor((last - first) / step + 1e-6);
  std::vector<std::string> values;
  for (int i = 0; i <= static_cast<int>(steps); ++i) values.push_back(fmt::format("{:.10g}", first + i * step));
  return values;
}

struct Complaint {
  std::string message;
  std::string hint;
};

std::variant<std::vector<std::string>, Complaint> values_in(const std::string& text) {
  const std::vector<std::string> range = parts_of(text, ':');
  if (range.size() == 1) {
    std::vector<std::string> values = parts_of(text, ',');
    for (const std::string& value : values) {
      if (value.empty()) return Complaint{"a value is empty", "such as 1:1.5:0.05, or fast,high"};
    }
    if (values.size() > most)
      return Complaint{fmt::format("there are {} values, more than {}", values.size(), most), ""};
    return values;
  }
  std::vector<double> numbers;
  for (const std::string& part : range) {
    if (const auto number = number_in(part)) numbers.push_back(*number);
  }
  if (numbers.size() != 3 || range.size() != 3) {
    return Complaint{fmt::format("expected FIRST:LAST:STEP, three numbers, found '{}'", text), "such as 1:1.5:0.05"};
  }
  const auto [first, last, step] = std::tuple(numbers[0], numbers[1], numbers[2]);
  if (step == 0 || (last - first) / step < 0) {
    return Complaint{fmt::format("steps of {} do not lead from {} to {}", step, first, last), "such as 1:1.5:0.05"};
  }
  if ((last - first) / step >= most) {
    return Complaint{fmt::format("there are more than {} values", most), "take larger steps"};
  }
  return values_of_range(first, last, step);
}

/// A pipeline on its way through the sweeps.
struct Variant {
  Pipeline pipeline;
  std::string name;
  std::string set;  ///< "linear-clusters.growth=1.05, lookahead.quality=high"
};

/// What set_option() says, and where it put a value, are of a sweep.
Diagnostic as_of_sweep(Diagnostic diagnostic) {
  if (diagnostic.where.file == "--set") diagnostic.where.file = "--sweep";
  return diagnostic;
}
void tell_as_of_sweep(Pipeline& pipeline) {
  for (Stage& stage : pipeline.stages) {
    for (auto& [option, where] : stage.option_where) {
      if (where.file == "--set") where.file = "--sweep";
    }
  }
}

bool measures_with(const Pipeline& pipeline, const Sweep& sweep) {
  const std::string stage = sweep.option.substr(0, sweep.option.find('.'));
  return std::ranges::find(pipeline.measure, stage, &Stage::use) != pipeline.measure.end();
}

Diagnostic only_measures(const Sweep& sweep) {
  return {Severity::error,
          {"--sweep", 1, 1, {}},
          "only-measures",
          fmt::format("'{}' belongs to an evaluator, but all pipelines are measured alike", sweep.option),
          "use --set to change it for all pipelines"};
}

/// Of several pipelines without the stage, what is told of the one that has a stage of nearly that name.
void remember(std::optional<Diagnostic>& nowhere, Diagnostic diagnostic) {
  if (!nowhere || diagnostic.hint.starts_with("did you mean")) nowhere = std::move(diagnostic);
}

std::optional<std::vector<Variant>> swept_once(const std::vector<Variant>& variants, const Sweep& sweep,
                                               Diagnostics& diagnostics) {
  std::vector<Variant> made;
  std::optional<Diagnostic> nowhere;
  bool found = false;
  for (const Variant& variant : variants) {
    for (const std::string& value : sweep.values) {
      Variant one = variant;
      one.pipeline.measure.clear();  // figures measured differently are no comparison
      Diagnostics here;
      if (!set_option(one.pipeline, sweep.option + '=' + value, here)) {
        const Diagnostic& why = here.all().front();
        if (why.code != "no-such-stage") {
          diagnostics.add(as_of_sweep(why));
          return std::nullopt;
        }
        remember(nowhere, measures_with(variant.pipeline, sweep) ? only_measures(sweep) : as_of_sweep(why));
        made.push_back(variant);
        break;
      }
      one.pipeline.measure = variant.pipeline.measure;
      found = true;
      tell_as_of_sweep(one.pipeline);
      one.set += fmt::format("{}{}={}", one.set.empty() ? "" : ", ", sweep.option, value);
      made.push_back(std::move(one));
    }
  }
  if (!found) diagnostics.add(*nowhere);
  return found ? std::optional(std::move(made)) : std::nullopt;
}

}  // namespace

std::optional<Sweep> parse_sweep(const std::string& text, Diagnostics& diagnostics) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    diagnostics.error({"--sweep", 1, 1, {}}, "syntax", fmt::format("expected stage.option=values, found '{}'", text),
                      "such as linear-clusters.growth=1:1.5:0.05, or lookahead.quality=fast,high");
    return std::nullopt;
  }
  auto values = values_in(text.substr(equals + 1));
  if (const auto* refusal = std::get_if<Complaint>(&values)) {
    diagnostics.error({"--sweep", 1, static_cast<int>(equals) + 2, {}}, "bad-value", refusal->message, refusal->hint);
    return std::nullopt;
  }
  return Sweep{text.substr(0, equals), std::get<std::vector<std::string>>(std::move(values))};
}

std::optional<std::vector<NamedPipeline>> swept(std::vector<NamedPipeline> pipelines, std::span<const Sweep> sweeps,
                                                Diagnostics& diagnostics) {
  std::vector<Variant> variants;
  for (NamedPipeline& named : pipelines) variants.push_back({std::move(named.pipeline), std::move(named.name), ""});
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const Sweep& sweep = sweeps[i];
    if (std::ranges::count(sweeps.first(i), sweep.option, &Sweep::option) > 0) {
      diagnostics.error({"--sweep", 1, 1, {}}, "bad-value", fmt::format("'{}' is swept twice", sweep.option),
                        "name all its values in one sweep");
      return std::nullopt;
    }
    auto made = swept_once(variants, sweep, diagnostics);
    if (!made) return std::nullopt;
    if (made->size() > most) {
      diagnostics.error({"--sweep", 1, 1, {}}, "bad-value",
                        fmt::format("there would be {} pipelines, more than {}", made->size(), most),
                        "take larger steps, or sweep one option at a time");
      return std::nullopt;
    }
    variants = std::move(*made);
  }
  pipelines.clear();
  for (Variant& variant : variants) {
    if (!variant.set.empty()) variant.name += " with " + variant.set;
    pipelines.push_back({std::move(variant.name), std::move(variant.pipeline)});
  }
  return pipelines;
}

}  // namespace foredraw
