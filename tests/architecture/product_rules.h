#pragma once
// A technique's product is one folder: nobody who is handed rows names one.

#include "source_tree.h"

namespace foredraw::architecture {

/// What a file of io, report, pipeline or the hosts names of products: their names, types, extensions and rooms. The
/// runner may name the orders that orderers answer with, and an example engine what it reads.
Breaches product_breaches(const std::string& path, const std::string& text);

}  // namespace foredraw::architecture
