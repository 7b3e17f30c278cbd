// Files made anew: what a scene shows, as far as each kind of file can hold it.
#include <foredraw/io/mesh/mesh_files.h>
#include <foredraw/io/mesh/private/shown_meshes.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace foredraw::mesh_files {

namespace {

using Meshes = std::vector<ShownMesh>;

/// Names are words up to the end of the line.
std::string on_one_line(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return name;
}

/// Numbers are written with as few digits as bring the same float back.
std::string new_obj(const Meshes& meshes) {
  std::string text;
  const auto to = std::back_inserter(text);
  std::size_t positions = 1, texcoords = 1, normals = 1;
  for (const ShownMesh& mesh : meshes) {
    fmt::format_to(to, "o {}\n", on_one_line(mesh.name));
    for (const glm::vec3& p : mesh.positions) fmt::format_to(to, "v {} {} {}\n", p.x, p.y, p.z);
    for (const glm::vec2& t : mesh.texcoords) fmt::format_to(to, "vt {} {}\n", t.x, 1 - t.y);
    for (const glm::vec3& n : mesh.normals) fmt::format_to(to, "vn {} {} {}\n", n.x, n.y, n.z);
    if (!mesh.material.empty()) fmt::format_to(to, "usemtl {}\n", on_one_line(mesh.material));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      text += 'f';
      for (std::size_t k = i; k < i + 3; ++k) {
        const std::uint32_t v = mesh.indices[k];
        fmt::format_to(to, " {}", positions + v);
        if (!mesh.texcoords.empty() || !mesh.normals.empty()) text += '/';
        if (!mesh.texcoords.empty()) fmt::format_to(to, "{}", texcoords + v);
        if (!mesh.normals.empty()) fmt::format_to(to, "/{}", normals + v);
      }
      text += '\n';
    }
    positions += mesh.positions.size();
    texcoords += mesh.texcoords.size();
    normals += mesh.normals.size();
  }
  return text;
}

std::string new_off(const Meshes& meshes) {
  std::size_t vertices = 0, triangles = 0;
  std::string records, faces;
  for (const ShownMesh& mesh : meshes) {
    for (const glm::vec3& p : mesh.positions) {
      fmt::format_to(std::back_inserter(records), "{} {} {}\n", p.x, p.y, p.z);
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      fmt::format_to(std::back_inserter(faces), "3 {} {} {}\n", vertices + mesh.indices[i],
                     vertices + mesh.indices[i + 1], vertices + mesh.indices[i + 2]);
      ++triangles;
    }
    vertices += mesh.positions.size();
  }
  return fmt::format("OFF\n{} {} 0\n", vertices, triangles) + records + faces;
}

/// Bytes as little-endian files have them.
template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// One list of vertices: with what all meshes have.
std::string new_ply(const Meshes& meshes) {
  const auto all_have = [&](const auto& member) {
    return std::ranges::none_of(meshes, [&](const ShownMesh& mesh) { return (mesh.*member).empty(); });
  };
  const bool normals = all_have(&ShownMesh::normals), texcoords = all_have(&ShownMesh::texcoords);
  const bool colors = all_have(&ShownMesh::colors);
  std::string vertices, faces;
  std::size_t count = 0, triangles = 0;
  for (const ShownMesh& mesh : meshes) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      for (int c = 0; c < 3; ++c) append(vertices, mesh.positions[v][c]);
      for (int c = 0; c < 3 && normals; ++c) append(vertices, mesh.normals[v][c]);
      if (texcoords) append(vertices, mesh.texcoords[v].x);
      if (texcoords) append(vertices, 1 - mesh.texcoords[v].y);
      for (int c = 0; c < 4 && colors; ++c) {
        append(vertices, static_cast<std::uint8_t>(std::lround(std::clamp(mesh.colors[v][c], 0.0f, 1.0f) * 255)));
      }
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      append(faces, std::uint8_t{3});
      for (std::size_t k = i; k < i + 3; ++k) append(faces, static_cast<std::uint32_t>(count + mesh.indices[k]));
      ++triangles;
    }
    count += mesh.positions.size();
  }
  std::string header = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", count);
  for (const char* name : {"x", "y", "z"}) header += fmt::format("property float {}\n", name);
  for (const char* name : {"nx", "ny", "nz"}) header += normals ? fmt::format("property float {}\n", name) : "";
  for (const char* name : {"s", "t"}) header += texcoords ? fmt::format("property float {}\n", name) : "";
  for (const char* name : {"red", "green", "blue", "alpha"}) {
    header += colors ? fmt::format("property uchar {}\n", name) : "";
  }
  header += fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n", triangles);
  return header + vertices + faces;
}

std::string new_stl(const Meshes& meshes) {
  constexpr std::size_t header = 80;
  std::string bytes("binary STL"), facets;
  bytes.resize(header, ' ');
  std::uint32_t triangles = 0;
  for (const ShownMesh& mesh : meshes) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                      c = mesh.positions[mesh.indices[i + 2]];
      const glm::vec3 across = glm::cross(b - a, c - a);
      const float length = glm::length(across);
      for (const glm::vec3& row : {length > 0 ? across / length : glm::vec3(0), a, b, c}) {
        for (int k = 0; k < 3; ++k) append(facets, row[k]);
      }
      append(facets, std::uint16_t{0});
      ++triangles;
    }
  }
  append(bytes, triangles);
  return bytes + facets;
}

}  // namespace

}  // namespace foredraw::mesh_files

namespace foredraw {

namespace {

/// Parts of the scene that a mesh file cannot hold: "materials, skins".
std::string left_out_of(const Scene& scene, MeshKind kind) {
  const bool has_levels = std::ranges::any_of(scene.draws, [](const Draw& draw) { return draw.levels.size() > 1; });
  const bool has_weights = std::ranges::any_of(scene.draws, [](const Draw& draw) {
    return draw.full().vertices && !draw.full().vertices->morph_targets.empty();
  });
  const std::pair<const char*, bool> parts[] = {
      {kind == MeshKind::obj ? "materials (but for their names)" : "materials", !scene.materials.empty()},
      {"images", !scene.images.empty()},
      {"skins", !scene.skins.empty()},
      {"morph targets", has_weights},
      {"animations", !scene.animations.empty()},
      {"levels of detail", has_levels}};
  std::string text;
  for (const auto& [part, is_there] : parts) {
    if (is_there) text.append(text.empty() ? "" : ", ").append(part);
  }
  return text;
}

const char* held_by(MeshKind kind) {
  switch (kind) {
    case MeshKind::obj: return "positions, normals, texture coordinates and names";
    case MeshKind::ply: return "positions, normals, texture coordinates and colours";
    case MeshKind::off:
    case MeshKind::stl: break;
  }
  return "positions";
}

}  // namespace

std::optional<OutputFile> encode_as_mesh_file(const Scene& scene, MeshKind kind, const std::filesystem::path& target,
                                              Diagnostics& diagnostics) {
  Diagnostics found;
  auto file = encode_mesh_file(scene, kind, target, found);
  const auto has = [&](const char* code) {
    return std::ranges::find(found.all(), code, &Diagnostic::code) != found.all().end();
  };
  const bool is_of_another_kind = !file && has("unknown-kind");
  if (file || !(is_of_another_kind || has("other-triangles"))) {
    for (const Diagnostic& one : found.all()) diagnostics.add(one);
    return file;
  }
  file = encode_new_mesh_file(scene, kind, target, diagnostics);
  if (!file) return std::nullopt;
  const std::string left_out = left_out_of(scene, kind);
  diagnostics.warning(
      {.file = target.string()}, "made-anew",
      fmt::format(
          "{}, so the file is made anew: it holds the triangles that are drawn, with {}, and nothing else of the "
          "input{}",
          is_of_another_kind ? fmt::format("the scene was not read from {}", extension_of(kind))
                             : "more than the order was changed",
          held_by(kind), left_out.empty() ? "" : "; left out: " + left_out),
      "write a .glb to keep the rest");
  return file;
}

std::optional<OutputFile> encode_new_mesh_file(const Scene& scene, MeshKind kind, const std::filesystem::path& target,
                                               Diagnostics& diagnostics) {
  using namespace mesh_files;
  std::size_t left_out = 0;
  const Meshes meshes = shown_meshes(scene, left_out);
  const bool is_empty = std::ranges::all_of(meshes, [](const ShownMesh& mesh) { return mesh.indices.empty(); });
  if (is_empty) {
    diagnostics.error({.file = target.string()}, "cannot-express", "the scene shows no triangles",
                      "give the output the extension .glb");
    return std::nullopt;
  }
  if (left_out > 0) {
    diagnostics.warning({.file = target.string()}, "cannot-express",
                        fmt::format("draws of lines and points are left out: {}", left_out),
                        "give the output the extension .glb");
  }
  const std::string text = kind == MeshKind::obj   ? new_obj(meshes)
                           : kind == MeshKind::ply ? new_ply(meshes)
                           : kind == MeshKind::off ? new_off(meshes)
                                                   : new_stl(meshes);
  const auto bytes = std::as_bytes(std::span(text));
  return OutputFile{target, {bytes.begin(), bytes.end()}};
}

}  // namespace foredraw
