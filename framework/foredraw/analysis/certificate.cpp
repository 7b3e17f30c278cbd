#include <foredraw/analysis/certificate.h>

#include <foredraw/analysis/vertex_rows.h>

namespace foredraw {

namespace {

/// The content of each vertex, and how it is read: the same bytes under another name or format are something else.
struct VertexContent {
  static constexpr std::string_view name = "vertex-content";
  std::vector<Stamp> stamps;
  std::size_t bytes() const { return stamps.size() * sizeof(Stamp); }
};

VertexContent content_of(const VertexStreams& vertices) {
  const VertexRows rows(vertices);
  VertexContent content;
  content.stamps.resize(vertices.count);
  const std::uint64_t layout = vertices.layout_stamp().low;
  for (std::uint32_t v = 0; v < vertices.count; ++v) content.stamps[v] = content_hash(rows[v], layout);
  return content;
}

}  // namespace

Certificate certificate_of(const VertexStreams& vertices, std::span<const std::uint32_t> indices, Analyses& analyses) {
  const auto held = analyses.get<VertexContent>(vertices.stamp(), [&] { return content_of(vertices); });
  const std::vector<Stamp>& content = held->stamps;
  Certificate certificate;
  for (std::size_t i = 0; i + 3 <= indices.size(); i += 3) {
    const Stamp corners[] = {content[indices[i]], content[indices[i + 1]], content[indices[i + 2]]};
    const Stamp triangle = content_hash(std::span<const Stamp>(corners));
    certificate.sum.high += triangle.high;
    certificate.sum.low += triangle.low;
    ++certificate.triangles;
  }
  return certificate;
}

std::vector<Certificate> certificates_of(const Draw& draw, Analyses& analyses) {
  std::vector<Certificate> all;
  for (const Level& level : draw.levels) {
    for (const IndexStream& stream : level.orders) {
      all.push_back(certificate_of(*level.vertices, stream.indices.view(), analyses));
    }
  }
  return all;
}

}  // namespace foredraw
