#pragma once
#include <foredraw/technique/registry.h>

#include <string>

namespace foredraw {

/// The reference page of a plugin, in Markdown: made from its card and its option table, and from nothing else.
std::string reference_page(const Plugin& plugin, const ModuleFile* module = nullptr);

/// Every plugin with its card and options, as JSON.
std::string reference_json(const Plugin& plugin, const ModuleFile* module = nullptr);
std::string list_text(const Registry& registry, std::optional<Kind> kind);
std::string list_json(const Registry& registry, std::optional<Kind> kind);

}  // namespace foredraw
