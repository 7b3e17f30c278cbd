#include <foredraw/report/diagnostics_json.h>
#include <foredraw/report/private/json_writer.h>

namespace foredraw {

std::string to_json(const Diagnostics& diagnostics) {
  return json_text([&](JsonWriter& out) {
    out.begin('{');
    write(out.key("diagnostics"), diagnostics.all());
    out.end('}');
  });
}

}  // namespace foredraw
