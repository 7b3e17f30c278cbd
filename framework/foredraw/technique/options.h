#pragma once
// Option tables. A row binds a member of an options struct to its name, and everything else follows from the rows:
// help, reference pages, the JSON Schema, checks, "did you mean". The default is the member's own initialiser.

#include <foredraw/base/copy_safe_variant.h>

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace foredraw {

/// A value as a pipeline spells it. monostate: an optional option left out.
using OptionValue = CopySafeVariant<std::monostate, bool, std::int64_t, double, std::string>;

/// By option name, checked against the table.
using Settings = std::map<std::string, OptionValue>;

/// Words of a pipeline's stage, which no option may be called.
inline constexpr std::string_view reserved_words[] = {"use", "only", "required", "enabled", "blended", "level"};

/// A file that an option names: by a path, which is empty where none is named. The host reads it; Run lends it.
struct ScenePath {
  std::string path;
};
struct ImagePath {
  std::string path;
};

/// `views` is a view set's word, its number, or a file's path (see ViewSet). `numbers` are a text with commas between
/// them; a single one may stand bare.
enum class OptionType { boolean, integer, number, text, choice, number_or_text, views, scene, image, numbers };

struct OptionSpec {
  std::string name;  ///< "cache-size"
  OptionType type = OptionType::text;
  OptionValue default_value;
  std::string doc;
  std::string unit;  ///< "entries"; may be empty
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  ///< of a choice

  bool optional = false;  ///< may be left unset; default_value may then be monostate
};

/// The value in a pipeline's words: 16, 1.05, true, "random" (with quotes where `quoted`).
std::string to_text(const OptionValue& value, bool quoted = false);

/// "3 to 1024 entries"; empty where any number will do.
std::string range_text(const OptionSpec& spec);

/// The value brought to the option's type (an integer where a number is wanted, a number's text where either will do),
/// or an explanation of why it does not fit: "'cache-size' is 2, but must be 3 to 65535 entries".
std::variant<OptionValue, std::string> fit(const OptionSpec& spec, const OptionValue& value);

/// "0.5, 0.25" taken apart, and put together. Nothing where it is something else, or one is not finite.
std::optional<std::vector<double>> numbers_in(std::string_view text);
std::string numbers_text(const std::vector<double>& numbers);

/// Whether the value is the path of a file, which counts from the folder of the pipeline that names it.
bool names_file(const OptionSpec& spec, const OptionValue& value);

/// What a number may be, with its unit.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  std::string unit = {};
};

template <class Options>
class OptionTable {
 public:
  /// A bool, integer, floating-point or string member, or an optional one of these; a list of numbers; or the path of a
  /// scene or an image, which may always be left out.
  template <class T, class Owner>
  requires std::derived_from<Options, Owner> OptionTable& row(T Owner::*member, std::string name, std::string doc,
                                                              Range range = {}) {
    OptionSpec spec = spec_of(std::move(name), std::move(doc), defaults_.*member);
    spec.least = range.least;
    spec.most = range.most;
    spec.unit = std::move(range.unit);
    return add(std::move(spec),
               [member](Options& options, const OptionValue& value) { options.*member = from_value<T>(value); });
  }

  /// A string member for which a bare number will do as well. `type`: number_or_text or views.
  OptionTable& number_or_text(std::string Options::*member, std::string name, std::string doc,
                              OptionType type = OptionType::number_or_text) {
    OptionSpec spec = spec_of(std::move(name), std::move(doc), defaults_.*member);
    spec.type = type;
    return add(std::move(spec), [member](Options& options, const OptionValue& value) {
      options.*member = std::get<std::string>(value);
    });
  }

  /// An enumeration member: each choice's name and value.
  template <class T, class Owner>
  requires std::derived_from<Options, Owner> OptionTable& choice(
      T Owner::*member, std::string name, std::string doc,
      std::vector<std::pair<std::string, std::type_identity_t<T>>> choices) {
    OptionSpec spec;
    spec.name = std::move(name);
    spec.type = OptionType::choice;
    spec.doc = std::move(doc);
    for (const auto& [word, value] : choices) {
      spec.choices.push_back(word);
      if (value == defaults_.*member) spec.default_value = word;
    }
    return add(std::move(spec), [member, choices = std::move(choices)](Options& options, const OptionValue& value) {
      for (const auto& [word, chosen] : choices) {
        if (word == std::get<std::string>(value)) options.*member = chosen;
      }
    });
  }

  const std::vector<OptionSpec>& specs() const { return specs_; }

  /// The options for settings that fit the table; what is not set keeps its default.
  Options read(const Settings& settings) const {
    Options options;
    apply(settings, options);
    return options;
  }

  /// The same onto options that there are.
  void apply(const Settings& settings, Options& options) const {
    for (std::size_t i = 0; i < specs_.size(); ++i) {
      if (const auto it = settings.find(specs_[i].name); it != settings.end()) set_[i](options, it->second);
    }
  }

 private:
  using Set = std::function<void(Options&, const OptionValue&)>;

  template <class T>
  static constexpr bool is_path = std::is_same_v<T, ScenePath> || std::is_same_v<T, ImagePath>;

  template <class T>
  struct Unwrapped {
    using type = T;
    static constexpr bool is_optional = false;
  };
  template <class T>
  struct Unwrapped<std::optional<T>> {
    using type = T;
    static constexpr bool is_optional = true;
  };

  template <class T>
  static OptionSpec spec_of(std::string name, std::string doc, const T& initial) {
    using Value = typename Unwrapped<T>::type;
    OptionSpec spec;
    spec.name = std::move(name);
    spec.doc = std::move(doc);
    if constexpr (is_path<Value>) {
      spec.type = std::is_same_v<Value, ScenePath> ? OptionType::scene : OptionType::image;
      spec.optional = true;
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      spec.type = OptionType::numbers;
    } else if constexpr (std::is_same_v<Value, bool>) {
      spec.type = OptionType::boolean;
    } else if constexpr (std::is_integral_v<Value>) {
      spec.type = OptionType::integer;
    } else if constexpr (std::is_floating_point_v<Value>) {
      spec.type = OptionType::number;
    }
    if constexpr (Unwrapped<T>::is_optional) {
      spec.optional = true;
      if (initial) spec.default_value = to_value(*initial);
    } else if constexpr (!is_path<Value>) {
      spec.default_value = to_value(initial);
    }
    return spec;
  }

  template <class T>
  static OptionValue to_value(const T& value) {
    if constexpr (std::is_same_v<T, std::vector<double>>) {
      return numbers_text(value);
    } else if constexpr (std::is_same_v<T, bool>) {
      return value;
    } else if constexpr (std::is_integral_v<T>) {
      return static_cast<std::int64_t>(value);
    } else if constexpr (std::is_floating_point_v<T>) {
      return static_cast<double>(value);
    } else {
      return std::string(value);
    }
  }

  template <class T>
  static T from_value(const OptionValue& value) {
    using Value = typename Unwrapped<T>::type;
    if constexpr (Unwrapped<T>::is_optional) {
      if (std::holds_alternative<std::monostate>(value)) return std::nullopt;
    }
    if constexpr (is_path<Value>) {
      return {std::get<std::string>(value)};
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      return numbers_in(std::get<std::string>(value)).value_or(Value());
    } else if constexpr (std::is_same_v<Value, bool>) {
      return std::get<bool>(value);
    } else if constexpr (std::is_integral_v<Value>) {
      return static_cast<Value>(std::get<std::int64_t>(value));
    } else if constexpr (std::is_floating_point_v<Value>) {
      return static_cast<Value>(std::get<double>(value));
    } else {
      return std::get<std::string>(value);
    }
  }

  OptionTable& add(OptionSpec spec, Set set) {
    specs_.push_back(std::move(spec));
    set_.push_back(std::move(set));
    return *this;
  }

  Options defaults_;
  std::vector<OptionSpec> specs_;
  std::vector<Set> set_;
};

}  // namespace foredraw
