#pragma once
// Numbers and texts in a row of bytes, as they go from one process to another of the same machine.

#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace foredraw {

class WireWriter {
 public:
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void put(Number number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  /// Its first 4000 bytes. NULL stays NULL.
  void put(const char* text) {
    constexpr std::size_t most = 4000;
    put(text != nullptr);
    if (text == nullptr) return;
    const std::string_view whole(text, strnlen(text, most));
    put(static_cast<std::uint32_t>(whole.size()));
    bytes_ += whole;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Trusts nobody: std::runtime_error where the bytes end too soon.
class WireReader {
 public:
  explicit WireReader(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  requires std::is_arithmetic_v<Number> Number number() {
    Number number{};
    std::memcpy(&number, taken(sizeof number).data(), sizeof number);
    return number;
  }
  bool flag() { return number<unsigned char>() != 0; }
  std::optional<std::string> text() {
    if (!flag()) return std::nullopt;
    return std::string(taken(number<std::uint32_t>()));
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view taken(std::size_t count) {
    if (count > rest_.size()) throw std::runtime_error("it sent less than it should");
    const std::string_view part = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return part;
  }

  std::string_view rest_;
};

}  // namespace foredraw
