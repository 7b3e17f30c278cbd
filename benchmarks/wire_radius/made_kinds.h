#pragma once
// What made meshes show: wires of many kinds, and what looks like one and is none.

#include "swept.h"

namespace foredraw::bench::made {

KnownMesh catenary(Random& random);
KnownMesh rough_wire(Random& random);
KnownMesh coil(Random& random);
KnownMesh ring(Random& random);
KnownMesh lamp_post(Random& random);
KnownMesh railing(Random& random);
KnownMesh antenna(Random& random);
KnownMesh rope(Random& random);
KnownMesh net(Random& random);

/// "road marking", "plank", "bumper", "sword", "finger", "sail hem", "bar 5:1:1", "fat ring", "egg" or "blade of
/// grass".
KnownMesh no_wires(Random& random, const std::string& what);

}  // namespace foredraw::bench::made
