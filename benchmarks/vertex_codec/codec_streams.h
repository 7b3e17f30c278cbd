#pragma once
// What is compressed: vertex streams of models, as they are in files.

#include <cstddef>
#include <string>
#include <vector>

namespace foredraw::bench {

struct StreamSet {
  std::string name;
  std::size_t stride = 0;
  std::vector<std::vector<std::byte>> streams;

  std::size_t bytes() const;
};

/// The vertex streams of these files, those of one attribute and format as one set; and, of positions, normals and
/// texture coordinates that are floats, sets of them as 16-, 8- and 16-bit numbers. Strides of whole words alone.
std::vector<StreamSet> streams_of(const std::vector<std::string>& files);

/// The positions of Spot subdivided to 3 thousand vertices and up to more than 700 thousand, as floats and as 16 bits.
std::vector<StreamSet> growing_streams();

}  // namespace foredraw::bench
