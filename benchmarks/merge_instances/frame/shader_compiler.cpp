#include "shader_compiler.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

namespace foredraw::bench {

namespace fs = std::filesystem;

namespace {

/// A folder of our own that is gone in the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::random_device random;
    do {
      path_ = fs::temp_directory_path() / ("foredraw-shader-" + std::to_string(random()));
    } while (!fs::create_directory(path_));
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  fs::path file(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

std::vector<char> contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

bool has_shader_compiler() { return std::system("glslangValidator --version > /dev/null 2>&1") == 0; }

std::vector<std::uint32_t> compiled_shader(const std::string& text, const std::string& stage) {
  const ScratchFolder folder;
  const fs::path source = folder.file("shader.glsl"), code = folder.file("shader.spv"),
                 messages = folder.file("messages.txt");
  std::ofstream(source) << text;
  const std::string command = "glslangValidator -V -S " + stage + " -o \"" + code.string() + "\" \"" + source.string() +
                              "\" > \"" + messages.string() + "\" 2>&1";
  if (std::system(command.c_str()) != 0) {
    const std::vector<char> said = contents(messages);
    throw std::runtime_error("glslangValidator (Debian: glslang-tools) cannot compile a shader: " +
                             std::string(said.begin(), said.end()) + text);
  }
  const std::vector<char> bytes = contents(code);
  std::vector<std::uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), 4 * words.size());
  return words;
}

}  // namespace foredraw::bench
