#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/io/scene_file.h>

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
        std::make_shared<const HeldScene>(std::move(file->scene), path, file->bytes, to_text(file->stamp))};
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
    *scene = new foredraw_scene{std::make_shared<const HeldScene>(std::move(*read), "", size, to_text(stamp))};
    return FOREDRAW_DONE;
  });
}

int foredraw_write(foredraw_context* context, const foredraw_scene* scene, const char* path, foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (context == nullptr || scene == nullptr || path == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    bool is_written = false;
    if (can_write_scene(path, scene->held->path, diagnostics)) {
      const GltfOutput as{.products = context->registry.products()};
      const auto files = encode_scene(scene->held->scene, path, diagnostics, as);
      is_written = files && write_scene(*files, diagnostics);
    }
    put(diagnostics, problems);
    return is_written ? FOREDRAW_DONE : FOREDRAW_FAILED;
  });
}
