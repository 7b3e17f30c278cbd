#pragma once
// Which primitives are drawn from which of Draco's buffers, and what their accessors claim of them. Private to io.

#include <foredraw/io/gltf/codecs/private/draco.h>
#include <foredraw/io/gltf/gate/private/gate.h>

#include <string>
#include <variant>
#include <vector>

namespace foredraw::gltf {

/// One of Draco's buffers, whichever primitives it is for.
struct DracoBuffer {
  std::size_t view = 0;
  std::string place;  ///< of the first primitive's extension
  DracoClaim claim;
  std::variant<DracoMesh, DracoFault> held;
};

/// A primitive that is drawn from one.
struct DracoUse {
  struct Attribute {
    std::size_t accessor = 0;
    std::string semantic;
    std::size_t claimed = 0;  ///< number in the claim
  };
  std::size_t mesh = 0, primitive = 0;
  std::string place;
  std::size_t buffer = 0;
  std::size_t indices = 0;                ///< accessor
  std::size_t index_bytes = 0;            ///< of one, in that accessor
  std::size_t points = 0, triangles = 0;  ///< that the accessors claim
  bool is_strip = false;
  std::vector<Attribute> attributes;
};

struct DracoUses {
  bool is_used = false;  ///< a primitive has the extension
  std::vector<DracoBuffer> buffers;
  std::vector<DracoUse> uses;  ///< of those without an error
};

/// Finds them in the JSON, and holds against each other what it says.
DracoUses draco_uses(Gate& gate);

/// Puts what was decoded of every buffer into the document, and takes the extension out of the primitives.
void place_draco(Gate& gate, const DracoUses& found);

}  // namespace foredraw::gltf
