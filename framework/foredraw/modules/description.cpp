#include <foredraw/modules/description.h>

#include <foredraw/modules/foreign_plugin.h>
#include <foredraw/modules/wire.h>

#include <fmt/format.h>

#include <span>
#include <stdexcept>

namespace foredraw {

namespace {

constexpr std::uint32_t most_rows = 1000;

template <class... Arguments>
void require(bool good, fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  if (!good) throw std::invalid_argument(fmt::format(message, std::forward<Arguments>(arguments)...));
}

template <class Row>
std::span<const Row> rows_of(const Row* rows, std::uint32_t count, const char* what) {
  require(count <= most_rows, "it has {} {}s, but at most {} are taken", count, what, most_rows);
  require(count == 0 || rows != nullptr, "{} is {}, but {}s is NULL", fmt::format("{}_count", what), count, what);
  return {rows, count};
}

void put_option(const foredraw_option& option, WireWriter& out) {
  for (const char* text : {option.name, option.doc, option.unit}) out.put(text);
  out.put(option.type);
  const auto choices = rows_of(option.choices, option.type == FOREDRAW_CHOICE ? option.choice_count : 0, "choice");
  out.put(static_cast<std::uint32_t>(choices.size()));
  for (const char* choice : choices) out.put(choice);
  const bool has_text = option.type == FOREDRAW_TEXT || option.type == FOREDRAW_CHOICE;
  out.put(option.initial.integer);
  out.put(option.initial.number);
  out.put(has_text ? option.initial.text : nullptr);
  out.put(option.least);
  out.put(option.most);
}

void put_plugin(const foredraw_plugin& given, WireWriter& out) {
  const foredraw_plugin plugin = in_this_version(given);
  out.put(plugin.kind);
  for (const char* text : {plugin.name, plugin.summary, plugin.reference, plugin.needs, plugin.provides, plugin.breaks,
                           plugin.acts_on, plugin.pays_if}) {
    out.put(text);
  }
  out.put(plugin.flags);
  out.put(plugin.run != nullptr);
  const auto options = rows_of(plugin.options, plugin.option_count, "option");
  out.put(static_cast<std::uint32_t>(options.size()));
  for (const foredraw_option& option : options) put_option(option, out);
  const auto metrics = rows_of(plugin.metrics, plugin.metric_count, "metric");
  out.put(static_cast<std::uint32_t>(metrics.size()));
  for (const foredraw_metric& metric : metrics) {
    for (const char* text : {metric.name, metric.unit, metric.doc}) out.put(text);
    out.put(metric.higher_is_better);
  }
}

int can_not_be_called(void*, const foredraw_draw*, const foredraw_value*, foredraw_answer*, const foredraw_host*) {
  return FOREDRAW_FAILED;
}

}  // namespace

std::string written_down(const foredraw_module* module) {
  require(module != nullptr, "foredraw_module_v1() returned NULL");
  require(module->size >= sizeof *module, "size is {}, but must be sizeof(foredraw_module), {}", module->size,
          sizeof *module);
  require(module->major == FOREDRAW_MODULE_MAJOR, "it is for version {} of modules, but this program speaks {}.{}",
          module->major, +FOREDRAW_MODULE_MAJOR, +FOREDRAW_MODULE_MINOR);
  require(module->minor <= FOREDRAW_MODULE_MINOR, "it needs version {}.{} of modules, but this program speaks {}.{}",
          module->major, module->minor, +FOREDRAW_MODULE_MAJOR, +FOREDRAW_MODULE_MINOR);
  require(module->vendor != nullptr, "vendor is NULL");
  require(module->plugin_count > 0, "plugin_count is 0");
  WireWriter out;
  out.put(module->vendor);
  out.put(module->version);
  const auto plugins = rows_of(module->plugins, module->plugin_count, "plugin");
  out.put(static_cast<std::uint32_t>(plugins.size()));
  for (const foredraw_plugin* plugin : plugins) {
    require(plugin != nullptr, "one of its plugins is NULL");
    put_plugin(*plugin, out);
  }
  return out.bytes();
}

DescribedModule::DescribedModule(std::string_view bytes) {
  WireReader in(bytes);
  const auto text = [&]() -> const char* {
    auto one = in.text();
    return one ? texts_.emplace_back(std::move(*one)).c_str() : nullptr;
  };
  const auto count = [&] {
    const auto number = in.number<std::uint32_t>();
    if (number > most_rows) throw std::runtime_error("it sent more than it may");
    return number;
  };
  vendor = in.text().value_or("");
  version = in.text().value_or("");
  plugins.resize(count());
  for (foredraw_plugin& plugin : plugins) {
    plugin = {.size = sizeof plugin, .kind = in.number<std::uint32_t>()};
    for (const char** field : {&plugin.name, &plugin.summary, &plugin.reference, &plugin.needs, &plugin.provides,
                               &plugin.breaks, &plugin.acts_on, &plugin.pays_if}) {
      *field = text();
    }
    plugin.flags = in.number<std::uint32_t>();
    if (in.flag()) plugin.run = can_not_be_called;
    auto& options = options_.emplace_back(count());
    for (foredraw_option& option : options) {
      for (const char** field : {&option.name, &option.doc, &option.unit}) *field = text();
      option.type = in.number<std::uint32_t>();
      auto& choices = choices_.emplace_back(count());
      for (const char*& choice : choices) choice = text();
      option.choices = choices.data(), option.choice_count = static_cast<std::uint32_t>(choices.size());
      option.initial.integer = in.number<std::int64_t>();
      option.initial.number = in.number<double>();
      option.initial.text = text();
      option.least = in.number<double>();
      option.most = in.number<double>();
    }
    plugin.options = options.data(), plugin.option_count = static_cast<std::uint32_t>(options.size());
    auto& metrics = metrics_.emplace_back(count());
    for (foredraw_metric& metric : metrics) {
      for (const char** field : {&metric.name, &metric.unit, &metric.doc}) *field = text();
      metric.higher_is_better = in.number<std::uint32_t>();
    }
    plugin.metrics = metrics.data(), plugin.metric_count = static_cast<std::uint32_t>(metrics.size());
  }
}

}  // namespace foredraw
