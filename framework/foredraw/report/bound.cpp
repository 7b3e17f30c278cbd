#include <foredraw/report/bound.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace foredraw {

namespace {

/// Reads a bound from left to right.
class BoundReader {
 public:
  BoundReader(const std::string& text, Diagnostics& diagnostics) : text_(text), diagnostics_(diagnostics) {}

  std::optional<Bound> read() {
    Bound bound;
    bound.text = text_;
    bound.figure = word();
    if (bound.figure != "time" && bound.figure.find('.') == std::string::npos) {
      return wrong("EVALUATOR.METRIC or time");
    }
    const auto than = comparison();
    if (!than) return wrong("one of > >= < <=");
    bound.than = *than;
    skip_spaces();
    const std::size_t limit = at_;
    const std::string beside = word();
    if (beside == "baseline" || beside == "input") {
      bound.beside = beside == "input" ? Bound::Beside::input : Bound::Beside::baseline;
      bound.factor = 1;
      if (take('*') && !number(bound.factor)) return wrong("a number");
      const bool less = take('-');
      if ((less || take('+')) && !number(bound.added)) return wrong("a number");
      if (less) bound.added = -bound.added;
    } else {
      at_ = limit;
      if (!number(bound.added)) return wrong("a number, baseline or input");
    }
    skip_spaces();
    return at_ == text_.size() ? std::optional(bound) : wrong("its end");
  }

 private:
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool take(char letter) {
    skip_spaces();
    if (at_ == text_.size() || text_[at_] != letter) return false;
    ++at_;
    return true;
  }

  /// Up to a space or what can not be in a figure's name.
  std::string word() {
    skip_spaces();
    const std::size_t end = std::min(text_.find_first_of(" <>=*", at_), text_.size());
    const std::string word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }

  std::optional<Bound::Than> comparison() {
    if (take('>')) return at_ < text_.size() && text_[at_] == '=' ? (++at_, Bound::Than::from) : Bound::Than::above;
    if (take('<')) return at_ < text_.size() && text_[at_] == '=' ? (++at_, Bound::Than::to) : Bound::Than::below;
    return std::nullopt;
  }

  bool number(double& value) {
    skip_spaces();
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return false;
    at_ = static_cast<std::size_t>(end - text_.data());
    return true;
  }

  std::nullopt_t wrong(const std::string& expected) {
    diagnostics_.error({}, "bad-bound",
                       fmt::format("'{}' is not a bound: expected {} at '{}'", text_, expected, text_.substr(at_)),
                       "such as overdraw-raster.ratio > baseline * 1.01");
    return std::nullopt;
  }

  const std::string& text_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
};

bool is_out(const Bound& bound, double value, double limit) {
  switch (bound.than) {
    case Bound::Than::above: return value > limit;
    case Bound::Than::from: return value >= limit;
    case Bound::Than::below: return value < limit;
    case Bound::Than::to: break;
  }
  return value <= limit;
}

void judge_file(const Bound& bound, const Comparison& comparison, const Baseline* stored, Diagnostics& diagnostics) {
  const std::string& path = comparison.input.path;
  const auto unknown = [&](const std::string& whose) {
    diagnostics.error({.file = path}, "unknown-figure",
                      fmt::format("'{}' cannot be checked: {} has no figure '{}'", bound.text, whose, bound.figure),
                      "--json lists all figures by evaluator and metric; add its evaluator with --with");
  };
  std::optional<double> beside = 0;
  if (bound.beside == Bound::Beside::input) {
    beside = input_value(comparison, bound.figure);
    if (!beside) return unknown("the input");
  } else if (bound.beside == Bound::Beside::baseline && stored != nullptr) {
    const auto* file = stored->find(path);
    if (file == nullptr) {
      return diagnostics.error(
          {.file = path}, "unknown-baseline",
          fmt::format("'{}' cannot be checked: the stored baseline does not have this file", bound.text),
          "the baseline must have the file by the same path, or by a name that no other file in it has");
    }
    if (!file->second.contains(bound.figure)) return unknown("the stored baseline of this file");
    beside = file->second.at(bound.figure);
  } else if (bound.beside == Bound::Beside::baseline) {
    beside = value_of(comparison.branches.front(), bound.figure);
    if (!beside) return unknown("the first pipeline");
  }
  const double limit = bound.factor * *beside + bound.added;
  const bool is_baseline_first = bound.beside == Bound::Beside::baseline && stored == nullptr;
  for (std::size_t i = is_baseline_first ? 1 : 0; i < comparison.branches.size(); ++i) {
    const Branch& branch = comparison.branches[i];
    const std::optional<double> value = value_of(branch, bound.figure);
    if (!value) return unknown(branch.name);
    if (!is_out(bound, *value, limit)) continue;
    diagnostics.error({.file = path}, "out-of-bounds",
                      fmt::format("{} is {:.6g} after [{}] {}; the bound is {:.6g}: {}", bound.figure, *value, i + 1,
                                  branch.name, limit, bound.text));
  }
}

}  // namespace

std::optional<Bound> parse_bound(const std::string& text, Diagnostics& diagnostics) {
  return BoundReader(text, diagnostics).read();
}

void judge(std::span<const Bound> bounds, std::span<const Comparison> comparisons, const Baseline* stored,
           Diagnostics& diagnostics) {
  for (const Comparison& comparison : comparisons) {
    if (comparison.is_lost()) continue;  // which is an error of its own
    for (const Bound& bound : bounds) judge_file(bound, comparison, stored, diagnostics);
  }
}

}  // namespace foredraw
