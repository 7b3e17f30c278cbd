#pragma once
#include <string>
#include <vector>

namespace foredraw {

/// A text table: columns as wide as their widest cell, two spaces between, a line under the heads.
class Table {
 public:
  explicit Table(std::vector<std::string> heads) : rows_{std::move(heads)} {}

  void add(std::vector<std::string> cells);
  bool empty() const { return rows_.size() == 1; }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// How many characters a UTF-8 text shows.
std::size_t shown_width(const std::string& text);

}  // namespace foredraw
