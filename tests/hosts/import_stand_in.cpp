// In place of foredraw-import: what it does instead is in FOREDRAW_STAND_IN.
#include <foredraw/io/import_block.h>
#include <foredraw/platform/shared_block.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>

int main(int argc, char** argv) {
  const char* named = std::getenv("FOREDRAW_STAND_IN");
  const std::string_view what = named == nullptr ? "" : named;
  if (what == "leaves") return 3;
  if (what == "is ended") return std::raise(SIGKILL);
  if (what == "hangs") std::this_thread::sleep_for(std::chrono::hours(1));
  if (argc != 6) return 1;
  const auto shared = foredraw::SharedBlock::handed(foredraw::import_descriptor, true);
  auto& block = *reinterpret_cast<foredraw::ImportBlock*>(shared.data());
  std::string glb;
  if (what == "rubbish") glb = std::string(1000, 'x');
  if (what == "nothing") glb = "";
  if (what == "half") glb = std::string("glTF\x02\0\0\0\x40\0\0\0\x2c\0\0\0JSON{\"asset\":{\"vers", 36);
  if (what == "no end") {
    std::memset(shared.data() + foredraw::told_place, 'w', foredraw::told_room);
    block.told_bytes = ~std::uint64_t{0};
    block.last_words_bytes = ~std::uint32_t{0};
    block.glb_bytes = ~std::uint64_t{0};
    block.is_whole = 1;
    foredraw::set_and_wake(block.turn, 77);
    return 0;
  }
  if (what == "words") {
    constexpr std::string_view told = "eits words are \x1b[31mred\x07";
    std::memcpy(shared.data() + foredraw::told_place, told.data(), told.size());
    block.told_bytes = told.size() + 1;
    block.is_refused = 1;
  }
  std::memcpy(shared.data() + foredraw::glb_place, glb.data(), glb.size());
  block.glb_bytes = glb.size();
  if (what != "words") block.is_whole = 1;
  foredraw::set_and_wake(block.turn, static_cast<std::uint32_t>(foredraw::ImportTurn::ended));
  return 0;
}
