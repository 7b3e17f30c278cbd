#pragma once
// What one file came to, found again by the content of every file that was read for it. Which files these are is known
// only once they were read, so, unless it was read alone, a list comes first: by the content of the file itself, the
// files that were read along with it before, and what they held. ccache's direct mode does the same with the headers of
// a source file.

#include <foredraw/base/files_read.h>
#include <foredraw/cache/cache.h>

#include <string>
#include <vector>

namespace foredraw {

/// What is to be done with a file.
struct Work {
  Stamp how;                    ///< of all that decides what comes out, but for the files
  std::filesystem::path input;  ///< the file itself; others are looked for from its folder on
  std::string place;  ///< names of files, and where they lie to each other: it counts for what holds such names
};

struct WorkRead {
  std::vector<FileRead> own;   ///< for this file, itself among them
  std::vector<FileRead> lent;  ///< for options, whichever file is worked on
};

struct FoundResult {
  Stamp key;  ///< of the entry
  Cache::Entry entry;
  std::vector<std::filesystem::path> read;    ///< the files that it was made from, the input first
  std::vector<std::filesystem::path> sought;  ///< that were only looked for, there or not
};

/// Nothing where there is none, or a file can not be read.
std::optional<FoundResult> find_result(const Cache& cache, const Work& work, Diagnostics& damaged);

/// Why it could not be kept; empty: it is. What was read from files that changed meanwhile is not kept, without a word.
/// `depends_on_place`: whether Work::place counts.
std::string keep_result(const Cache& cache, const Work& work, const WorkRead& read, bool depends_on_place,
                        std::string_view about, std::span<const std::span<const std::byte>> contents);

}  // namespace foredraw
