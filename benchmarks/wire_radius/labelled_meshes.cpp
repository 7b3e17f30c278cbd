#include "wire_sets.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/base/diagnostics.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/io/scene_file.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <queue>
#include <sstream>
#include <stdexcept>

namespace foredraw::bench {

namespace {

struct Label {
  std::string file, kind, name, where;
  std::size_t mesh = 0;
};

std::vector<Label> read_labels(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::vector<Label> labels;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> columns;
    std::istringstream parts(line);
    for (std::string part; std::getline(parts, part, '\t');) columns.push_back(part);
    columns.resize(5);
    labels.push_back({columns[0], columns[2], columns[3], columns[4], std::stoul(columns[1])});
  }
  return labels;
}

/// [triangle] what hangs together by points, numbered in the sequence of triangles.
std::vector<std::uint32_t> shells_of(const KnownMesh& mesh, const std::vector<std::uint32_t>& point) {
  JoinedSets sets(point.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    sets.join(point[mesh.indices[i]], point[mesh.indices[i - i % 3]]);
  }
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<std::uint32_t> shell;
  for (std::size_t t = 0; 3 * t < mesh.indices.size(); ++t) {
    const std::uint32_t set = sets.of(point[mesh.indices[3 * t]]);
    shell.push_back(number.try_emplace(set, static_cast<std::uint32_t>(number.size())).first->second);
  }
  return shell;
}

/// "81-118,189-300/3"
std::vector<std::uint32_t> numbers_of(const std::string& text) {
  std::vector<std::uint32_t> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    unsigned first = 0, last = 0, step = 1;
    const int read = std::sscanf(part.c_str(), "%u-%u/%u", &first, &last, &step);
    if (read < 1 || step == 0) throw std::runtime_error("no numbers: " + part);
    for (std::uint32_t i = first; i <= (read > 1 ? last : first); i += step) numbers.push_back(i);
  }
  return numbers;
}

/// Half its borders, where all points are on them; else the way along edges between points that are far apart.
double length_of_shell(const KnownMesh& mesh, const std::vector<std::uint32_t>& point,
                       const std::vector<std::uint32_t>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::map<std::uint32_t, std::vector<std::uint32_t>> beside;
  for (const std::uint32_t t : triangles) {
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t a = point[mesh.indices[3 * std::size_t{t} + e]],
                          b = point[mesh.indices[3 * std::size_t{t} + (e + 1) % 3]];
      ++edges[{std::min(a, b), std::max(a, b)}];
      beside[a].push_back(b);
      beside[b].push_back(a);
    }
  }
  double borders = 0;
  std::map<std::uint32_t, bool> on_border;
  for (const auto& [edge, count] : edges) {
    if (count != 1) continue;
    borders += glm::distance(glm::dvec3(mesh.positions[edge.first]), glm::dvec3(mesh.positions[edge.second]));
    on_border[edge.first] = on_border[edge.second] = true;
  }
  if (borders > 0 && 10 * on_border.size() >= 8 * beside.size()) return borders / 2;
  std::pair<double, std::uint32_t> far{0, beside.begin()->first};
  for (int sweep = 0; sweep < 2; ++sweep) {
    std::map<std::uint32_t, double> way;
    std::priority_queue<std::pair<double, std::uint32_t>> queue;
    queue.emplace(0, far.second);
    far.first = 0;
    while (!queue.empty()) {
      const auto [minus, at] = queue.top();
      queue.pop();
      if (!way.try_emplace(at, -minus).second) continue;
      far = std::max(far, {-minus, at});
      for (const std::uint32_t next : beside[at]) {
        queue.emplace(minus - glm::distance(glm::dvec3(mesh.positions[at]), glm::dvec3(mesh.positions[next])), next);
      }
    }
  }
  return far.first;
}

double distance_to(const glm::dvec3& at, const std::vector<glm::dvec3>& line) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const glm::dvec3 way = line[i + 1] - line[i];
    const double part = std::clamp(glm::dot(at - line[i], way) / glm::dot(way, way), 0.0, 1.0);
    least = std::min(least, glm::distance(at, line[i] + part * way));
  }
  return least;
}

void apply(const Label& label, KnownMesh& mesh) {
  if (label.kind == "none") return;
  if (label.kind != "wire" && label.kind != "either") throw std::runtime_error("no label: " + label.kind);
  const bool is_wire = label.kind == "wire";
  const std::vector<std::uint32_t> point = welded(mesh.positions);
  std::istringstream where(label.where);
  std::string how;
  where >> how;
  std::map<std::uint32_t, std::vector<std::uint32_t>> parts;
  std::vector<glm::dvec3> line;
  if (how == "shells") {
    std::string numbers;
    where >> numbers;
    const std::vector<std::uint32_t> shell = shells_of(mesh, point), wanted = numbers_of(numbers);
    for (std::uint32_t t = 0; t < shell.size(); ++t) {
      if (std::ranges::find(wanted, shell[t]) != wanted.end()) parts[shell[t]].push_back(t);
    }
    if (parts.size() != wanted.size()) throw std::runtime_error(label.name + ": there are not so many shells");
  } else if (how == "tube") {
    double radius = 0;
    where >> radius;
    for (glm::dvec3 at; where >> at.x >> at.y >> at.z;) line.push_back(at);
    for (std::uint32_t t = 0; 3 * std::size_t{t} < mesh.indices.size(); ++t) {
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i)
        inside &= distance_to(mesh.positions[mesh.indices[3 * std::size_t{t} + i]], line) <= radius;
      if (inside) parts[0].push_back(t);
    }
    if (parts.empty()) throw std::runtime_error(label.name + ": no triangle is there");
  } else {
    throw std::runtime_error("not a place: " + label.where);
  }
  for (const auto& [part, triangles] : parts) {
    const auto wire = static_cast<std::uint32_t>(mesh.length.size());
    for (const std::uint32_t t : triangles) mesh.wire_of[t] = is_wire ? wire : either_way;
    if (!is_wire) continue;
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::distance(line[i], line[i + 1]);
    mesh.length.push_back(line.empty() ? length_of_shell(mesh, point, triangles) : length);
  }
}

KnownMesh mesh_of(const Scene& scene, std::size_t number) {
  if (number >= scene.meshes.size()) throw std::runtime_error(scene.name + ": has no mesh " + std::to_string(number));
  KnownMesh mesh;
  Analyses analyses;
  for (const DrawId id : scene.meshes[number].draws) {
    const Level& level = scene.draws[id].full();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto positions = positions_of(analyses, *level.vertices);
    mesh.positions.insert(mesh.positions.end(), positions->values.begin(), positions->values.end());
    for (const std::uint32_t index : level.stream().indices.view()) mesh.indices.push_back(first + index);
  }
  mesh.wire_of.assign(mesh.indices.size() / 3, no_wire);
  return mesh;
}

}  // namespace

std::vector<KnownMesh> labelled_meshes(const std::filesystem::path& labels, const std::filesystem::path& folder) {
  std::vector<KnownMesh> meshes;
  std::map<std::pair<std::string, std::size_t>, std::size_t> places;
  for (const Label& label : read_labels(labels)) {
    if (!std::filesystem::exists(folder / label.file)) continue;
    const auto [place, is_new] = places.try_emplace({label.file, label.mesh}, meshes.size());
    if (is_new) {
      Diagnostics diagnostics;
      const auto read = read_scene((folder / label.file).string(), diagnostics);
      if (!read) throw std::runtime_error("cannot read " + label.file);
      meshes.push_back(mesh_of(read->scene, label.mesh));
      meshes.back().name = label.file + ':' + std::to_string(label.mesh);
    }
    apply(label, meshes[place->second]);
  }
  return meshes;
}

}  // namespace foredraw::bench
