#include <foredraw/io/gltf/gltf.h>

#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/text/private/uri.h>

#include <algorithm>

#include <fmt/format.h>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

/// The input's own bytes, and those of its buffers where they are files beside; nullopt where these would not lie
/// beside the target, or are not called as those of such a scene: then another may have them too, and write its own.
std::optional<std::vector<OutputFile>> as_it_was(const gltf::Document& document, const fs::path& target) {
  const auto bytes = document.file.view();
  std::vector<OutputFile> files{{target, {bytes.begin(), bytes.end()}}};
  std::error_code error;
  const bool same_folder = fs::equivalent(fs::absolute(target).parent_path(), document.folder, error);
  if (same_folder) return files;
  for (std::size_t i = 0; i < document.buffers.size(); ++i) {
    const Json& buffer = document.json["buffers"][i];
    const bool beside = buffer.contains("uri") && !gltf::is_data_uri(buffer["uri"].get<std::string>());
    if (!beside || document.buffers[i].bytes.empty()) continue;
    const std::string name = *gltf::percent_decoded(buffer["uri"].get<std::string>());
    const fs::path file(std::u8string(name.begin(), name.end()));
    if (file.has_parent_path() || document.binary || file != gltf::buffer_beside(document.name).filename())
      return std::nullopt;
    const auto bytes_beside = document.buffers[i].bytes;
    OutputFile copy{target.parent_path() / file, {bytes_beside.begin(), bytes_beside.end()}};
    const auto same = std::ranges::find(files, copy.path, &OutputFile::path);  // two buffers may begin one file
    if (same == files.end()) {
      files.push_back(std::move(copy));
    } else if (same->bytes.size() < copy.bytes.size()) {
      *same = std::move(copy);
    }
  }
  return files;
}

/// A scene that was not read from a file is all additions to an empty one.
std::shared_ptr<const gltf::Source> empty_source(const Scene& scene) {
  gltf::Document document;
  document.name = scene.name;
  document.json = JsonObject{{"asset", JsonObject{{"version", "2.0"}, {"generator", "foredraw"}}}};
  return std::make_shared<const gltf::Source>(std::move(document), Scene{});
}

/// "data written uncompressed: 1,200 -> 4,600 bytes" for each cause. What no cause explains is text and padding.
std::string causes(std::uint64_t grown, const std::vector<gltf::Sizes>& sizes) {
  std::vector<std::string> words;
  std::int64_t rest = static_cast<std::int64_t>(grown);
  for (const gltf::Sizes& part : sizes) {
    rest -= static_cast<std::int64_t>(part.after) - static_cast<std::int64_t>(part.before);
    if (part.after > part.before)
      words.push_back(fmt::format("{}: {} -> {} bytes", part.what, counted(part.before), counted(part.after)));
  }
  if (rest > 0)
    words.push_back(fmt::format("JSON and padding: {} bytes more", counted(static_cast<std::uint64_t>(rest))));
  return fmt::format("{}", fmt::join(words, "; "));
}

void tell_growth(std::uint64_t before, const std::vector<OutputFile>& files, const std::vector<gltf::Sizes>& sizes,
                 Diagnostics& diagnostics) {
  std::uint64_t after = 0;
  for (const OutputFile& file : files) after += file.bytes.size();
  if (before == 0 || after <= before) return;
  diagnostics.note({.file = files.front().path.string()}, "output-grew",
                   fmt::format("the output has {} bytes; the input had {}", counted(after), counted(before)),
                   causes(after - before, sizes));
}

}  // namespace

std::optional<std::vector<OutputFile>> encode_gltf(const Scene& scene, const fs::path& target, Diagnostics& diagnostics,
                                                   const GltfOutput& as) {
  const auto kept = std::dynamic_pointer_cast<const gltf::Source>(scene.source);
  const auto source = kept ? kept : empty_source(scene);
  GltfOutput how = as;
  if (how.products.empty()) how.products = source->document.products;
  const bool may_stay = kept && gltf::is_glb(target) == kept->document.binary;
  auto written = gltf::patched(scene, *source, target, may_stay, how, diagnostics);
  if (written && !written->changed) {
    if (auto files = as_it_was(source->document, target)) return files;
    written = gltf::patched(scene, *source, target, false, how, diagnostics);
  }
  if (!written) return std::nullopt;
  const std::vector<gltf::Sizes> sizes = written->laid_out.sizes;
  auto files = gltf::packed(std::move(*written), target, diagnostics);
  if (files) tell_growth(scene.source ? scene.source->bytes() : 0, *files, sizes, diagnostics);
  return files;
}

}  // namespace foredraw
