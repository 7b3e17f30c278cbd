#pragma once
// Values as bytes, for entries that the same build reads again: no form for anybody else. What a struct holds is listed
// once, in its fields(), for both directions; a structured binding there counts the members, so that one that is added
// and not listed does not compile.

#include <foredraw/base/content_hash.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace foredraw::archive {

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

/// Whose bytes are its value: no handles, no gaps.
template <class T>
inline constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <>
inline constexpr bool is_plain<std::byte> = true;
template <>
inline constexpr bool is_plain<Stamp> = true;
template <glm::length_t n, class T, glm::qualifier q>
inline constexpr bool is_plain<glm::vec<n, T, q>> = true;
template <glm::length_t n, glm::length_t m, class T, glm::qualifier q>
inline constexpr bool is_plain<glm::mat<n, m, T, q>> = true;
template <class T, glm::qualifier q>
inline constexpr bool is_plain<glm::qua<T, q>> = true;
template <class T, std::size_t n>
inline constexpr bool is_plain<std::array<T, n>> = is_plain<T>;

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_span = false;
template <class T>
inline constexpr bool is_span<std::span<const T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

struct NoHandles {};

/// Puts values behind each other; a span as a vector. `Handles`: what the fields() of handles that are shared look them
/// up in.
template <class Handles = NoHandles>
class Out {
 public:
  explicit Out(Handles handles = {}) : handles(handles) {}

  Handles handles;

  template <class... Ts>
  void operator()(const Ts&... values) {
    (put(values), ...);
  }

  std::vector<std::byte>& bytes() { return bytes_; }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (is_plain<T>) {
      raw(&value, sizeof(T));
    } else if constexpr (std::is_same_v<T, std::string>) {
      put(value.size());
      raw(value.data(), value.size());
    } else if constexpr (is_optional<T>) {
      put(value.has_value());
      if (value) put(*value);
    } else if constexpr (is_vector<T> || is_span<T>) {
      put(value.size());
      if constexpr (is_plain<typename T::value_type>) {
        raw(value.data(), value.size() * sizeof(typename T::value_type));
      } else {
        for (const auto& one : value) put(one);
      }
    } else {
      fields(*this, value);
    }
  }

  void raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }

  std::vector<std::byte> bytes_;
};

/// Takes them again. Throws std::runtime_error where the bytes end too early.
template <class Handles = NoHandles>
class In {
 public:
  explicit In(std::span<const std::byte> bytes, Handles handles = {}) : handles(handles), bytes_(bytes) {}

  Handles handles;

  template <class... Ts>
  void operator()(Ts&... values) {
    (take(values), ...);
  }

  bool is_at_end() const { return bytes_.empty(); }

 private:
  template <class T>
  void take(T& value) {
    if constexpr (is_plain<T>) {
      raw(&value, sizeof(T));
    } else if constexpr (std::is_same_v<T, std::string>) {
      value.resize(count(1));
      raw(value.data(), value.size());
    } else if constexpr (is_optional<T>) {
      bool has_value = false;
      take(has_value);
      value.reset();
      if (!has_value) return;
      typename T::value_type held{};
      take(held);
      value = std::move(held);
    } else if constexpr (is_vector<T>) {
      using Element = typename T::value_type;
      if constexpr (is_plain<Element>) {
        value.resize(count(sizeof(Element)));
        raw(value.data(), value.size() * sizeof(Element));
      } else {
        value.clear();
        for (std::size_t i = count(1); i > 0; --i) take(value.emplace_back());
      }
    } else {
      fields(*this, value);
    }
  }

  /// Of elements of so many bytes at least.
  std::size_t count(std::size_t bytes) {
    std::size_t count = 0;
    take(count);
    if (count > bytes_.size() / bytes) throw std::runtime_error("the bytes end too early");
    return count;
  }

  void raw(void* data, std::size_t size) {
    if (size > bytes_.size()) throw std::runtime_error("the bytes end too early");
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }

  std::span<const std::byte> bytes_;
};

}  // namespace foredraw::archive
