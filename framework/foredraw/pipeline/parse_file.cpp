#include <foredraw/pipeline/output_words.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/pipeline/private/line_scanner.h>
#include <foredraw/pipeline/private/toml.h>
#include <foredraw/pipeline/private/words.h>

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace foredraw {

namespace {

constexpr std::int64_t format_version = 1;

// toml++ goes as deep into the stack as a dotted key has names, and knows no limit there.
constexpr std::ptrdiff_t most_dots = 4096;

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "a list";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "a whole number";
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    default: return "a date or time";
  }
}

class FileReader {
 public:
  FileReader(const std::string& name, Diagnostics& diagnostics) : name_(name), diagnostics_(diagnostics) {}

  std::vector<NamedPipeline> read(const toml::table& root) {
    const Pipeline whole = read_pipeline(root);
    const toml::table* rows = table_in(root, "compare");
    if (rows == nullptr) return {{name_, whole}};
    std::vector<NamedPipeline> branches;
    for (const std::string& row : rows_from_the_top(*rows)) {
      Pipeline branch = whole;
      for (Stage& stage : read_list(*rows, row, "compare." + row)) branch.stages.push_back(std::move(stage));
      branches.push_back({name_ + ": " + row, std::move(branch)});
    }
    if (branches.empty()) {
      error(at(rows->source(), "compare"), "bad-value", "'compare' has no pipelines",
            "add rows such as sorted = [\"linear-clusters\", \"dot-rule\"]");
    }
    return branches;
  }

 private:
  Pipeline read_pipeline(const toml::table& root) {
    check_version(root);
    const auto words = pipeline_words();
    Pipeline pipeline = words.read(fitted(root, words.specs(),
                                          {"pipeline", "stages", "measure", "compare", "views", "poses", "subjects",
                                           "frames", "output", "services", "modules"},
                                          ""));
    pipeline.modules = read_modules(root);
    pipeline.stages = read_list(root, "stages", "stages");
    pipeline.measure = read_list(root, "measure", "measure");
    if (const toml::table* table = table_in(root, "views")) {
      pipeline.views = read_set(*table, "views", view_words());
      pipeline.views_where = at(table->source(), "views");
    }
    if (const toml::table* table = table_in(root, "poses")) {
      pipeline.poses = read_set(*table, "poses", pose_words());
      pipeline.poses_where = at(table->source(), "poses");
    }
    if (const toml::table* table = table_in(root, "subjects")) {
      const auto words = subject_words();
      pipeline.subjects = words.read(fitted(*table, words.specs(), {}, "subjects"));
    }
    if (const toml::table* table = table_in(root, "frames")) {
      pipeline.frames = read_set(*table, "frames", frame_words());
      pipeline.frames_where = at(table->source(), "frames");
    }
    if (const toml::table* table = table_in(root, "output")) {
      const auto words = output_words();
      pipeline.output = words.read(fitted(*table, words.specs(), {}, "output"));
    }
    if (const toml::table* table = table_in(root, "services")) pipeline.overdraw = read_services(*table);
    return pipeline;
  }

  /// toml++ keeps a table by its keys' names; the first pipeline of a comparison is the one that was written first.
  static std::vector<std::string> rows_from_the_top(const toml::table& table) {
    std::vector<std::tuple<toml::source_index, toml::source_index, std::string>> rows;
    for (const auto& [key, node] : table) {
      rows.emplace_back(key.source().begin.line, key.source().begin.column, std::string(key.str()));
    }
    std::ranges::sort(rows);
    std::vector<std::string> names;
    for (const auto& row : rows) names.push_back(std::get<2>(row));
    return names;
  }

  Where at(const toml::source_region& region, std::string inside) const {
    return {name_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), std::move(inside)};
  }

  void error(Where where, std::string code, std::string message, std::string hint = {}) {
    diagnostics_.error(std::move(where), std::move(code), std::move(message), std::move(hint));
  }

  void wrong_kind(const toml::node& node, std::string inside, std::string_view what, std::string_view wanted,
                  std::string hint = {}) {
    error(at(node.source(), std::move(inside)), "bad-value",
          fmt::format("{} must be {}, not {}", what, wanted, kind_of(node)), std::move(hint));
  }

  void check_version(const toml::table& root) {
    const toml::node* node = root.get("pipeline");
    if (node == nullptr) {
      error({name_, 1, 1, {}}, "missing-version", "'pipeline' is missing",
            fmt::format("add pipeline = {} as its first line", format_version));
    } else if (!node->is_integer()) {
      wrong_kind(*node, "", "'pipeline'", fmt::format("the format's version, {}", format_version));
    } else if (node->as_integer()->get() != format_version) {
      error(at(node->source(), ""), "unknown-version",
            fmt::format("'pipeline' is {}, but this program reads only version {} of the format",
                        node->as_integer()->get(), format_version),
            fmt::format("write pipeline = {}", format_version));
    }
  }

  std::optional<OptionValue> value_of(const toml::node& node, std::string_view key, const std::string& inside) {
    if (const auto* truth = node.as_boolean()) return truth->get();
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* text = node.as_string()) return text->get();
    wrong_kind(node, inside, fmt::format("'{}'", key), "a string, a number, true or false");
    return std::nullopt;
  }

  void unknown_key(const toml::key& key, const std::string& inside, std::vector<std::string> known) {
    const std::string_view near = nearest(key.str(), known);
    error(at(key.source(), inside), "unknown-key", fmt::format("there is no '{}' here", key.str()),
          near.empty() ? fmt::format("there are {}", fmt::join(known, ", ")) : fmt::format("did you mean '{}'?", near));
  }

  /// The values that the rows ask for; whatever is neither in a row nor in `others` is unknown.
  Settings fitted(const toml::table& table, const std::vector<OptionSpec>& rows, const std::vector<std::string>& others,
                  const std::string& inside) {
    std::vector<std::string> known = others;
    for (const OptionSpec& row : rows) known.push_back(row.name);
    Settings settings;
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      const auto row = std::ranges::find(rows, name, &OptionSpec::name);
      if (row == rows.end()) {
        if (std::ranges::find(others, name) == others.end()) unknown_key(key, inside, known);
        continue;
      }
      const auto value = value_of(node, name, inside);
      if (!value) continue;
      auto result = fit(*row, *value);
      if (const auto* why = std::get_if<std::string>(&result)) {
        error(at(node.source(), inside), "bad-value", *why);
      } else {
        settings[name] = std::get<OptionValue>(std::move(result));
      }
    }
    return settings;
  }

  const toml::table* table_in(const toml::table& root, std::string_view name) {
    const toml::node* node = root.get(name);
    if (node == nullptr || node->is_table()) return node == nullptr ? nullptr : node->as_table();
    wrong_kind(*node, "", fmt::format("'{}'", name), "a table", fmt::format("begin it with [{}]", name));
    return nullptr;
  }

  std::vector<Stage> read_list(const toml::table& table, const std::string& name, const std::string& inside) {
    std::vector<Stage> stages;
    const toml::node* node = table.get(name);
    if (node == nullptr) return stages;
    if (!node->is_array()) {
      wrong_kind(*node, "", fmt::format("'{}'", inside), "a list", fmt::format("write {} = [ ... ]", name));
      return stages;
    }
    const toml::array& list = *node->as_array();
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (auto stage = read_stage(list[i], fmt::format("{}[{}]", inside, i))) stages.push_back(std::move(*stage));
    }
    return stages;
  }

  std::vector<ModuleDemand> read_modules(const toml::table& root) {
    std::vector<ModuleDemand> modules;
    const toml::node* node = root.get("modules");
    if (node == nullptr) return modules;
    constexpr std::string_view such_as = "such as modules = [\"acme\", \"beta >= 1.2\"]";
    if (!node->is_array()) {
      wrong_kind(*node, "", "'modules'", "a list", std::string(such_as));
      return modules;
    }
    const toml::array& list = *node->as_array();
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Where where = at(list[i].source(), fmt::format("modules[{}]", i));
      const auto* text = list[i].as_string();
      auto demand = text == nullptr ? std::nullopt : module_demand(text->get());
      if (!demand) {
        error(where, "bad-value", "a module must be a vendor, and the least version behind >=", std::string(such_as));
        continue;
      }
      demand->where = where;
      modules.push_back(std::move(*demand));
    }
    return modules;
  }

  std::optional<Stage> read_stage(const toml::node& node, const std::string& inside) {
    if (const auto* text = node.as_string()) return read_stage_text(text->get(), node.source(), inside);
    if (const auto* table = node.as_table()) return read_stage_table(*table, inside);
    wrong_kind(node, inside, "a stage", "a string or a table",
               "such as \"weld\" or { use = \"tipsify\", cache-size = 16 }");
    return std::nullopt;
  }

  std::optional<Stage> read_stage_table(const toml::table& table, const std::string& inside) {
    StageWords words;
    bool good = true;
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (auto value = value_of(node, name, inside)) {
        words.values[name] = std::move(*value);
        words.where[name] = at(node.source(), inside);
      } else {
        good = false;
      }
    }
    auto stage = stage_of(words, at(table.source(), inside), diagnostics_);
    return good ? stage : std::nullopt;
  }

  /// A text is a stage in the one-line form, with options or without.
  std::optional<Stage> read_stage_text(const std::string& text, const toml::source_region& region,
                                       const std::string& inside) {
    // Between plain quotes every character is as far from the beginning as it looks.
    const auto characters =
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    const bool exact = region.begin.line == region.end.line &&
                       region.begin.column + static_cast<std::size_t>(characters) + 2 == region.end.column;
    TextPlace place{at(region, inside), exact};
    if (exact) ++place.start.column;
    auto stages = scan_stages(text, place, diagnostics_);
    if (!stages) return std::nullopt;
    if (stages->size() == 1) return std::move(stages->front());
    error(at(region, inside), "bad-value", fmt::format("expected one stage, found {}", stages->size()),
          "write each stage as a string of its own");
    return std::nullopt;
  }

  /// A set of views, poses or frames.
  template <class Set>
  Set read_set(const toml::table& table, const std::string& name, const OptionTable<Set>& words) {
    const Set set = words.read(fitted(table, words.specs(), {}, name));
    if (const auto mistake = mistake_in(set)) error(at(table.source(), name), "bad-" + name, *mistake);
    return set;
  }

  std::optional<Stage> read_services(const toml::table& table) {
    fitted(table, {}, {"overdraw"}, "services");
    const toml::node* node = table.get("overdraw");
    return node == nullptr ? std::nullopt : read_stage(*node, "services.overdraw");
  }

  const std::string& name_;
  Diagnostics& diagnostics_;
};

/// toml++ walks a table by its keys' names; people read a file from its top.
std::vector<Diagnostic> from_the_top(std::vector<Diagnostic> found) {
  std::ranges::stable_sort(found, {}, [](const Diagnostic& d) { return std::tuple(d.where.line, d.where.column); });
  return found;
}

}  // namespace

std::optional<std::vector<NamedPipeline>> parse_branches(std::string_view text, const std::string& name,
                                                         Diagnostics& diagnostics) {
  if (std::ranges::count(text, '.') > most_dots) {
    diagnostics.error({.file = name}, "too-large",
                      fmt::format("the file has more than {} dots, which is too many for a pipeline", most_dots));
    return std::nullopt;
  }
  Diagnostics found;
  std::vector<NamedPipeline> branches;
  if (const toml::parse_result root = toml::parse(text)) {
    branches = FileReader(name, found).read(root.table());
  } else {
    const toml::source_position place = root.error().source().begin;
    found.error({name, static_cast<int>(place.line), static_cast<int>(place.column), {}}, "syntax",
                std::string(root.error().description()), "the file is not valid TOML; see https://toml.io");
  }
  for (const Diagnostic& diagnostic : from_the_top(found.all())) diagnostics.add(diagnostic);
  if (found.has_errors()) return std::nullopt;
  return branches;
}

std::optional<Pipeline> only_one(std::optional<std::vector<NamedPipeline>> branches, const std::string& name,
                                 Diagnostics& diagnostics) {
  if (!branches) return std::nullopt;
  if (branches->size() == 1) return std::move(branches->front().pipeline);
  diagnostics.error({.file = name, .inside = "compare"}, "has-branches",
                    fmt::format("the file has {} pipelines, but this command runs one", branches->size()),
                    "foredraw compare runs them side by side");
  return std::nullopt;
}

std::optional<Pipeline> parse_file(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  return only_one(parse_branches(text, name, diagnostics), name, diagnostics);
}

}  // namespace foredraw
