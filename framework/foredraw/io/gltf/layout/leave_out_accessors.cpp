// Accessors that nothing names any more, left out of the text: others move up.
#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/each_extension.h>

namespace foredraw::gltf {

bool holds_products(const Json& value) {
  bool found = false;
  each_extension(value, [&](const std::string& name, const Json&) { found = found || name.starts_with("FOREDRAW_"); });
  return found;
}

void leave_out_accessors(Json& json) {
  if (!json.contains("accessors") || holds_products(json)) return;
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> number(json["accessors"].size(), none);
  each_accessor_named(json, [&](const Json& named) { number[named.get<std::size_t>()] = 0; });
  Json left = Json::array();
  for (std::size_t a = 0; a < number.size(); ++a) {
    if (number[a] == none) continue;
    number[a] = left.size();
    left.push_back(std::move(json["accessors"][a]));
  }
  each_accessor_named(json, [&](Json& named) { named = number[named.get<std::size_t>()]; });
  if (left.empty()) {
    json.erase("accessors");
  } else {
    json["accessors"] = std::move(left);
  }
}

}  // namespace foredraw::gltf
