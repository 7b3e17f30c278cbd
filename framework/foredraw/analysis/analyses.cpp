#include <foredraw/analysis/analyses.h>

#include <foredraw/scene/image.h>

#include <foredraw/scene/vertex_streams.h>

namespace foredraw {

std::shared_ptr<const void> Analyses::kept(std::string_view name, const Stamp& content,
                                           const std::function<Made()>& make) {
  const Stamp parts[] = {content_hash(std::span<const char>(name)), content};
  const Stamp key = combine(parts);
  std::shared_ptr<Entry> entry;
  {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Entry>& slot = entries_[key];
    if (!slot) {
      slot = std::make_shared<Entry>();
      slot->use = uses_.insert(uses_.end(), key);
    }
    uses_.splice(uses_.end(), uses_, slot->use);
    entry = slot;
  }
  // The entry's own lock: an analysis that takes long holds up only those who want the same one.
  const std::lock_guard lock(entry->making);
  if (entry->made.value) return entry->made.value;
  entry->made = make();
  std::vector<std::shared_ptr<Entry>> forgotten;  // ends after the lock on all
  const std::lock_guard lock_all(mutex_);
  const auto held = entries_.find(key);
  if (held != entries_.end() && held->second == entry) {
    bytes_ += entry->made.bytes;
    forgotten = take_what_is_too_much();
  }
  return entry->made.value;
}

/// Who has an entry may be about to take its value, and gets it under the lock that is held here: an entry and a value
/// that are here alone stay so.
std::vector<std::shared_ptr<Analyses::Entry>> Analyses::take_what_is_too_much() {
  std::vector<std::shared_ptr<Entry>> taken;
  for (auto use = uses_.begin(); bytes_ > most_bytes_ && use != uses_.end();) {
    const auto held = entries_.find(*use);
    if (held->second.use_count() > 1 || held->second->made.value.use_count() > 1) {
      ++use;
      continue;
    }
    bytes_ -= held->second->made.bytes;
    taken.push_back(std::move(held->second));
    entries_.erase(held);
    use = uses_.erase(use);
  }
  return taken;
}

std::variant<Texels, std::string> Analyses::decode(const Image& image) const {
  if (image.is_texels) return Texels{*image.facts, {image.bytes.view().begin(), image.bytes.view().end()}};
  if (!decoder_) return "this program cannot decode images";
  return decoder_(image);
}

std::size_t Analyses::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

void Analyses::clear() {
  const std::lock_guard lock(mutex_);
  entries_.clear();
  uses_.clear();
  bytes_ = 0;
}

std::shared_ptr<const Positions> positions_of(Analyses& analyses, const VertexStreams& vertices) {
  const VertexStream* stream = vertices.find("POSITION");
  if (stream == nullptr) return std::make_shared<const Positions>();
  const std::uint32_t format[] = {static_cast<std::uint32_t>(stream->format.component), stream->format.components,
                                  stream->format.normalized};
  const Stamp parts[] = {stream->bytes.stamp(), content_hash(std::span<const std::uint32_t>(format))};
  return analyses.get<Positions>(combine(parts), [&] { return Positions{decode_vec3(*stream)}; });
}

}  // namespace foredraw
