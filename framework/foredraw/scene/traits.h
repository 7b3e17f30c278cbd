#pragma once
// Facts about a draw or an image: found in the asset, or established by a stage.

#include <initializer_list>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace foredraw {

/// A trait is a name. Plugins may bring their own; the framework's are the rows of known_traits().
using Trait = std::string_view;

struct TraitRow {
  Trait name;
  std::string_view meaning;
};

/// Every trait that the framework itself knows, for documentation and for "did you mean".
std::span<const TraitRow> known_traits();

namespace traits {
inline constexpr Trait triangles = "triangles";
inline constexpr Trait uv0 = "uv0";
inline constexpr Trait normals = "normals";
inline constexpr Trait skinned = "skinned";
inline constexpr Trait morphed = "morphed";
inline constexpr Trait animated = "animated";
inline constexpr Trait blended = "blended";
inline constexpr Trait masked = "masked";
inline constexpr Trait double_sided = "double-sided";
inline constexpr Trait displaced = "displaced";
inline constexpr Trait instanced = "instanced";
inline constexpr Trait sprite = "sprite";
inline constexpr Trait trimmed = "trimmed";
inline constexpr Trait quantized = "quantized";
inline constexpr Trait extended = "extended";
inline constexpr Trait welded = "welded";
inline constexpr Trait clustered = "clustered";
inline constexpr Trait cache_ordered = "cache-ordered";
inline constexpr Trait overdraw_ordered = "overdraw-ordered";
inline constexpr Trait fetch_ordered = "fetch-ordered";
inline constexpr Trait progressive = "progressive";
}  // namespace traits

class Traits {
  using Names = std::set<std::string, std::less<>>;

 public:
  Traits() = default;
  Traits(std::initializer_list<Trait> names) : names_(names.begin(), names.end()) {}

  bool has(Trait trait) const { return names_.find(trait) != names_.end(); }
  void add(Trait trait) { names_.emplace(trait); }
  void remove(Trait trait) {
    if (auto it = names_.find(trait); it != names_.end()) names_.erase(it);
  }
  void add(const Traits& others) { names_.insert(others.names_.begin(), others.names_.end()); }
  void remove(const Traits& others) {
    for (const std::string& name : others) remove(Trait(name));
  }

  bool empty() const { return names_.empty(); }
  Names::const_iterator begin() const { return names_.begin(); }
  Names::const_iterator end() const { return names_.end(); }
  friend bool operator==(const Traits&, const Traits&) = default;

 private:
  Names names_;
};

}  // namespace foredraw
