// Which buffer views there are after changes, and what lies in them.
#include <foredraw/io/gltf/layout/private/layout.h>

#include <algorithm>
#include <iterator>

namespace foredraw::gltf {

namespace {

class Relayout {
 public:
  Relayout(const Document& document, Json& json, const Changes& changes, bool compress)
      : document_(document), json_(json), changes_(changes), compress_(compress), users_(document.views.size()) {
    // With an extension that we do not know, which may point anywhere, everything that was there stays where it was.
    keep_ = !document.knows_all_extensions();
  }

  LaidOut run() {
    find_users();
    for (std::size_t v = 0; v < users_.size(); ++v) make_views(v);
    make_new_views();
    number_views();
    return placed(document_, json_, views_, keep_, compress_);
  }

 private:
  Json& item(const char* kind, std::size_t i) { return json_[kind][i]; }
  std::size_t count(const char* kind) const { return json_.contains(kind) ? json_[kind].size() : 0; }

  void find_users() {
    for (std::size_t a = 0; a < count("accessors"); ++a) {
      const auto found = changes_.contents.find(a);
      const bool is_part = changes_.parts.contains(a);
      const Content* content = found == changes_.contents.end() || is_part ? nullptr : &found->second;
      const bool is_new = a >= document_.accessors.size();
      if (!is_new) find_users_of(a, content);
      if (content != nullptr && (is_new || !document_.accessors[a].rows)) {
        new_blocks_.push_back(block_of({&item("accessors", a)}, *content, 1));
        for (const auto& [part, lies] : changes_.parts) {
          if (lies.of == a)
            new_blocks_.back().places.push_back({{&item("accessors", part)}, lies.first * new_blocks_.back().row});
        }
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
            {{raw->view().begin(), raw->view().end()}, {{{&image}, 0}}, 0, 0, Content::Kind::other, true});
      }
    }
  }

  void find_users_of(std::size_t a, const Content* content) {
    const Accessor& was = document_.accessors[a];
    const bool released = changes_.released.contains(a) || changes_.parts.contains(a);
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
    const bool dirty = std::any_of(users_[v].begin(), users_[v].end(), [](const auto& user) { return user.changes(); });
    if (!keep_ && users_[v].empty() && changes_.forgotten.contains(v)) return;
    if (keep_ || !dirty) {
      Block whole;
      for (const ViewUser& user : users_[v]) {
        if (!user.changes()) whole.places.push_back({user.holder, user.offset});
      }
      views_.push_back({{std::move(whole)}, view.stride, v, true, true, like(v)});
    }
    if (!dirty) return;
    std::vector<NewView> made;
    for (Block& block : blocks_of(std::move(users_[v]), view.bytes, view.stride, keep_)) {
      place(std::move(block), made, like(v),
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
    const auto like_indices = like_kind(true), like_others = like_kind(false);
    for (Block& block : new_blocks_) {
      const auto like = block.kind == Content::Kind::indices ? like_indices : like_others;
      place(std::move(block), made, like, [](const NewView& view, const Block& one) {
        return !one.alone && !view.blocks.front().alone && view.kind() == one.kind;
      });
    }
    std::move(made.begin(), made.end(), std::back_inserter(views_));
  }

  /// The old view itself where it is compressed, and stays so.
  std::optional<std::size_t> like(std::size_t v) const {
    return compress_ && document_.views[v].compressed ? std::optional(v) : std::nullopt;
  }

  /// The first compressed view that what is new can follow, indices or not.
  std::optional<std::size_t> like_kind(bool of_indices) const {
    for (std::size_t v = 0; v < document_.views.size(); ++v) {
      if (!like(v)) continue;
      const Coding::Mode mode = document_.views[v].compressed->coding.mode;
      const bool indices = mode == Coding::Mode::triangles || mode == Coding::Mode::indices;
      if (mode != Coding::Mode::unknown && indices == of_indices) return v;
    }
    return std::nullopt;
  }

  /// Into a view of the same stride. Those of a compressed view hold elements of one size, too.
  template <class Fits>
  static void place(Block block, std::vector<NewView>& views, std::optional<std::size_t> like, Fits fits) {
    if (block.alone) like.reset();
    const auto found = std::find_if(views.begin(), views.end(), [&](const NewView& view) {
      return view.stride == block.stride && (!like || view.blocks.front().row == block.row) && fits(view, block);
    });
    if (found != views.end()) {
      found->blocks.push_back(std::move(block));
    } else {
      const std::size_t stride = block.stride;
      views.push_back({{}, stride, std::nullopt, false, false, like});
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

  const Document& document_;
  Json& json_;
  const Changes& changes_;
  const bool compress_;
  bool keep_ = false;
  std::vector<std::vector<ViewUser>> users_;
  std::vector<Block> new_blocks_;
  std::vector<NewView> views_;
};

}  // namespace

LaidOut laid_out(const Document& document, Json& json, const Changes& changes, bool compress) {
  return Relayout(document, json, changes, compress).run();
}

}  // namespace foredraw::gltf
