#pragma once
// Facts about a draw or an image: found in the asset, or established by a stage.

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

namespace foredraw {

/// A trait is a name. Plugins may bring their own; the framework's are those of the namespace traits.
using Trait = std::string_view;

namespace traits {
inline constexpr Trait triangles = "triangles";  ///< draws triangles (a list, strip or fan), not points or lines
inline constexpr Trait uv0 = "uv0";              ///< has texture coordinates TEXCOORD_0
inline constexpr Trait normals = "normals";      ///< has normals
inline constexpr Trait skinned = "skinned";      ///< vertices follow joints
inline constexpr Trait morphed = "morphed";      ///< has morph targets
/// changes its shape over time: a skin or morph weights that an animation moves
inline constexpr Trait animated = "animated";
inline constexpr Trait blended = "blended";  ///< material is alpha-blended, so the order of triangles may show
inline constexpr Trait masked = "masked";    ///< material is alpha-masked
inline constexpr Trait double_sided = "double-sided";  ///< material draws back faces
inline constexpr Trait displaced = "displaced";        ///< its material moves the surface by a map of heights
inline constexpr Trait instanced = "instanced";        ///< more than one node draws it
/// flat quads or polygons, each with a part of an image whose alpha says what shows
inline constexpr Trait sprite = "sprite";
inline constexpr Trait trimmed = "trimmed";      ///< sprites whose empty corners are not drawn
inline constexpr Trait quantized = "quantized";  ///< positions are stored as integers
/// carries an extension that may refer to its triangles or vertices by number
inline constexpr Trait extended = "extended";
inline constexpr Trait welded = "welded";                      ///< no two vertices are bitwise equal
inline constexpr Trait clustered = "clustered";                ///< its triangle order is cut into clusters
inline constexpr Trait cache_ordered = "cache-ordered";        ///< triangles are ordered for the vertex cache
inline constexpr Trait overdraw_ordered = "overdraw-ordered";  ///< triangles are ordered for low overdraw
inline constexpr Trait fetch_ordered = "fetch-ordered";        ///< vertices are numbered by first use
inline constexpr Trait progressive = "progressive";            ///< a sequence of edge collapses makes it coarser
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
