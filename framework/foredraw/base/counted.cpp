#include <foredraw/base/counted.h>

namespace foredraw {

std::string counted(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view several) {
  std::string text = counted(count) + ' ';
  if (count != 1 && !several.empty()) return text += several;
  text += one;
  return count == 1 ? text : text + 's';
}

}  // namespace foredraw
