#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/output_words.h>

using namespace foredraw;
using namespace foredraw::c;

int foredraw_read(foredraw_context* context, const char* path, foredraw_scene** scene, foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (scene != nullptr) *scene = nullptr;
    if (context == nullptr || path == nullptr || scene == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    auto file = read_scene(path, diagnostics, context->input());
    put(diagnostics, problems);
    if (!file) return FOREDRAW_FAILED;
    *scene = new foredraw_scene{
        std::make_shared<const HeldScene>(std::move(file->scene), FileRecord{path, file->bytes, to_text(file->stamp)})};
    return FOREDRAW_DONE;
  });
}

int foredraw_read_memory(foredraw_context* context, const void* bytes, uint64_t size, const char* name,
                         foredraw_scene** scene, foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (scene != nullptr) *scene = nullptr;
    if (context == nullptr || (bytes == nullptr && size > 0) || scene == nullptr) return FOREDRAW_NULL_POINTER;
    const auto* first = static_cast<const std::byte*>(bytes);
    const std::string called = name == nullptr ? "memory" : name;
    const Stamp stamp = content_hash(std::span(first, size));
    Diagnostics diagnostics;
    auto read = read_gltf({first, first + size}, called, {}, diagnostics, context->input());
    put(diagnostics, problems);
    if (!read) return FOREDRAW_FAILED;
    *scene =
        new foredraw_scene{std::make_shared<const HeldScene>(std::move(*read), FileRecord{"", size, to_text(stamp)})};
    return FOREDRAW_DONE;
  });
}

namespace foredraw::c {

namespace {

/// The files that `path` stands for; nullopt, with errors, where there are none, for which `status` says why.
std::optional<std::vector<OutputFile>> files_of(const foredraw_context& context, const HeldScene& held,
                                                const char* path, const char* settings, Diagnostics& diagnostics,
                                                int& status) {
  OutputSettings as = held.output;
  status = FOREDRAW_MISTAKE;
  if (settings != nullptr && !set_output(as, settings, "settings", diagnostics)) return std::nullopt;
  status = FOREDRAW_FAILED;
  const JobOutput output{{}, path};
  if (!can_write({output}, held.file.path, diagnostics)) return std::nullopt;
  auto files = encode(held.scene, output, as, context.registry.products(), diagnostics);
  if (files) status = FOREDRAW_DONE;
  return files;
}

}  // namespace

}  // namespace foredraw::c

int foredraw_write(foredraw_context* context, const foredraw_scene* scene, const char* path, foredraw_text* problems) {
  return foredraw_write_as(context, scene, path, nullptr, problems);
}

int foredraw_write_as(foredraw_context* context, const foredraw_scene* scene, const char* path, const char* settings,
                      foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (context == nullptr || scene == nullptr || path == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    int status = FOREDRAW_DONE;
    const auto files = files_of(*context, *scene->held, path, settings, diagnostics, status);
    if (files && !(have_folders({path}, diagnostics) && write_scene(*files, diagnostics))) status = FOREDRAW_FAILED;
    put(diagnostics, problems);
    return status;
  });
}

int foredraw_write_memory(foredraw_context* context, const foredraw_scene* scene, const char* name,
                          const char* settings, foredraw_text* file, foredraw_text* problems) {
  if (file != nullptr) *file = {nullptr, 0};
  return at_border(problems, [&]() -> int {
    if (context == nullptr || scene == nullptr || name == nullptr || file == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    int status = FOREDRAW_DONE;
    const auto files = files_of(*context, *scene->held, name, settings, diagnostics, status);
    if (files && files->size() > 1) {
      diagnostics.error({.file = name}, "several-files", "the scene takes several files, but memory holds one",
                        "write a .glb, or leave out compressed data and its copies with compression=none");
      status = FOREDRAW_FAILED;
    }
    put(diagnostics, problems);
    if (status != FOREDRAW_DONE) return status;
    const std::vector<std::byte>& bytes = files->front().bytes;
    put(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), file);
    return FOREDRAW_DONE;
  });
}
