// What the checks found, how it is told, and what of it is mended.
#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/member.h>
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/text/private/json_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace foredraw::gltf {

namespace {

constexpr std::size_t most_kinds = 20;    ///< that are told
constexpr std::size_t most_kept = 10000;  ///< a file that is all mistakes must not fill the memory with them
constexpr std::string_view accessors_kind = "accessors";

/// "accessors[].count" of accessors[3].count.
std::string without_numbers(const std::string& place) {
  std::string kind;
  std::ranges::copy_if(place, std::back_inserter(kind), [](char c) { return c < '0' || c > '9'; });
  return kind;
}

/// Of mistakes with one code, in members of one name, the first is told, with the number of them.
void tell_by_kind(const std::vector<Diagnostic>& all, const char* code, const char* of, Diagnostics& diagnostics) {
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::set<std::pair<std::string, std::string>> seen;  // what two that refer to it found
  std::vector<Diagnostic> kinds;
  for (const Diagnostic& one : all) {
    if (!seen.emplace(one.where.inside, one.message).second) continue;
    const auto [kind, is_new] = known.try_emplace({one.code, without_numbers(one.where.inside)}, kinds.size());
    if (is_new) {
      kinds.push_back(one);
    } else {
      ++kinds[kind->second].places;
    }
  }
  for (std::size_t i = 0; i < std::min(kinds.size(), most_kinds); ++i) diagnostics.add(kinds[i]);
  if (kinds.size() <= most_kinds) return;
  diagnostics.note({.file = all.front().where.file}, code,
                   fmt::format("{} more kinds of {} are not shown", kinds.size() - most_kinds, of));
}

/// "materials[3].alphaMode" as /materials/3/alphaMode.
Json::json_pointer pointer_to(const std::string& place) {
  std::string pointer = "/";
  for (const char c : place) {
    if (c != ']') pointer += c == '.' || c == '[' ? '/' : c;
  }
  return Json::json_pointer(pointer);
}

/// Views that these accessors name, of JSON in which anything may be wrong.
std::set<std::size_t> views_of(const std::set<std::size_t>& accessors, const Json& all) {
  std::set<std::size_t> views;
  const auto add = [&](const Json* holder) {
    const Json* view = holder == nullptr ? nullptr : member(*holder, "bufferView");
    if (view != nullptr && view->is_number_unsigned()) views.insert(view->get<std::size_t>());
  };
  for (const std::size_t number : accessors) {
    if (number >= all.size()) continue;
    add(&all[number]);
    const Json* sparse = member(all[number], "sparse");
    if (sparse == nullptr) continue;
    add(member(*sparse, "indices"));
    add(member(*sparse, "values"));
  }
  return views;
}

}  // namespace

void Gate::error(const std::string& place, std::string code, std::string message, std::string hint) {
  if (errors_.size() == most_kept) {
    ++not_kept_;
    return;
  }
  errors_.push_back({Severity::error,
                     {.file = document_.name, .inside = place},
                     std::move(code),
                     std::move(message),
                     std::move(hint)});
}

void Gate::too_much(const std::string& place, std::string code, std::string message, std::string hint) {
  is_too_much_ = true;
  error(place, std::move(code), std::move(message), std::move(hint));
}

void Gate::warning(const std::string& place, std::string code, std::string message) {
  if (warnings_.size() == most_kept) return;
  warnings_.push_back(
      {Severity::warning, {.file = document_.name, .inside = place}, std::move(code), std::move(message), {}});
}

void Gate::error_at(std::size_t byte, std::string_view text, std::string code, std::string message, std::string hint) {
  errors_.push_back(
      {Severity::error, place_in(document_.name, text, byte), std::move(code), std::move(message), std::move(hint)});
}

void Gate::note(const std::string& place, std::string code, std::string message) {
  diagnostics_.note({.file = document_.name, .inside = place}, std::move(code), std::move(message));
}

void Gate::fault(std::string_view code, const std::string& place, std::string message) {
  faults_.found(code, {.file = document_.name, .inside = place}, std::move(message));
}

void Gate::leave_out(std::string_view code, const std::string& place, std::string message) {
  fault(code, place, std::move(message));
  left_out_.push_back(place);
}

Json& Gate::mend() {
  document_.left_out = true;
  return document_.json;
}

Json& Gate::mend_at(const std::string& place) { return mend()[pointer_to(place)]; }

std::vector<Diagnostic> Gate::take_errors(std::size_t from) {
  const auto first = errors_.begin() + static_cast<std::ptrdiff_t>(from);
  std::vector<Diagnostic> taken(std::make_move_iterator(first), std::make_move_iterator(errors_.end()));
  errors_.erase(first, errors_.end());
  return taken;
}

void Gate::hold_back(const char* kind, std::size_t number, std::size_t from) {
  HeldBack& held = held_back_[{kind, number}];
  for (Diagnostic& error : take_errors(from)) held.errors.push_back(std::move(error));
  held.is_too_much = held.is_too_much || std::exchange(is_too_much_, false);
}

bool Gate::tell_held_back(std::string_view kind, std::size_t number) {
  const auto held = held_back_.find({kind, number});
  if (held == held_back_.end()) return false;
  for (const Diagnostic& error : held->second.errors) {
    this->error(error.where.inside, error.code, error.message, error.hint);
  }
  return true;
}

void Gate::let_go_of_unused() {
  if (held_back_.empty()) return;
  const std::set<std::size_t> named = named_by_unknown_extensions(document_);
  std::set<std::size_t> ours = used_by_products(json(), document_.products);
  ours.insert(document_.let_go.begin(), document_.let_go.end());
  const std::set<std::size_t> views_of_ours = views_of(ours, all("accessors"));
  const auto is_there = [](const Buffer& buffer) { return !buffer.bytes.empty(); };
  const auto stand_in = std::ranges::find_if(document_.buffers, is_there);
  for (const auto& [element, held] : held_back_) {
    const auto& [kind, number] = element;
    const bool is_accessor = kind == accessors_kind;
    const bool is_ours = (is_accessor ? ours : views_of_ours).contains(number);
    const bool has_stand_in = is_accessor || stand_in != document_.buffers.end();
    if (named.contains(number) || !has_stand_in || (held.is_too_much && !is_ours)) {
      tell_held_back(kind, number);
      continue;
    }
    const Diagnostic& first = held.errors.front();
    if (!is_ours) fault("unused-data", first.where.inside, first.message);
    if (is_ours && is_accessor) {  // who reads the extension tells of it
      document_.broken.emplace(number, first.where.inside + ": " + first.message);
    }
    Json& json = mend()[std::string(kind)][number];
    for (const char* key :
         {"bufferView", "byteOffset", "byteStride", "sparse", "min", "max", "normalized", "extensions"})
      json.erase(key);
    if (kind == accessors_kind) {
      json.update(JsonObject{{"componentType", 5126}, {"count", 1}, {"type", "SCALAR"}});
      accessors[number] = Accessor{*format_of("SCALAR", 5126, false), 1, std::nullopt, std::nullopt};
    } else {
      const auto buffer = static_cast<std::size_t>(stand_in - document_.buffers.begin());
      json.update(JsonObject{{"buffer", buffer}, {"byteLength", 1}});
      document_.views[number] = {buffer, 0, 1, 0, stand_in->bytes.first(1), std::nullopt};
    }
  }
}

bool Gate::finish() {
  for (const std::string& place : left_out_) {
    const Json::json_pointer member = pointer_to(place);
    mend()[member.parent_pointer()].erase(member.back());
  }
  const bool mended = faults_.tell();
  tell_by_kind(errors_, "more-mistakes", "errors", diagnostics_);
  if (not_kept_ > 0)
    diagnostics_.note({.file = document_.name}, "more-mistakes",
                      fmt::format("{} more errors are not shown", not_kept_));
  tell_by_kind(warnings_, "more-warnings", "warnings", diagnostics_);
  return mended && sound();
}

}  // namespace foredraw::gltf
