#pragma once
// Handles and texts of the library for C, freed at the end of their scope.

#include <foredraw/c/foredraw.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace foredraw::testing {

using Json = nlohmann::json;

struct Free {
  void operator()(foredraw_context* context) const { foredraw_context_free(context); }
  void operator()(foredraw_scene* scene) const { foredraw_scene_free(scene); }
};
using Context = std::unique_ptr<foredraw_context, Free>;
using SceneHandle = std::unique_ptr<foredraw_scene, Free>;

/// A text that came out.
class Told {
 public:
  ~Told() { foredraw_text_free(&text_); }
  foredraw_text* out() { return &text_; }
  std::string text() const { return text_.data == nullptr ? std::string() : std::string(text_.data, text_.length); }
  Json json() const { return Json::parse(text()); }

 private:
  foredraw_text text_{};
};

}  // namespace foredraw::testing
