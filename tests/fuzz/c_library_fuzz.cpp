// Draws of odd numbers and a pipeline of any text through the library for C: it ends well, says what was wrong in JSON,
// and what it made can be looked at. The text is what is left behind the draws' bytes.

#include "claim.h"
#include "odd_input.h"

#include <foredraw/c/foredraw.h>
#include <foredraw/c/functions.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace foredraw {
namespace {

using testing::OddInput;

/// Arrays of a draw, and the struct that points to them, which may say other things than are true as far as C lets one.
struct OddDraw {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint8_t> bytes;
  std::vector<foredraw_stream> streams;
  foredraw_draw draw{};

  explicit OddDraw(OddInput& input) {
    constexpr std::array semantics = {"NORMAL",   "TEXCOORD_0", "TANGENT", "COLOR_0",
                                      "JOINTS_0", "WEIGHTS_0",  "_MINE",   ""};
    const std::size_t vertices = input.below(24);
    for (std::size_t i = 0; i < 3 * vertices; ++i) positions.push_back(input.number());
    indices = testing::odd_indices(input, std::max<std::size_t>(vertices, 1), 3 * input.below(20));
    if (input.below(8) == 0 && !indices.empty()) indices[input.below(indices.size())] = 0xffffffff;
    bytes.resize(24 * 16 * sizeof(float) + 16);
    for (std::uint8_t& byte : bytes) byte = input.left() > 200 ? input.byte() : 1;
    for (std::size_t i = input.below(4); i > 0; --i) {
      foredraw_stream stream{};
      stream.semantic = input.below(16) == 0 ? nullptr : semantics[input.below(semantics.size())];
      stream.bytes = input.below(16) == 0 ? nullptr : bytes.data();
      stream.component = static_cast<std::uint32_t>(input.below(9));
      stream.components = static_cast<std::uint32_t>(input.below(18));
      stream.stride = static_cast<std::uint32_t>(input.below(2) * input.below(64));
      stream.normalized = static_cast<std::uint32_t>(input.below(3));
      streams.push_back(stream);
    }
    draw.size = input.below(32) == 0 ? input.byte() : sizeof draw;
    draw.vertex_count = static_cast<std::uint32_t>(vertices);
    draw.triangle_count = input.below(32) == 0 ? ~std::uint64_t{0} : indices.size() / 3;
    draw.name = input.below(4) == 0 ? nullptr : "draw";
    draw.indices = input.below(32) == 0 ? nullptr : indices.data();
    draw.positions = input.below(32) == 0 ? nullptr : positions.data();
    draw.stream_count = static_cast<std::uint32_t>(streams.size());
    draw.streams = streams.data();
    draw.cluster_count = static_cast<std::uint32_t>(input.below(32) == 0);
  }
};

class Text {
 public:
  ~Text() { foredraw_text_free(&text_); }
  foredraw_text* out() {
    foredraw_text_free(&text_);
    return &text_;
  }
  void claim_is_json(int status) const {
    claim(text_.data == nullptr || nlohmann::json::accept(std::string_view(text_.data, text_.length)), "no JSON");
    claim(status != FOREDRAW_MISTAKE || text_.data != nullptr, "a mistake of which nothing is said");
  }

 private:
  foredraw_text text_{};
};

/// Pictures of millions of pixels and thousands of views are only slow.
bool is_modest(std::string_view text) {
  std::size_t digits = 0;
  for (const char c : text) {
    digits = std::isdigit(static_cast<unsigned char>(c)) ? digits + 1 : 0;
    if (digits > 2) return false;
  }
  return text.find("e+") == std::string_view::npos;
}

void look_at(const foredraw_scene* scene) {
  for (std::uint64_t i = 0; i < foredraw_scene_draws(scene); ++i) {
    foredraw_draw draw{};
    draw.size = sizeof draw;
    if (foredraw_scene_draw(scene, i, &draw) != FOREDRAW_DONE) continue;
    for (std::uint64_t k = 0; k < 3 * draw.triangle_count; ++k) claim(draw.indices[k] < draw.vertex_count, "an index");
    const std::uint32_t *triangles = nullptr, *vertices = nullptr;
    claim(foredraw_scene_moves(scene, i, &triangles, &vertices, nullptr) == FOREDRAW_DONE, "moves");
  }
}

}  // namespace
}  // namespace foredraw

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  static foredraw_context* const context = foredraw_context_new(nullptr);
  OddInput input(data, size);
  const OddDraw one(input), other(input);
  const foredraw_draw draws[] = {one.draw, other.draw};
  std::string pipeline;
  while (input.left() > 0) pipeline += static_cast<char>(input.byte());
  if (!is_modest(pipeline)) return 0;

  Text text;
  foredraw_scene *scene = nullptr, *made = nullptr;
  int status = foredraw_make_scene(context, draws, 2, &scene, text.out());
  text.claim_is_json(status);
  claim((scene != nullptr) == (status == FOREDRAW_DONE), "a scene where there is none, or none");
  if (scene != nullptr) {
    status = foredraw_optimize(context, scene, pipeline.c_str(), &made, text.out());
    text.claim_is_json(status);
    claim((made != nullptr) == (status == FOREDRAW_DONE || status == FOREDRAW_FAILED), "a result");
    if (made != nullptr) look_at(made);
    foredraw_scene_free(made);
    foredraw_scene_free(scene);
  }
  const foredraw_triangles triangles{one.indices.data(), one.indices.size(), 4, one.draw.vertex_count};
  const foredraw_positions positions{one.positions.data(), 0};
  std::vector<std::uint32_t> order(64);
  status = foredraw_order(context, pipeline.c_str(), &triangles, &positions, order.data(), text.out());
  text.claim_is_json(status);
  return 0;
}
