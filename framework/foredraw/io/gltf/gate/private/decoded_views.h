#pragma once
// Buffer views that are made while a document is checked, for elements that lay in none. Private to io.

#include <foredraw/io/gltf/private/document.h>

#include <compare>

namespace foredraw::gltf {

/// Where elements lie.
struct Lies {
  std::size_t view = 0;
  std::size_t offset = 0;
  friend auto operator<=>(const Lies&, const Lies&) = default;
};

/// Vertices whose elements are equally far apart go into one view, and all indices into one.
class DecodedViews {
 public:
  /// `first`: the number that the first of them gets.
  explicit DecodedViews(std::size_t first) : first_(first) {}

  /// Makes room for what will be added, so that what is there need not move.
  void expect_vertices(std::size_t count, std::size_t element);

  /// Elements without gaps, of so many bytes each; in the view they begin at multiples of 4, as glTF wants.
  Lies add_vertices(Bytes elements, std::size_t element);
  Lies add_indices(Bytes indices);

  /// Into the document, as its last views, which name `buffer` but do not lie in it: the writer puts them where there
  /// is room. Returns their bytes.
  std::uint64_t put(Document& document, std::size_t buffer) &&;

 private:
  struct View {
    std::size_t stride = 0;    ///< 0: indices
    std::size_t expected = 0;  ///< bytes
    std::vector<std::byte> bytes;
  };

  View& view_of(std::size_t stride);
  std::byte* grow(std::size_t stride, std::size_t bytes, Lies& lies);

  std::size_t first_;
  std::vector<View> views_;
};

}  // namespace foredraw::gltf
