#include <foredraw/scene/traits.h>

namespace foredraw {

std::span<const TraitRow> known_traits() {
  static constexpr TraitRow rows[] = {
      {traits::triangles, "draws triangles (a list, strip or fan), not points or lines"},
      {traits::uv0, "has texture coordinates TEXCOORD_0"},
      {traits::normals, "has normals"},
      {traits::skinned, "vertices follow joints"},
      {traits::morphed, "has morph targets"},
      {traits::animated, "changes its shape over time: a skin or morph weights that an animation moves"},
      {traits::blended, "material is alpha-blended, so the order of triangles may show"},
      {traits::masked, "material is alpha-masked"},
      {traits::double_sided, "material draws back faces"},
      {traits::displaced, "its material moves the surface by a map of heights"},
      {traits::instanced, "more than one node draws it"},
      {traits::quantized, "positions are stored as integers"},
      {traits::extended, "carries an extension that may refer to its triangles or vertices by number"},
      {traits::sprite, "flat quads or polygons, each with a part of an image whose alpha says what shows"},
      {traits::trimmed, "sprites whose empty corners are not drawn"},
      {traits::welded, "no two vertices are bitwise equal"},
      {traits::clustered, "its triangle order is cut into clusters"},
      {traits::cache_ordered, "triangles are ordered for the vertex cache"},
      {traits::overdraw_ordered, "triangles are ordered for low overdraw"},
      {traits::fetch_ordered, "vertices are numbered by first use"},
      {traits::progressive, "a sequence of edge collapses makes it coarser"},
  };
  return rows;
}

}  // namespace foredraw
