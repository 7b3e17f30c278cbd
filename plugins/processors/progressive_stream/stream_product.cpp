#include "stream_product.h"

#include "schemas.h"
#include "stream_mesh.h"

#include <foredraw/collapses/named_primitives.h>

#include <algorithm>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

class StreamRow final : public ProductRow {
 public:
  StreamRow()
      : ProductRow({.name = std::string(ProgressiveStreams::product),
                    .title = "progressive streams",
                    .extension = "FOREDRAW_progressive_stream",
                    .remedy = "make the streams again",
                    .accessors_of_file = {"meshes/*/stream"},
                    .schemas = schemas(),
                    .side_files = {{".json", ".bin"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    const ExtensionValue* file = from.of_file();
    const ExtensionValue* meshes = file == nullptr ? nullptr : file->member("meshes");
    if (meshes == nullptr || meshes->list() == nullptr || meshes->list()->empty()) {
      return "it has no array 'meshes' with a mesh";
    }
    ProgressiveStreams all;
    for (const ExtensionValue& one : *meshes->list()) {
      auto draws = named_primitives(one.member("primitives"), scene);
      if (!draws) return "it names a primitive that is not there";
      const ExtensionValue* stream = one.member("stream");
      const auto data = stream != nullptr && stream->whole() ? from.accessor(*stream->whole()) : std::nullopt;
      if (!data || !(data->format == Format{Component::uint8, 1, false, 1})) {
        return "meshes[" + std::to_string(all.meshes.size()) + "] has no stream of type SCALAR and 5121";
      }
      all.meshes.push_back({std::move(*draws), data->bytes});
    }
    scene.products.set(std::move(all));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    to.put_on_file(Members{
        {"meshes", listed(scene.products.find<ProgressiveStreams>()->meshes, [&](const StreamedDraws& mesh) {
           return Members{{"primitives", names_of_primitives(mesh.draws, scene)},
                          {"stream", to.accessor({{Component::uint8, 1, false, 1}, mesh.bytes.size(), mesh.bytes})}};
         })}});
  }

  std::string difference(const Scene& scene) const override {
    return first_difference(scene.products.find<ProgressiveStreams>()->meshes, scene,
                            [&](const auto& mesh) { return why_not(mesh, scene); });
  }

  /// Which triangles and vertices come first is all the same.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    ProgressiveStreams left;
    std::vector<std::string> told;
    for (const StreamedDraws& mesh : after.products.find<ProgressiveStreams>()->meshes) {
      const auto is_alike = [&](DrawId id) {
        if (id >= before.draws.size() || id >= after.draws.size()) return false;
        const Level &was = before.draws[id].full(), &is = after.draws[id].full();
        return was.vertices == is.vertices && was.stream().indices.is(is.stream().indices);
      };
      if (std::ranges::all_of(mesh.draws, is_alike) || why_not(mesh, after).empty()) {
        left.meshes.push_back(mesh);
      } else {
        told.push_back("the progressive stream of " + before.draws[mesh.draws.front()].name +
                       " is left out: its triangles or vertices were changed");
      }
    }
    const bool is_empty = left.meshes.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  /// An index for programs that fetch a stream piece by piece, and all streams one behind the other.
  SideFile side_file(const Scene& scene, std::string_view, const std::string& beside) const override {
    SideFile file;
    List meshes;
    for (const StreamedDraws& mesh : scene.products.find<ProgressiveStreams>()->meshes) {
      const auto stream = StreamMesh::read(mesh.bytes.view());
      if (!stream) throw Refusal("damaged-stream", "a progressive stream is damaged", card().remedy);
      const NumberGrid grid = stream->grid();
      List draws;
      for (std::size_t d = 0; d < mesh.draws.size(); ++d) {
        const Draw& draw = scene.draws[mesh.draws[d]];
        const auto numbers = number_names(*draw.full().vertices, grid.parts[stream->mesh().draw_part[d]]);
        draws.push_back(Members{{"name", draw.name}, {"numbers", List(numbers.begin(), numbers.end())}});
      }
      const auto& ends = stream->chunk_end();
      meshes.push_back(Members{{"primitives", names_of_primitives(mesh.draws, scene)},
                               {"draws", std::move(draws)},
                               {"byteOffset", file.beside.size()},
                               {"byteLength", mesh.bytes.size()},
                               {"chunkEnds", List(ends.begin(), ends.end())}});
      file.beside.insert(file.beside.end(), mesh.bytes.view().begin(), mesh.bytes.view().end());
    }
    file.content = ExtensionValue(Members{{"file", beside}, {"meshes", std::move(meshes)}});
    return file;
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "progressive streams (to send a mesh piece by piece)", .value = List()};
    for (const StreamedDraws& mesh : scene.products.find<ProgressiveStreams>()->meshes) {
      const auto stream = StreamMesh::read(mesh.bytes.view());
      if (!stream) continue;  // difference() has said so
      std::string names;
      for (const DrawId id : mesh.draws) names += (names.empty() ? "" : ", ") + scene.draws[id].name;
      text.lines.push_back(names + ": chunks " + std::to_string(stream->header().chunks) + ", bytes " +
                           std::to_string(mesh.bytes.size()) + ", vertices " +
                           std::to_string(stream->header().vertices) + ", triangles " +
                           std::to_string(stream->header().triangles));
      text.value.push(Members{{"draws", names},
                              {"chunks", stream->header().chunks},
                              {"bytes", mesh.bytes.size()},
                              {"vertices", stream->header().vertices},
                              {"triangles", stream->header().triangles}});
    }
    return text;
  }

 private:
  static std::string why_not(const StreamedDraws& mesh, const Scene& scene) {
    Analyses analyses;
    const auto joined = joined_mesh(scene, mesh.draws, analyses);
    if (!joined) return "a draw of theirs is gone";
    const auto stream = StreamMesh::read(mesh.bytes.view());
    if (!stream) return scene.draws[mesh.draws.front()].name + ": the bytes of its stream are damaged";
    std::string why = foredraw::difference(*stream, *joined);
    return why.empty() ? why : scene.draws[mesh.draws.front()].name + ": " + why;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> stream_product() { return std::make_shared<const StreamRow>(); }

}  // namespace foredraw
