#include <foredraw/base/diagnostics.h>
#include <foredraw/base/printable.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

void Diagnostics::add(Diagnostic diagnostic) { all_.push_back(std::move(diagnostic)); }

void Diagnostics::error(Where where, std::string code, std::string message, std::string hint) {
  add({Severity::error, std::move(where), std::move(code), std::move(message), std::move(hint)});
}

void Diagnostics::warning(Where where, std::string code, std::string message, std::string hint) {
  add({Severity::warning, std::move(where), std::move(code), std::move(message), std::move(hint)});
}

void Diagnostics::note(Where where, std::string code, std::string message, std::string hint) {
  add({Severity::note, std::move(where), std::move(code), std::move(message), std::move(hint)});
}

bool Diagnostics::has_errors() const {
  return std::any_of(all_.begin(), all_.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string_view to_text(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
  }
  return "error";
}

std::string to_text(const Diagnostic& diagnostic) {
  std::string text = printable(diagnostic.where.file);
  if (diagnostic.where.line > 0) {
    text += ':' + std::to_string(diagnostic.where.line) + ':' + std::to_string(diagnostic.where.column);
  }
  if (!text.empty()) text += ": ";
  text += std::string(to_text(diagnostic.severity)) + ": ";
  if (!diagnostic.where.inside.empty()) text += printable(diagnostic.where.inside) + ": ";
  text += printable(diagnostic.message, "\n");
  if (diagnostic.places > 1) text += " (and " + std::to_string(diagnostic.places - 1) + " more like it)";
  if (!diagnostic.hint.empty()) text += "\n    hint: " + diagnostic.hint;
  return text;
}

std::string to_text(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += to_text(diagnostic) + '\n';
  return text;
}

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// "cache" for "cache-size" is near although many letters are missing.
bool is_part_of(std::string_view word, std::string_view candidate) {
  return word.size() >= 3 && candidate.find(word) != std::string_view::npos;
}

}  // namespace

std::string_view nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string_view best;
  std::size_t best_distance = word.size() / 3 + 2;
  for (const std::string& candidate : candidates) {
    std::size_t distance = edit_distance(word, candidate);
    if (is_part_of(word, candidate)) distance = std::min<std::size_t>(distance, 1);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace foredraw
