#pragma once
// Names that differ. Private to io.

#include <map>
#include <string>

namespace foredraw::sprites {

class FreeNames {
 public:
  explicit FreeNames(std::string between) : between_(std::move(between)) {}

  /// The name, or, where it is taken, with the next number that is free: "spark", "spark#2". It is taken then.
  std::string take(const std::string& name) {
    const auto [first, is_free] = last_number_.try_emplace(name, 1);
    if (is_free) return name;
    std::string numbered;
    do {
      numbered = name + between_ + std::to_string(++first->second);
    } while (!last_number_.try_emplace(numbered, 1).second);
    return numbered;
  }

 private:
  std::string between_;
  std::map<std::string, int> last_number_;
};

}  // namespace foredraw::sprites
