// foredraw-import INPUT OUTPUT.glb: a scene that Assimp reads, as glTF. The program foredraw starts it by itself, with
// --handed, where it is given such a scene.
#include "import_file.h"
#include "serve_import.h"

#include <foredraw/platform/files.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <stdexcept>

namespace {

template <class Number>
bool read(const char* text, Number& number) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, number).ptr == end;
}

constexpr const char* usage =
    "foredraw-import INPUT OUTPUT.glb: reads FBX, COLLADA, 3DS, Blend and other scenes, and writes glTF\n";

void check(const std::filesystem::path& input, const std::filesystem::path& output) {
  std::error_code error;
  if (!std::filesystem::exists(input, error)) throw std::runtime_error("there is no such file");
  if (std::filesystem::is_directory(input, error)) throw std::runtime_error("is a folder; a file was expected");
  if (output.extension() != ".glb") {
    throw std::runtime_error("becomes a GLB: give the output the extension .glb, and not " + output.string());
  }
}

int import_to(const char* input, const char* output) {
  check(input, output);
  foredraw::import::Told told;
  const std::string glb = foredraw::import::import_file(input, {}, told);
  for (std::string text : told.left_out) {
    if (const auto line = text.find('\n'); line != std::string::npos) text.insert(line + 1, "    hint: ");
    std::fprintf(stderr, "%s: warning: %s\n", input, text.c_str());
  }
  foredraw::OutputFile file{output, {}};
  const auto* bytes = reinterpret_cast<const std::byte*>(glb.data());
  file.bytes.assign(bytes, bytes + glb.size());
  foredraw::Diagnostics diagnostics;
  if (foredraw::write_files({&file, 1}, diagnostics)) return 0;
  std::fputs(to_text(diagnostics).c_str(), stderr);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  int parent = 0;
  std::uint64_t memory = 0;
  try {
    if (argc == 6 && std::strcmp(argv[1], "--handed") == 0 && read(argv[2], parent) && read(argv[3], memory)) {
      return foredraw::import::serve_import(argv[4], argv[5], parent, memory);
    }
    if (argc == 3 && argv[1][0] != '-') return import_to(argv[1], argv[2]);
    const bool asks = argc == 2 && (std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "-h") == 0);
    std::fputs(usage, asks ? stdout : stderr);
    if (asks) return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: error: %s\n", argc > 1 ? argv[1] : "foredraw-import", error.what());
  }
  return 1;
}
