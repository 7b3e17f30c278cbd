#include <foredraw/io/text/extension_text.h>
#include <foredraw/io/text/private/extension_json.h>

#include <limits>

namespace foredraw {

ExtensionValue value_of(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean: return json.get<bool>();
    case Json::value_t::number_integer: return json.get<std::int64_t>();
    case Json::value_t::number_unsigned:
      if (json.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) break;
      return json.get<std::int64_t>();
    case Json::value_t::string: return json.get<std::string>();
    case Json::value_t::array: return listed(json, value_of);
    case Json::value_t::object: {
      ExtensionValue::Members members;
      for (const auto& [name, value] : json.items()) members.emplace_back(name, value_of(value));
      return members;
    }
    case Json::value_t::null:
    case Json::value_t::discarded:
    case Json::value_t::binary: return {};
    case Json::value_t::number_float: break;
  }
  return json.get<double>();
}

Json json_of(const ExtensionValue& value) {
  struct Made {
    Json operator()(std::monostate) const { return nullptr; }
    Json operator()(bool value) const { return value; }
    Json operator()(std::int64_t value) const {
      return value < 0 ? Json(value) : Json(static_cast<std::uint64_t>(value));  // as a parser has it
    }
    Json operator()(double value) const { return value; }
    Json operator()(const std::string& text) const { return text; }
    Json operator()(const ExtensionValue::List& list) const {
      Json json = Json::array();
      for (const ExtensionValue& value : list) json.push_back(json_of(value));
      return json;
    }
    Json operator()(const ExtensionValue::Members& members) const {
      Json json = Json::object();
      for (const auto& [name, value] : members) json[name] = json_of(value);
      return json;
    }
    Json operator()(AccessorRef accessor) const { return accessor.number; }
  };
  return std::visit(Made(), value.any());
}

std::string json_text(const ExtensionValue& value, int indent) {
  return json_of(value).dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace foredraw
