#include <foredraw/analysis/analyses.h>

#include <foredraw/scene/vertex_streams.h>

namespace foredraw {

std::shared_ptr<const void> Analyses::kept(const Key& key, const std::function<std::shared_ptr<const void>()>& make) {
  std::shared_ptr<Entry> entry;
  {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Entry>& slot = entries_[key];
    if (!slot) slot = std::make_shared<Entry>();
    entry = slot;
  }
  // The entry's own lock: an analysis that takes long holds up only those who want the same one.
  const std::lock_guard lock(entry->making);
  if (!entry->value) entry->value = make();
  return entry->value;
}

std::variant<Texels, std::string> Analyses::decode(const Image& image) const {
  if (!decoder_) return "this program decodes no images";
  return decoder_(image);
}

std::size_t Analyses::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

void Analyses::clear() {
  const std::lock_guard lock(mutex_);
  entries_.clear();
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
