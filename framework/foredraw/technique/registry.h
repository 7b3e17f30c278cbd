#pragma once
#include <foredraw/technique/module_file.h>
#include <foredraw/technique/plugin.h>

#include <map>
#include <string_view>

namespace foredraw {

/// The plugins that a host has put together. A value; there is no other.
class Registry {
 public:
  /// Throws std::invalid_argument where the name is taken, is not in lower case with hyphens, or an option's default
  /// does not fit its own row, or two products have one extension: mistakes of whoever wrote the plugin. `module`: what
  /// it was loaded from; null: it is built in.
  void add(Plugin plugin, std::shared_ptr<const ModuleFile> module = nullptr);
  const Plugin* find(std::string_view name) const;
  /// What the plugin was loaded from; null: it is built in, or there is none.
  const ModuleFile* module_of(std::string_view name) const;
  /// A plugin that this build does without, and why: the rest of a sentence.
  void leave_out(std::string name, std::string reason) { left_out_.emplace(std::move(name), std::move(reason)); }
  const std::map<std::string, std::string, std::less<>>& left_out() const { return left_out_; }
  /// For whoever asked for a plugin, or something else of those names, that is not there.
  std::string hint_for(std::string_view name, const std::vector<std::string>& names) const;
  std::vector<const Plugin*> all() const;  ///< by name
  std::vector<std::string> names() const;
  /// What the plugins make, by name, each once.
  ProductRows products() const;

 private:
  std::map<std::string, Plugin, std::less<>> plugins_;
  std::map<std::string, std::shared_ptr<const ModuleFile>, std::less<>> modules_;
  std::map<std::string, std::string, std::less<>> left_out_;
};

}  // namespace foredraw
