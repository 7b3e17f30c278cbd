#pragma once

namespace foredraw {

/// How the fragments that pass are counted: around each draw by the device, or one by one in the fragment shader.
enum class CountMethod { queries, atomics };

}  // namespace foredraw
