// Where the extension of a product stands in a document, which accessors it names, and how it is taken out.
#include <foredraw/io/gltf/private/member.h>
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/reading/faults.h>

namespace foredraw::gltf {

namespace {

/// Adds the numbers at a path of members, "*" for each element or member, whatever else is wrong.
void collect(const Json& json, std::string_view path, std::set<std::size_t>& numbers) {
  if (path.empty()) {
    if (json.is_number_unsigned()) numbers.insert(json.get<std::size_t>());
    return;
  }
  const std::size_t end = std::min(path.find('/'), path.size());
  const std::string_view rest = path.substr(std::min(end + 1, path.size()));
  if (path.substr(0, end) != "*") {
    const Json* next = member(json, std::string(path.substr(0, end)).c_str());
    if (next != nullptr) collect(*next, rest, numbers);
  } else if (json.is_structured()) {
    for (const Json& next : json) collect(next, rest, numbers);
  }
}

}  // namespace

std::set<std::size_t> used_by_product(const Json& json, const ProductCard& card) {
  std::set<std::size_t> numbers;
  const auto add = [&](const Json& holder, const std::vector<std::string>& paths) {
    const Json* extension = extension_of(holder, card.extension);
    if (extension == nullptr) return;
    for (const std::string& path : paths) collect(*extension, path, numbers);
  };
  add(json, card.accessors_of_file);
  if (card.accessors_of_draw.empty()) return numbers;
  each_primitive(json, [&](const Json& primitive) { add(primitive, card.accessors_of_draw); });
  return numbers;
}

std::set<std::size_t> used_by_products(const Json& json, const ProductRows& rows) {
  std::set<std::size_t> numbers;
  for (const auto& row : rows) numbers.merge(used_by_product(json, row->card()));
  return numbers;
}

void take_out(Document& document, const ProductCard& card) {
  document.let_go.merge(used_by_product(document.json, card));
  take_extension_everywhere(document.json, card.extension);
  unlist_extension(document.json, card.extension);
  document.left_out = true;
}

void tell_taken_out(const std::string& file, const ProductCard& card, const std::string& why, bool strict,
                    Diagnostics& diagnostics) {
  const std::string done = strict ? "without --strict: " + std::string(fault_kind("NAME-left-out").done) + " Or " : "";
  diagnostics.add({strict ? Severity::error : Severity::warning,
                   {.file = file, .inside = card.extension},
                   card.name + "-left-out",
                   (strict ? "cannot be used for the " : "is left out, and with it the ") + card.title + ": " + why,
                   done + card.remedy});
}

}  // namespace foredraw::gltf
