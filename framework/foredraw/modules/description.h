#pragma once
// What a module says of itself, on its way from the process that loaded it.

#include <foredraw/c/module.h>

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// The module's tables, written down. std::invalid_argument says what is wrong with them, as far as they could not be
/// read otherwise: versions, sizes, counts, NULL.
std::string written_down(const foredraw_module* module);

/// The same read again, in memory of its own. What is called here has no user, and its run can not be called.
class DescribedModule {
 public:
  /// std::runtime_error where these are no such bytes.
  explicit DescribedModule(std::string_view bytes);
  DescribedModule(const DescribedModule&) = delete;
  DescribedModule& operator=(const DescribedModule&) = delete;

  std::string vendor;
  std::string version;
  std::vector<foredraw_plugin> plugins;

 private:
  std::deque<std::string> texts_;
  std::deque<std::vector<const char*>> choices_;
  std::deque<std::vector<foredraw_option>> options_;
  std::deque<std::vector<foredraw_metric>> metrics_;
};

}  // namespace foredraw
