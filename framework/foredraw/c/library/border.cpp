#include <foredraw/c/library/private/border.h>
#include <foredraw/report/diagnostics_json.h>

#include <cstdlib>
#include <cstring>

namespace foredraw::c {

void put(std::string_view text, foredraw_text* to) {
  if (to == nullptr) return;
  auto* data = static_cast<char*>(std::malloc(text.size() + 1));
  if (data == nullptr) throw std::bad_alloc();
  std::memcpy(data, text.data(), text.size());
  data[text.size()] = 0;
  *to = {data, text.size()};
}

void put(const Diagnostics& diagnostics, foredraw_text* to) {
  if (to != nullptr) put(to_json(diagnostics), to);
}

}  // namespace foredraw::c

void foredraw_text_free(foredraw_text* text) {
  if (text == nullptr) return;
  std::free(const_cast<char*>(text->data));
  *text = {nullptr, 0};
}
