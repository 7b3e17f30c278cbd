#include <foredraw/io/text/private/uri.h>

#include <algorithm>
#include <array>

namespace foredraw::gltf {

namespace {

int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

int base64(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (is_digit(c)) return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::optional<std::vector<std::byte>> decode_base64(std::string_view text) {
  for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int held = 0;
  for (char c : text) {
    const int value = base64(c);
    if (value < 0) return std::nullopt;
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<std::byte>((bits >> held) & 0xff));
    }
  }
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  constexpr std::string_view scheme = "data:";
  return uri.size() >= scheme.size() && std::equal(scheme.begin(), scheme.end(), uri.begin(), [](char a, char b) {
           return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b + 32) : b);
         });
}

std::optional<DataUri> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
  std::string_view head = uri.substr(5, comma - 5);
  const std::string_view body = uri.substr(comma + 1);
  constexpr std::string_view mark = ";base64";
  const bool coded = head.size() >= mark.size() && head.substr(head.size() - mark.size()) == mark;
  if (coded) head.remove_suffix(mark.size());
  if (head.find(";;") != std::string_view::npos || (!head.empty() && head.back() == ';')) return std::nullopt;

  DataUri result;
  result.media_type = std::string(head.substr(0, head.find(';')));
  std::optional<std::vector<std::byte>> bytes;
  if (coded && body.find('%') == std::string_view::npos) {
    bytes = decode_base64(body);
  } else if (const auto plain = percent_decoded(body)) {
    if (coded) {
      bytes = decode_base64(*plain);
    } else {
      bytes.emplace();
      for (char c : *plain) bytes->push_back(static_cast<std::byte>(c));
    }
  }
  if (!bytes) return std::nullopt;
  result.bytes = std::move(*bytes);
  return result;
}

std::optional<std::string> percent_decoded(std::string_view uri) {
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      result += uri[i];
      continue;
    }
    if (i + 2 >= uri.size()) return std::nullopt;
    const int high = hexadecimal(uri[i + 1]);
    const int low = hexadecimal(uri[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    result += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return result;
}

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  constexpr std::string_view plain = "-._~/";
  std::string result;
  for (char c : path) {
    if (is_letter(c) || is_digit(c) || plain.find(c) != std::string_view::npos) {
      result += c;
    } else {
      const auto value = static_cast<unsigned char>(c);
      result += '%';
      result += digits[value >> 4];
      result += digits[value & 15];
    }
  }
  return result;
}

}  // namespace foredraw::gltf
