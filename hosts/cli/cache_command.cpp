// Looking after a cache.

#include "session.h"

#include <foredraw/base/counted.h>
#include <foredraw/cache/upkeep.h>

#include <fmt/format.h>

namespace foredraw::cli {

Exit cache(const CacheArguments& arguments, const Registry&) {
  Diagnostics diagnostics;
  const std::filesystem::path folder = arguments.inputs[0];
  std::error_code error;
  if (!std::filesystem::is_regular_file(folder / name_of_cache_file, error)) {
    diagnostics.error({.file = folder.string()}, "no-cache", "is not a cache of foredraw",
                      "name the folder that --cache was given");
    return refuse(diagnostics);
  }
  const auto cache = Cache::in(folder, diagnostics);
  if (!cache) return refuse(diagnostics);
  std::string text;
  std::uint64_t damaged = 0, gone = 0;
  if (arguments.verify) {
    damaged = verify_cache(folder, *cache, diagnostics);
    text += damaged == 0 ? "every entry is sound\n"
                         : fmt::format("{}\n", counted(damaged, "damaged entry", "damaged entries"));
  }
  if (arguments.trim) {
    gone = trim_cache(folder, *arguments.trim);
    text += fmt::format("{} removed\n", counted(gone, "entry", "entries"));
  }
  tell(diagnostics);
  const CacheContents contents = contents_of_cache(folder);
  const double hours = contents.oldest == 0 ? 0 : static_cast<double>(file_clock() - contents.oldest) / 3.6e12;
  text += fmt::format("{} of {}; the oldest was used {:.1f} hours ago\n", counted(contents.entries, "entry", "entries"),
                      counted(contents.bytes, "byte"), hours);
  if (arguments.json) {
    text = fmt::format(
        "{{\n  \"cache\": 1,\n  \"entries\": {},\n  \"bytes\": {},\n  \"removed\": {},\n  \"damaged\": {}\n}}\n",
        contents.entries, contents.bytes, gone, damaged);
  }
  return std::max(damaged == 0 ? done : something_failed, print(text));
}

}  // namespace foredraw::cli
