#include <foredraw/technique/plugin.h>

namespace foredraw {

std::string_view to_text(Kind kind) {
  switch (kind) {
    case Kind::orderer: return "orderer";
    case Kind::clusterer: return "clusterer";
    case Kind::processor: return "processor";
    case Kind::evaluator: return "evaluator";
  }
  return "orderer";
}

}  // namespace foredraw
