#include "serve_import.h"

#include "import_file.h"

#include <foredraw/io/import_block.h>
#include <foredraw/platform/program_stamp.h>
#include <foredraw/platform/shared_block.h>
#include <foredraw/platform/supervised.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace foredraw::import {

namespace {

ImportBlock& block_of(const SharedBlock& shared) { return *reinterpret_cast<ImportBlock*>(shared.data()); }

/// What there is no more room for is left out.
void tell(const SharedBlock& shared, ImportTold kind, const std::string& text) {
  ImportBlock& block = block_of(shared);
  if (block.told_bytes + text.size() + 2 > told_room) return;
  std::byte* at = shared.data() + told_place + block.told_bytes;
  at[0] = static_cast<std::byte>(kind);
  std::memcpy(at + 1, text.c_str(), text.size() + 1);
  block.told_bytes += text.size() + 2;
}

void import_into(const SharedBlock& shared, const std::filesystem::path& file, const std::filesystem::path& root) {
  Told told;
  std::string why;
  try {
    const std::string glb = file.empty() ? to_text(program_stamp()) : import_file(file, root, told);
    std::memcpy(shared.data() + glb_place, glb.data(), glb.size());
    block_of(shared).glb_bytes = glb.size();
  } catch (const std::bad_alloc&) {
    tell(shared, ImportTold::no_memory, "");
    block_of(shared).is_refused = 1;
    return;
  } catch (const std::exception& error) {
    why = error.what();
  }
  if (!why.empty()) tell(shared, ImportTold::refused, why);
  for (const std::string& text : told.left_out) tell(shared, ImportTold::left_out, text);
  for (const std::string& path : told.read) tell(shared, ImportTold::read, path);
  for (const std::string& path : told.missing) tell(shared, ImportTold::missing, path);
  (why.empty() ? block_of(shared).is_whole : block_of(shared).is_refused) = 1;
}

}  // namespace

int serve_import(const std::filesystem::path& file, const std::filesystem::path& root, int parent,
                 std::uint64_t memory) {
  const SharedBlock shared = SharedBlock::handed(import_descriptor, true);
  const auto end = supervised([&] { import_into(shared, file, root); }, parent, memory, import_descriptor + 1);
  if (!end) return 0;
  ImportBlock& block = block_of(shared);
  block.by_signal = end->by_signal ? 1 : 0;
  block.code = end->code;
  block.peak_memory = end->peak_memory;
  const std::size_t bytes = std::min(end->last_words.size(), sizeof block.last_words);
  std::copy_n(end->last_words.end() - static_cast<std::ptrdiff_t>(bytes), bytes, block.last_words);
  block.last_words_bytes = static_cast<std::uint32_t>(bytes);
  set_and_wake(block.turn, static_cast<std::uint32_t>(ImportTurn::ended));
  return 0;
}

}  // namespace foredraw::import
