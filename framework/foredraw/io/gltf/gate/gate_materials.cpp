// Checks of materials and textures. Only what a material says is left out where it is wrong: the triangles are sound.
#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/gltf/private/displacement.h>
#include <foredraw/io/gltf/private/thickness.h>

#include <fmt/format.h>

namespace foredraw::gltf {

namespace {

/// Who names a texture that is not there has none.
void check_texture(Gate& gate, const Json& holder, const char* key, const std::string& place) {
  gate.leave_out_if_wrong("texture", in(place, key), [&] {
    if (const Json* texture = gate.object(holder, key, place)) {
      gate.required(*texture, "index", in(place, key));
      gate.reference(*texture, "index", "textures", in(place, key));
    }
  });
}

}  // namespace

void check_materials(Gate& gate) {
  const Json& textures = gate.all("textures");
  for (std::size_t i = 0; i < textures.size(); ++i) {
    const std::string place = at("textures", i);
    gate.leave_out_if_wrong("texture", in(place, "source"),
                            [&] { gate.reference(textures[i], "source", "images", place); });
    gate.leave_out_if_wrong("texture", in(place, "sampler"),
                            [&] { gate.reference(textures[i], "sampler", "samplers", place); });
  }
  const Json& materials = gate.all("materials");
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const std::string place = at("materials", i);
    gate.leave_out_if_wrong("material", in(place, "alphaMode"), [&] {
      const auto mode = gate.text(materials[i], "alphaMode", place);
      if (mode && *mode != "OPAQUE" && *mode != "MASK" && *mode != "BLEND") {
        gate.error(in(place, "alphaMode"), "out-of-range",
                   fmt::format("is '{}', but must be OPAQUE, MASK or BLEND", *mode));
      }
    });
    gate.leave_out_if_wrong("material", in(place, "alphaCutoff"),
                            [&] { gate.number(materials[i], "alphaCutoff", place); });
    gate.leave_out_if_wrong("material", in(place, "doubleSided"),
                            [&] { gate.boolean(materials[i], "doubleSided", place); });
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
      check_texture(gate, materials[i], key, place);
    if (const Json* moved = extension_of(materials[i], displacement_extension); moved && moved->is_object()) {
      const std::string extension = in(in(place, "extensions"), displacement_extension);
      check_texture(gate, *moved, "displacementGeometryTexture", extension);
      for (const char* key : {"displacementGeometryFactor", "displacementGeometryOffset"})
        gate.leave_out_if_wrong("material", in(extension, key), [&] { gate.number(*moved, key, extension); });
    }
    if (const Json* volume = extension_of(materials[i], volume_extension); volume && volume->is_object()) {
      const std::string extension = in(in(place, "extensions"), volume_extension);
      gate.leave_out_if_wrong("material", in(extension, "thicknessFactor"),
                              [&] { gate.number(*volume, "thicknessFactor", extension); });
    }
    const Json* surface = nullptr;
    gate.leave_out_if_wrong("material", in(place, "pbrMetallicRoughness"),
                            [&] { surface = gate.object(materials[i], "pbrMetallicRoughness", place); });
    if (surface == nullptr) continue;
    for (const char* key : {"baseColorTexture", "metallicRoughnessTexture"})
      check_texture(gate, *surface, key, in(place, "pbrMetallicRoughness"));
  }
}

}  // namespace foredraw::gltf
