#pragma once
// What stands in a cache's entry of a file that was optimised beside the contents: where they went.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

struct ResultAbout {
  struct File {
    std::size_t output = 0;  ///< that it is a file of
    std::string name = {};   ///< beside the output's own path; empty: it is that
  };

  std::string input;                 ///< by the path that was given
  std::vector<std::string> outputs;  ///< likewise
  std::string pipeline;              ///< as the report has it
  std::vector<File> files;  ///< the entry's first contents; the report's JSON form and its text come behind them
};

std::string to_text(const ResultAbout& about);
/// Nothing where it is none.
std::optional<ResultAbout> result_about(std::string_view text);

}  // namespace foredraw
