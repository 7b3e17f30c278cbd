#include <foredraw/io/imported_file.h>

#include <foredraw/base/counted.h>
#include <foredraw/base/printable.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/import_block.h>
#include <foredraw/io/text/private/file_kind.h>
#include <foredraw/platform/file_facts.h>
#include <foredraw/platform/files.h>
#include <foredraw/platform/program_stamp.h>
#include <foredraw/platform/shared_block.h>
#include <foredraw/platform/shared_library.h>
#include <foredraw/platform/supervised.h>
#include <foredraw/platform/watched_process.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <span>
#include <system_error>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

/// What Assimp reads and people still have. Formats that are ours are not among them.
constexpr std::array<std::string_view, 18> extensions = {".3ds",   ".3mf",     ".ac",   ".amf", ".ase", ".b3d",
                                                         ".blend", ".cob",     ".dae",  ".dxf", ".fbx", ".lwo",
                                                         ".lws",   ".md5mesh", ".ms3d", ".x",   ".x3d", ".xgl"};

/// Where the environment says something else than a number, that is wrong.
template <class Number>
void read_number(const char* name, const char* unit, Number& number, std::string& wrong) {
  const char* text = std::getenv(name);
  if (text == nullptr || *text == '\0') return;
  Number read{};
  const char* end = text + std::strlen(text);
  if (std::from_chars(text, end, read).ptr == end && read > 0) {
    number = read;
  } else {
    wrong = fmt::format("the environment has {}={}, which is no number of {} above 0", name, printable(text), unit);
  }
}

/// Of the environment; empty: it names none.
std::string named_importer() {
  const char* named = std::getenv("FOREDRAW_IMPORTER");
  return named == nullptr ? "" : named;
}

fs::path found_importer(const std::string& named) {
  std::error_code error;
  if (!named.empty()) return fs::exists(named, error) ? fs::absolute(named, error) : fs::path();
  for (const fs::path& from : {program_folder(), own_folder()}) {
    for (const char* way : {"", "../libexec/foredraw", "../../libexec/foredraw"}) {
      const fs::path place = from / way / "foredraw-import";
      if (!from.empty() && fs::exists(place, error)) return place.lexically_normal();
    }
  }
  return {};
}

/// What became of an import, beside the GLB.
struct ImportEnd {
  std::string why;  ///< empty: the GLB is whole
  std::string hint;
};

constexpr const char* other_way = "export the scene as .glb from the program that made it";

ImportEnd without_memory(const ImportLimits& limits) {
  return {fmt::format("the importer needs more than the {} bytes of memory that it may have", counted(limits.memory)),
          "set FOREDRAW_IMPORT_MEMORY to more bytes, or " + std::string(other_way)};
}

/// How a process ended that handed over nothing.
ImportEnd end_without_answer(const ImportBlock& block, const ImportLimits& limits) {
  if (limits.memory != 0 && block.peak_memory > limits.memory / 10 * 9) return without_memory(limits);
  std::string why = block.by_signal != 0
                        ? "the importer crashed on it (" + signal_name(block.code) + ")"
                        : fmt::format("the importer left without an answer (exit code {})", block.code);
  const std::size_t bytes = std::min<std::size_t>(block.last_words_bytes, sizeof block.last_words);
  std::string_view words(block.last_words, bytes);
  while (!words.empty() && static_cast<unsigned char>(words.back()) <= ' ') words.remove_suffix(1);
  if (!words.empty()) why += "; it wrote: " + printable(words);
  return {std::move(why), "the file may be damaged: " + std::string(other_way)};
}

/// Waits for the end, or for the time to be over.
ImportEnd wait_for_import(const ImportBlock& block, WatchedProcess& process, const ImportLimits& limits) {
  using namespace std::chrono_literals;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto begins = static_cast<std::uint32_t>(ImportTurn::begins);
  while (block.turn.load() == begins) {
    if (process.ended_within(0ms) && block.turn.load() == begins) {
      return {"the importer " + limits.importer.string() + " ended without an answer",
              "check that FOREDRAW_IMPORTER, if it is set, names foredraw-import; or " + std::string(other_way)};
    }
    if (std::chrono::duration<double>(Clock::now() - begin).count() > limits.seconds) {
      return {fmt::format("the importer was not done within {} {}", limits.seconds,
                          limits.seconds == 1 ? "second" : "seconds"),
              "set FOREDRAW_IMPORT_SECONDS to more, or " + std::string(other_way)};
    }
    wait_while(block.turn, begins, 50);
  }
  if (block.is_whole != 0 && block.by_signal == 0 && block.code == 0) return {};
  if (block.is_refused != 0) return {"the importer refuses it", other_way};
  return end_without_answer(block, limits);
}

/// Throws std::system_error where there is no block, or no process.
ImportEnd run_importer(const SharedBlock& shared, const std::string& file, const std::string& root,
                       const ImportLimits& limits) {
  WatchedProcess process(limits.importer,
                         {"--handed", std::to_string(process_number()), std::to_string(limits.memory), file, root},
                         std::array{shared.descriptor()});
  return wait_for_import(*reinterpret_cast<const ImportBlock*>(shared.data()), process, limits);
}

/// What it handed over; nothing where it says that there is more than there is room.
std::span<const std::byte> handed(const SharedBlock& shared) {
  const std::uint64_t bytes = reinterpret_cast<const ImportBlock*>(shared.data())->glb_bytes;
  if (bytes > shared.size() - glb_place) return {};
  return {shared.data() + glb_place, static_cast<std::size_t>(bytes)};
}

/// Tells of files and of what was left out; a refusal's reason becomes the end's.
void take_told(const SharedBlock& shared, const std::string& file, const SceneInput& how, const ImportLimits& limits,
               Diagnostics& diagnostics, ImportEnd& end) {
  const ImportBlock& block = *reinterpret_cast<const ImportBlock*>(shared.data());
  const std::string all(reinterpret_cast<const char*>(shared.data() + told_place),
                        std::min<std::size_t>(block.told_bytes, told_room));
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t stop = std::min(all.find('\0', begin), all.size());
    const std::string text = all.substr(begin + 1, stop - begin - 1);
    switch (static_cast<ImportTold>(all[begin])) {
      case ImportTold::read: {
        Diagnostics unsaid;
        if (how.files) read_file(text, unsaid, FileRead::all_of_it, how.files.get());
        break;
      }
      case ImportTold::missing:
        if (how.files) how.files->missing(text);
        break;
      case ImportTold::left_out: {
        const std::size_t line = std::min(text.find('\n'), text.size());
        diagnostics.warning({.file = file}, "import-left-out", printable(text.substr(0, line)),
                            printable(text.substr(std::min(line + 1, text.size()))));
        break;
      }
      case ImportTold::no_memory: end = without_memory(limits); break;
      case ImportTold::refused:
        if (!end.why.empty()) end.why = "the importer refuses it: " + printable(text);
        break;
    }
    begin = stop + 1;
  }
}

}  // namespace

ImportLimits import_limits() {
  ImportLimits limits;
  read_number("FOREDRAW_IMPORT_SECONDS", "seconds", limits.seconds, limits.wrong);
  read_number("FOREDRAW_IMPORT_MEMORY", "bytes", limits.memory, limits.wrong);
  const std::string named = named_importer();
  limits.importer = found_importer(named);
  if (limits.importer.empty() && !named.empty()) {
    limits.wrong = "the environment has FOREDRAW_IMPORTER=" + printable(named) + ", and there is no such file";
  }
  return limits;
}

bool is_imported_file(const fs::path& path) {
  return std::ranges::find(extensions, lower_extension(path)) != extensions.end();
}

std::string imported_extensions() {
  std::string text;
  for (const std::string_view extension : extensions) text.append(text.empty() ? "" : ", ").append(extension);
  return text;
}

Stamp importer_stamp(const ImportLimits& limits) {
  if (limits.importer.empty()) return {};
  const auto file = hashed_content(limits.importer.string(), ~std::uint64_t{0});
  const Stamp alone = file ? file->stamp : Stamp{};
  try {
    const SharedBlock shared(import_block_bytes, false);
    if (!run_importer(shared, "", "", limits).why.empty()) return alone;
    return combine(std::array{alone, content_hash(handed(shared))});
  } catch (const std::system_error&) {
    return alone;
  }
}

std::optional<Scene> read_imported(const fs::path& path, Diagnostics& diagnostics, const SceneInput& how,
                                   const ImportLimits& limits) {
  const std::string file = path.string();
  if (!limits.wrong.empty()) {
    diagnostics.error({.file = file}, "bad-environment", "cannot be imported: " + limits.wrong,
                      "set it to what is expected, or unset it");
    return std::nullopt;
  }
  if (limits.importer.empty()) {
    diagnostics.error({.file = file}, "no-importer",
                      "files of this kind are read by foredraw-import, which is not there",
                      "install the package foredraw-import, or build it where the package libassimp-dev is, or " +
                          std::string(other_way));
    return std::nullopt;
  }
  std::vector<std::byte> glb;
  try {
    const SharedBlock shared(import_block_bytes, false);
    ImportEnd end = run_importer(shared, fs::absolute(path).string(),
                                 how.root.empty() ? "" : fs::absolute(how.root).string(), limits);
    take_told(shared, file, how, limits, diagnostics, end);
    if (!end.why.empty()) {
      diagnostics.error({.file = file}, "import-failed", end.why, end.hint);
      return std::nullopt;
    }
    const auto bytes = handed(shared);
    glb.assign(bytes.begin(), bytes.end());
  } catch (const std::system_error& error) {
    diagnostics.error({.file = file}, "import-failed", std::string("the importer can not be run: ") + error.what(),
                      "check that you may run it, or " + std::string(other_way));
    return std::nullopt;
  }
  return read_gltf(std::move(glb), file, {}, diagnostics, how);
}

}  // namespace foredraw
