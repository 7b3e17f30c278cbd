#include <foredraw/scene/extension_value.h>

#include <limits>

namespace foredraw {

const ExtensionValue* ExtensionValue::member(std::string_view name) const {
  if (const Members* all = members()) {
    for (const auto& [key, value] : *all) {
      if (key == name) return &value;
    }
  }
  return nullptr;
}

std::optional<double> ExtensionValue::number() const {
  if (const auto* value = std::get_if<double>(&any_)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&any_)) return static_cast<double>(*value);
  return std::nullopt;
}

std::optional<std::uint32_t> ExtensionValue::whole() const {
  const auto* value = std::get_if<std::int64_t>(&any_);
  if (value == nullptr || *value < 0 || *value > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

void ExtensionValue::put(std::string name, ExtensionValue value) {
  if (members() == nullptr) any_ = Members();
  std::get<Members>(any_).emplace_back(std::move(name), std::move(value));
}

void ExtensionValue::push(ExtensionValue value) {
  if (list() == nullptr) any_ = List();
  std::get<List>(any_).push_back(std::move(value));
}

}  // namespace foredraw
