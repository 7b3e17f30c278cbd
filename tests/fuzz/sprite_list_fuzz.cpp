// A frame list, beside an image of 64 x 32 texels called a.png. It is read or refused with a reason; what is read is
// written as every kind of file, and its own list is read again, with the same frames.

#include "claim.h"
#include "support/sprites.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/io/sprite/sprite_files.h>

#include <unistd.h>

namespace {

/// Gone when the program is.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("foredraw-lists-" + std::to_string(getpid()));
  Folder() {
    std::filesystem::create_directories(path);
    foredraw::testing::put_bytes(path / "a.png", foredraw::testing::disc_png(64, 32));
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  static const Folder folder;
  const std::string name = (folder.path / "list.json").string();
  Diagnostics diagnostics;
  const auto scene = read_sprite_list(std::as_bytes(std::span(data, size)), name, folder.path, diagnostics);
  claim(scene.has_value() != diagnostics.has_errors(), "read and not read at once: " + to_text(diagnostics));
  if (!scene || scene->draws.size() > 64) return 0;

  for (const char* target : {"out.json", "out.h", "out.html", "out.glb"}) {
    const auto files = encode_scene(*scene, (folder.path / target).string(), diagnostics);
    claim(files.has_value(), std::string(target) + " can not be written: " + to_text(diagnostics));
    if (std::string_view(target) != "out.json") continue;
    const auto again = read_sprite_list(files->front().bytes, name, folder.path, diagnostics);
    claim(again.has_value(), "what was written can not be read: " + to_text(diagnostics));
    claim(again->draws.size() == scene->draws.size(), "frames were lost");
    for (std::size_t i = 0; i < scene->draws.size(); ++i) {
      claim(again->draws[i].name == scene->draws[i].name && again->draws[i].frame == scene->draws[i].frame,
            "a frame is another one");
    }
  }
  return 0;
}
