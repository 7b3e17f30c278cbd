#include <foredraw/io/mesh/private/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::mesh_files {

std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return lower;
}

namespace {

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    const int more = lead < 0x80 ? 0 : lead < 0xC2 ? -1 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : lead < 0xF5 ? 3 : -1;
    if (more < 0 || text.size() - i < static_cast<std::size_t>(more)) return false;
    std::uint32_t code = more == 0 ? lead : lead & (0x3Fu >> more);
    for (int k = 0; k < more; ++k) {
      const auto next = static_cast<unsigned char>(text[i++]);
      if ((next & 0xC0) != 0x80) return false;
      code = code << 6 | (next & 0x3F);
    }
    const bool is_long = (more == 2 && code < 0x800) || (more == 3 && code < 0x10000);
    if (is_long || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return false;
  }
  return true;
}

}  // namespace

std::string name_in(std::string_view text) {
  text = trimmed(text);
  if (is_utf8(text)) return std::string(text);
  std::string name;
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) name += static_cast<char>(0xC0 | byte >> 6);
    name += byte < 0x80 ? c : static_cast<char>(0x80 | (byte & 0x3F));
  }
  return name;
}

std::string_view take_token(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_space(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_space(text[end])) ++end;
  const std::string_view token = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return token;
}

std::string_view take_line(std::string_view& text, char line_end) {
  const std::size_t end = std::min(text.find(line_end), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view read_float(std::string_view token, float& value) {
  if (token.size() > 1 && token.front() == '+' && token[1] != '-') token.remove_prefix(1);
  if (token.starts_with("1.#") || token.starts_with("-1.#")) {
    value = std::numeric_limits<float>::quiet_NaN();
    return "is not finite";
  }
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error == std::errc::invalid_argument) return "is not a number";
  if (error == std::errc::result_out_of_range) {
    // Too near to zero and too far from it are one error. A double tells them apart; what leaves its range too has an
    // exponent, or so many digits that nobody meant a number.
    double wide = 0;
    const bool fits = std::from_chars(token.data(), token.data() + token.size(), wide).ec == std::errc();
    const bool is_small = fits ? std::abs(wide) < 1 : token.find("e-") != token.npos || token.find("E-") != token.npos;
    if (!is_small) {
      value = std::numeric_limits<float>::infinity();
      return "does not fit into a 32-bit float";
    }
    value = token.front() == '-' ? -0.0f : 0.0f;
  }
  return std::isfinite(value) ? "" : "is not finite";
}

std::string shown(std::string_view token) {
  std::string text = "'";
  for (char c : token.substr(0, 32)) text += c >= ' ' && c < 127 ? c : '?';
  return text + (token.size() > 32 ? "...'" : "'");
}

Where Reading::at(std::string_view part) const {
  const auto offset = static_cast<std::size_t>(part.data() - text.data());
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return {
      .file = name,
      .line =
          static_cast<int>(std::min<std::ptrdiff_t>(std::count(before.begin(), before.end(), '\n'), 2'000'000'000)) + 1,
      .column = static_cast<int>(std::min<std::size_t>(offset - line_begin, 2'000'000'000)) + 1};
}

Where Reading::at_byte(std::size_t offset) const { return {.file = name, .inside = fmt::format("byte {}", offset)}; }

bool Reading::refuse(Where where, std::string message, std::string hint) const {
  diagnostics.error(std::move(where), "bad-mesh", std::move(message), std::move(hint));
  return false;
}

bool Reading::read(std::string_view token, float& value) const {
  const std::string_view why_not = read_float(token, value);
  if (why_not.empty()) return true;
  if (token.empty()) return refuse(at(token), "a number is missing here");
  return refuse(at(token), fmt::format("{} {}", shown(token), why_not));
}

bool Reading::read_attribute(std::string_view token, float& value) const {
  value = 0;
  const std::string_view why_not = read_float(token, value);
  if (why_not.empty()) return true;
  if (std::isfinite(value)) return read(token, value);  // which refuses
  fault("not-finite", token, fmt::format("{} {}", shown(token), why_not));
  value = 0;
  return true;
}

void Reading::fault(std::string_view code, std::string_view part, std::string message) const {
  if (faults == nullptr || faults->found_again(code)) return;
  faults->found(code, at(part), std::move(message));
}

void Reading::fault_at_byte(std::string_view code, std::size_t offset, std::string message) const {
  if (faults == nullptr || faults->found_again(code)) return;
  faults->found(code, at_byte(offset), std::move(message));
}

}  // namespace foredraw::mesh_files
