#include <foredraw/modules/blocks.h>
#include <foredraw/modules/serve.h>
#include <foredraw/platform/shared_block.h>
#include <foredraw/platform/supervised.h>

#include <algorithm>
#include <cstdlib>

namespace foredraw {

namespace {

void serve_python(const std::filesystem::path& file) {
  const char* named = std::getenv("FOREDRAW_PYTHON");
  const std::string python = named == nullptr || *named == '\0' ? "python3" : named;
  become(python, {"-m", "foredraw.worker", file.string()});
  serve_refusal("there is no program " + python + "; FOREDRAW_PYTHON may name one");
}

}  // namespace

int serve_watched(const std::filesystem::path& module, int parent, std::uint64_t memory) {
  const auto work = [&] { module.extension() == ".py" ? serve_python(module) : serve_file(module); };
  const auto end = supervised(work, parent, memory, answered_descriptor + 1);
  if (!end) return 0;
  const SharedBlock block = SharedBlock::handed(answered_descriptor, true);
  AnsweredCall& answer = *reinterpret_cast<AnsweredCall*>(block.data());
  answer.by_signal = end->by_signal ? 1 : 0;
  answer.code = end->code;
  answer.peak_memory = end->peak_memory;
  const std::size_t bytes = std::min(end->last_words.size(), sizeof answer.last_words);
  std::copy_n(end->last_words.end() - static_cast<std::ptrdiff_t>(bytes), bytes, answer.last_words);
  answer.last_words_bytes = static_cast<std::uint32_t>(bytes);
  set_and_wake(answer.turn, static_cast<std::uint32_t>(BlockTurn::ended));
  return 0;
}

}  // namespace foredraw
