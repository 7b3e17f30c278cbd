#include <foredraw/cache/stored_steps.h>

#include <foredraw/cache/private/archive.h>

#include <utility>

namespace foredraw {

namespace archive {

template <class A, Is<SkipRecord> T>
void fields(A& archive, T& value) {
  auto& [code, reason, about] = value;
  archive(code, reason, about);
}

template <class A, Is<NoteRecord> T>
void fields(A& archive, T& value) {
  auto& [about, code, message] = value;
  archive(about, code, message);
}

template <class A, Is<Chart::Line> T>
void fields(A& archive, T& value) {
  auto& [name, values] = value;
  archive(name, values);
}

template <class A, Is<Chart::Mark> T>
void fields(A& archive, T& at) {
  auto& [name, value] = at;
  archive(name, value);
}

template <class A, Is<Chart> T>
void fields(A& archive, T& value) {
  auto& [name, caption, x, y, unit, lines, mark] = value;
  archive(name, caption, x, y, unit, lines, mark);
}

inline void fields(Out<>& to, const Film& film) {
  const auto& [name, caption, width, height, frames] = film;
  to(name, caption, width, height, frames.size());
}
inline void fields(In<>& from, Film& film) {
  auto& [name, caption, width, height, frames] = film;
  std::size_t count = 0;
  from(name, caption, width, height, count);
  frames.resize(count);
}

inline void fields(Out<>& to, const AttachmentRecord& attached) {
  const auto& [about, content] = attached;
  to(about, std::holds_alternative<Film>(*content));
  std::visit([&](const auto& shown) { to(shown); }, *content);
}
inline void fields(In<>& from, AttachmentRecord& attached) {
  bool is_film = false;
  from(attached.about, is_film);
  const auto take = [&](auto shown) {
    from(shown);
    attached.content = std::make_shared<const Attachment>(std::move(shown));
  };
  is_film ? take(Film()) : take(Chart());
}

template <class A, Is<StageRecord> T>
void fields(A& archive, T& value) {
  auto& [use, text, kind, seconds, rounds, memory, changed, candidates, loops_over, skipped, notes, attachments,
         attachments_before, from_cache] = value;
  archive(use, text, kind, seconds, rounds, memory, changed, candidates, loops_over, skipped, notes, attachments,
          attachments_before, from_cache);
}

template <class A, Is<About> T>
void fields(A& archive, T& value) {
  auto& [draw, subject, level] = value;
  archive(draw, subject, level);
}

template <class A, Is<Measured> T>
void fields(A& archive, T& value) {
  auto& [metric, numerator, denominator, error, about] = value;
  archive(metric, numerator, denominator, error, about);
}

template <class A, Is<Step> T>
void fields(A& archive, T& value) {
  auto& [record, measured] = value;
  archive(record, measured);
}

}  // namespace archive

std::vector<std::byte> stored_steps(const std::vector<Step>& steps) {
  archive::Out<> to;
  to(steps);
  return std::move(to.bytes());
}

std::vector<Step> restored_steps(std::span<const std::byte> bytes) {
  archive::In<> from(bytes);
  std::vector<Step> steps;
  from(steps);
  return steps;
}

}  // namespace foredraw
