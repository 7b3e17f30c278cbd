// Buffer views and the buffer made anew after changes.
#include <foredraw/io/private/gltf_layout.h>

#include <algorithm>
#include <iterator>

namespace foredraw::gltf {

namespace {

/// Blocks that go into one view.
struct NewView {
  std::vector<Block> blocks;
  std::size_t stride = 0;
  std::optional<std::size_t> number;
  bool is_old = false;  ///< carries on the view that had its number
  bool untouched = false;

  std::optional<Content::Kind> kind() const {
    const auto told =
        std::find_if(blocks.begin(), blocks.end(), [](const Block& block) { return block.kind.has_value(); });
    return told == blocks.end() ? std::nullopt : told->kind;
  }
};

class Relayout {
 public:
  Relayout(const Document& document, Json& json, const Changes& changes)
      : document_(document), json_(json), changes_(changes), users_(document.views.size()) {
    // With an extension that we do not know, which may point anywhere, everything that was there stays where it was.
    const std::vector<std::string> extensions = extensions_in(document.json);
    keep_ = !std::all_of(extensions.begin(), extensions.end(), [](const auto& e) { return is_known_extension(e); });
  }

  std::vector<std::byte> run() {
    find_users();
    for (std::size_t v = 0; v < users_.size(); ++v) make_views(v);
    make_new_views();
    number_views();
    write_views();
    return std::move(buffer_);
  }

 private:
  Json& item(const char* kind, std::size_t i) { return json_[kind][i]; }
  std::size_t count(const char* kind) const { return json_.contains(kind) ? json_[kind].size() : 0; }

  void find_users() {
    for (std::size_t a = 0; a < count("accessors"); ++a) {
      const auto found = changes_.contents.find(a);
      const Content* content = found == changes_.contents.end() ? nullptr : &found->second;
      const bool is_new = a >= document_.accessors.size();
      if (!is_new) find_users_of(a, content);
      if (content != nullptr && (is_new || !document_.accessors[a].rows)) {
        new_blocks_.push_back(block_of({&item("accessors", a)}, *content, 1));
      }
    }
    for (std::size_t i = 0; i < count("images"); ++i) {
      const auto found = changes_.images.find(i);
      const Shared<std::byte>* raw = found == changes_.images.end() ? nullptr : &found->second;
      Json& image = item("images", i);
      const bool had_view = image.contains("bufferView");
      if (had_view) {
        const auto view = image["bufferView"].get<std::size_t>();
        users_[view].push_back({{&image}, 0, document_.views[view].length, 0, 0, 0, nullptr, raw, false});
      } else if (raw != nullptr) {
        image["bufferView"] = 0;
        new_blocks_.push_back(
            {{raw->view().begin(), raw->view().end()}, {{{&image}, 0}}, 0, Content::Kind::other, true});
      }
    }
  }

  void find_users_of(std::size_t a, const Content* content) {
    const Accessor& was = document_.accessors[a];
    const bool released = changes_.released.contains(a);
    Json* holder = &item("accessors", a);
    if (was.rows) {
      const std::size_t end = was.rows->offset + (was.count - 1) * was.rows->stride + was.format.bytes;
      users_[was.rows->view].push_back(
          {{holder}, was.rows->offset, end, was.rows->stride, was.count, was.format.bytes, content, nullptr, released});
    }
    if (!was.sparse) return;
    const bool dropped = released || content != nullptr;
    const auto part = [&](const Rows& rows, const char* key, std::size_t bytes) {
      users_[rows.view].push_back(
          {{holder, key}, rows.offset, rows.offset + was.sparse->count * bytes, 0, 0, 0, nullptr, nullptr, dropped});
    };
    part(was.sparse->indices, "indices", foredraw::bytes_of(was.sparse->index));
    part(was.sparse->values, "values", was.format.bytes);
  }

  void make_views(std::size_t v) {
    const BufferView& view = document_.views[v];
    const Bytes bytes = bytes_of(document_, view);
    const bool dirty = std::any_of(users_[v].begin(), users_[v].end(), [](const auto& user) { return user.changes(); });
    if (!keep_ && users_[v].empty() && changes_.forgotten.contains(v)) return;
    if (keep_ || !dirty) {
      Block whole;
      whole.bytes.assign(bytes.begin(), bytes.end());
      for (const ViewUser& user : users_[v]) {
        if (!user.changes()) whole.places.push_back({user.holder, user.offset});
      }
      views_.push_back({{std::move(whole)}, view.stride, v, true, true});
    }
    if (!dirty) return;
    std::vector<NewView> made;
    for (Block& block : blocks_of(std::move(users_[v]), bytes, view.stride, keep_)) {
      place(std::move(block), made,
            [](const NewView& old, const Block& one) { return !one.alone && !old.blocks.front().alone; });
    }
    if (!keep_ && !made.empty()) {
      // The number goes to the view that is most like the old one.
      const auto alike = std::find_if(made.begin(), made.end(), [&](const auto& m) { return m.stride == view.stride; });
      NewView& heir = alike == made.end() ? made.front() : *alike;
      heir.number = v;
      heir.is_old = true;
    }
    std::move(made.begin(), made.end(), std::back_inserter(views_));
  }

  void make_new_views() {
    std::vector<NewView> made;
    for (Block& block : new_blocks_) {
      place(std::move(block), made, [](const NewView& view, const Block& one) {
        return !one.alone && !view.blocks.front().alone && view.kind() == one.kind;
      });
    }
    std::move(made.begin(), made.end(), std::back_inserter(views_));
  }

  template <class Fits>
  static void place(Block block, std::vector<NewView>& views, Fits fits) {
    const auto found = std::find_if(views.begin(), views.end(), [&](const NewView& view) {
      return view.stride == block.stride && fits(view, block);
    });
    if (found != views.end()) {
      found->blocks.push_back(std::move(block));
    } else {
      const std::size_t stride = block.stride;
      views.push_back({{}, stride, std::nullopt, false, false});
      views.back().blocks.push_back(std::move(block));
    }
  }

  /// Views that fell away leave their numbers to new ones; what is still free then closes up.
  void number_views() {
    std::vector<bool> taken(document_.views.size(), false);
    for (const NewView& view : views_) {
      if (view.number) taken[*view.number] = true;
    }
    std::size_t next = 0;
    for (NewView& view : views_) {
      if (view.number) continue;
      while (next < taken.size() && taken[next]) ++next;
      view.number = next++;
    }
    std::sort(views_.begin(), views_.end(), [](const NewView& a, const NewView& b) { return *a.number < *b.number; });
  }

  void write_views() {
    std::vector<std::size_t> buffer_at;  // where the old buffers stay whole
    for (const Bytes& buffer : document_.buffers) {
      if (!keep_) break;
      align(8);
      buffer_at.push_back(buffer_.size());
      buffer_.insert(buffer_.end(), buffer.begin(), buffer.end());
    }
    Json made = Json::array();
    for (const NewView& view : views_) {
      const BufferView* was = view.is_old ? &document_.views[*view.number] : nullptr;
      Json json = was != nullptr ? json_["bufferViews"][*view.number] : Json{{"buffer", 0}};
      std::size_t start, length;
      if (keep_ && view.untouched) {
        start = buffer_at[was->buffer] + was->offset;
        length = was->length;
        for (const Block::Place& place : view.blocks.front().places)
          refer(place.holder.json(), made.size(), place.offset);
      } else {
        align(was != nullptr && was->offset % 8 == 0 ? 8 : 4);
        start = buffer_.size();
        for (const Block& block : view.blocks) append(block, made.size(), start);
        length = buffer_.size() - start;
      }
      json["buffer"] = 0;
      if (start != 0 || json.contains("byteOffset")) json["byteOffset"] = start;
      json["byteLength"] = length;
      if (view.stride != 0) {
        json["byteStride"] = view.stride;
      } else {
        json.erase("byteStride");
      }
      if (was == nullptr && view.kind() == Content::Kind::vertices) json["target"] = 34962;
      if (was == nullptr && view.kind() == Content::Kind::indices) json["target"] = 34963;
      made.push_back(std::move(json));
    }
    align(4);
    json_["bufferViews"] = std::move(made);
    if (json_["bufferViews"].empty()) json_.erase("bufferViews");
  }

  void append(const Block& block, std::size_t view, std::size_t start) {
    align(4);
    for (const Block::Place& place : block.places)
      refer(place.holder.json(), view, buffer_.size() - start + place.offset);
    buffer_.insert(buffer_.end(), block.bytes.begin(), block.bytes.end());
  }

  /// An accessor, a sparse part or an image now lies there. Images take the whole view and have no offset.
  static void refer(Json& holder, std::size_t view, std::size_t offset) {
    holder["bufferView"] = view;
    if (offset != 0 || holder.contains("byteOffset")) holder["byteOffset"] = offset;
  }

  void align(std::size_t to) { buffer_.resize((buffer_.size() + to - 1) / to * to); }

  const Document& document_;
  Json& json_;
  const Changes& changes_;
  bool keep_ = false;
  std::vector<std::vector<ViewUser>> users_;
  std::vector<Block> new_blocks_;
  std::vector<NewView> views_;
  std::vector<std::byte> buffer_;
};

}  // namespace

std::vector<std::byte> laid_out(const Document& document, Json& json, const Changes& changes) {
  return Relayout(document, json, changes).run();
}

}  // namespace foredraw::gltf
