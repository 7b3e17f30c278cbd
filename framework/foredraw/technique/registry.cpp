#include <foredraw/base/diagnostics.h>
#include <foredraw/technique/registry.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace foredraw {

namespace {

bool is_name(std::string_view name) {
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' &&
         std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

}  // namespace

void Registry::add(Plugin plugin, std::shared_ptr<const ModuleFile> module) {
  const std::string name = plugin.card.name;
  if (!is_name(name)) {
    throw std::invalid_argument("plugin name '" + name + "': expected lower-case letters, digits and hyphens");
  }
  if (plugins_.contains(name)) throw std::invalid_argument("there is already a plugin '" + name + "'");
  std::set<std::string> seen(std::begin(reserved_words), std::end(reserved_words));
  for (const OptionSpec& option : plugin.options) {
    if (!is_name(option.name))
      throw std::invalid_argument(name + ": option name '" + option.name +
                                  "': expected lower-case letters, digits and hyphens");
    if (!seen.insert(option.name).second) {
      throw std::invalid_argument(name + ": option name '" + option.name + "' is reserved or occurs twice");
    }
    if (std::holds_alternative<std::monostate>(option.default_value)) continue;
    const auto fitted = fit(option, option.default_value);
    if (const auto* why = std::get_if<std::string>(&fitted)) {
      throw std::invalid_argument(name + ": default of " + *why);
    }
  }
  for (const auto& row : plugin.products) {
    const ProductCard& card = row->card();
    for (const auto& known : products()) {
      if ((known->card().name == card.name) != (known->card().extension == card.extension)) {
        throw std::invalid_argument(name + ": product '" + card.name + "' or its extension " + card.extension +
                                    " is already in use");
      }
    }
  }
  plugins_.emplace(name, std::move(plugin));
  if (module) modules_.emplace(name, std::move(module));
}

ProductRows Registry::products() const {
  std::map<std::string, std::shared_ptr<const ProductRow>> rows;
  for (const auto& [name, plugin] : plugins_) {
    for (const auto& row : plugin.products) rows.emplace(row->card().name, row);
  }
  ProductRows result;
  for (auto& [name, row] : rows) result.push_back(std::move(row));
  return result;
}

const Plugin* Registry::find(std::string_view name) const {
  const auto it = plugins_.find(name);
  return it == plugins_.end() ? nullptr : &it->second;
}

const ModuleFile* Registry::module_of(std::string_view name) const {
  const auto it = modules_.find(name);
  return it == modules_.end() ? nullptr : it->second.get();
}

std::string Registry::hint_for(std::string_view name, const std::vector<std::string>& names) const {
  if (const auto it = left_out_.find(name); it != left_out_.end()) return "this build leaves it out: " + it->second;
  const std::string_view near = nearest(name, names);
  return near.empty() ? "foredraw list shows all plugins" : "did you mean '" + std::string(near) + "'?";
}

std::vector<const Plugin*> Registry::all() const {
  std::vector<const Plugin*> result;
  for (const auto& [name, plugin] : plugins_) result.push_back(&plugin);
  return result;
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> result;
  for (const auto& [name, plugin] : plugins_) result.push_back(name);
  return result;
}

}  // namespace foredraw
