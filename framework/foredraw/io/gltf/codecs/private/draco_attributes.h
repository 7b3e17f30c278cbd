#pragma once
// Decoders of the attributes of a Draco buffer, which believe less than libdraco's. Private to io.

#include <draco/compression/attributes/attributes_decoder_interface.h>

#include <cstdint>
#include <memory>
#include <set>

namespace foredraw::gltf {

/// A decoder in place of one that libdraco made for a mesh, which it leaves empty. As it decodes, `rounded`, which must
/// outlive it, gets the numbers of attributes whose floats the encoder rounded. Throws a std::exception where a buffer
/// says what can not be.
std::unique_ptr<draco::AttributesDecoderInterface> bounded_attributes(draco::AttributesDecoderInterface& made,
                                                                      std::set<std::int32_t>& rounded);

}  // namespace foredraw::gltf
