#pragma once
#include <cstddef>
#include <cstdint>

namespace foredraw {

/// Changes a glTF so that most of it still reads: the JSON is changed as a tree, the bytes as bytes, and container,
/// lengths and text are made to agree again. What is no glTF is changed as plain bytes. As LLVMFuzzerCustomMutator has
/// it.
std::size_t mutate_gltf(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

}  // namespace foredraw
