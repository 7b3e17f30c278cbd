// Buffer views put into buffers: plain bytes and streams into the one that is written, plain copies of what is
// compressed into the fallback that they had.
#include <foredraw/io/gltf/layout/private/layout.h>

namespace foredraw::gltf {

namespace {

constexpr const char* uncompressed = "data written uncompressed";
constexpr const char* recompressed = "data compressed again";
constexpr const char* changed = "data that changed";

/// A view's plain bytes, and who refers to where in them.
struct Plain {
  Bytes bytes;
  std::vector<Block::Place> places;
  std::vector<std::byte> made;  ///< what `bytes` lead into, unless they are as they were
};

class Placement {
 public:
  Placement(const Document& document, Json& json, bool keep, bool compress)
      : document_(document), json_(json), keep_(keep), compress_(compress), fallback_of_(document.buffers.size()) {}

  LaidOut run(const std::vector<NewView>& views) {
    out_.bytes.reserve(most_bytes(views));
    if (keep_) keep_buffers();
    for (const NewView& view : views) place(view);
    align(out_.bytes, 4);
    json_["bufferViews"] = std::move(made_);
    if (json_["bufferViews"].empty()) json_.erase("bufferViews");
    set_main_buffer();
    return std::move(out_);
  }

 private:
  /// Where nothing is compressed: so that the bytes need not move as they grow.
  std::size_t most_bytes(const std::vector<NewView>& views) const {
    std::size_t bytes = 0;
    if (keep_) {
      for (const Buffer& buffer : document_.buffers) bytes += buffer.bytes.size() + 8;
    }
    for (const NewView& view : views) {
      if (view.untouched && !keep_) bytes += document_.views[*view.number].bytes.size() + 8;
      for (const Block& block : view.blocks) bytes += block.bytes.size() + 8;
    }
    return bytes;
  }

  bool stays_fallback(std::size_t buffer) const { return compress_ && document_.buffers[buffer].fallback; }

  void keep_buffers() {
    for (std::size_t b = 0; b < document_.buffers.size(); ++b) {
      const Bytes bytes = document_.buffers[b].bytes;
      if (stays_fallback(b)) {
        Fallback& fallback = out_.fallbacks[fallback_at(b)];
        fallback.length = document_.buffers[b].length;
        fallback.bytes.assign(bytes.begin(), bytes.end());
        kept_at_.push_back(0);
      } else {
        align(out_.bytes, 8);
        kept_at_.push_back(out_.bytes.size());
        out_.bytes.insert(out_.bytes.end(), bytes.begin(), bytes.end());
      }
    }
  }

  std::size_t fallback_at(std::size_t buffer) {
    std::optional<std::size_t>& at = fallback_of_[buffer];
    if (!at) {
      at = out_.fallbacks.size();
      out_.fallbacks.push_back({document_.json["buffers"][buffer], 0, !document_.buffers[buffer].bytes.empty(), {}});
    }
    return *at;
  }

  void place(const NewView& view) {
    const BufferView* was = view.is_old ? &document_.views[*view.number] : nullptr;
    Json json = was != nullptr ? document_.json["bufferViews"][*view.number] : Json(JsonObject{{"buffer", 0}});
    const Plain plain = plain_of(view);
    const BufferView* like = view.like ? &document_.views[*view.like] : nullptr;
    const bool coded = like != nullptr && put_stream(view, plain, *like->compressed, json);
    if (!coded) {
      for (const char* name : meshopt_extensions) take_extension(json, name);
    }
    const bool keeps_place = keep_ && view.untouched && (coded || lies_in_its_buffer(*was));
    if (coded && stays_fallback(like->buffer)) {
      const std::size_t at = fallback_at(like->buffer);
      const std::size_t offset =
          keeps_place ? was->offset : append_copy(out_.fallbacks[at], plain.bytes, alignment(was));
      set_place(json, at + 1, offset, plain.bytes.size());
    } else if (keeps_place && !stays_fallback(was->buffer)) {
      set_place(json, 0, kept_at_[was->buffer] + was->offset, was->length);
    } else {
      set_place(json, 0, append(plain.bytes, alignment(was)), plain.bytes.size());
    }
    count(view, plain.bytes.size(), coded ? json : Json());
    finish(view, plain, std::move(json));
  }

  /// Not so where it is what a stream gave.
  bool lies_in_its_buffer(const BufferView& view) const {
    const Bytes buffer = document_.buffers[view.buffer].bytes;
    return !buffer.empty() && view.bytes.data() == buffer.data() + view.offset;
  }

  static std::size_t alignment(const BufferView* was) { return was != nullptr && was->offset % 8 == 0 ? 8 : 4; }

  /// Blocks one after the other. Those of a compressed view follow each other without gaps, for gaps would be elements.
  Plain plain_of(const NewView& view) const {
    if (view.untouched) return {document_.views[*view.number].bytes, view.blocks.front().places, {}};
    if (view.blocks.size() == 1 && !view.like) {
      const Block& block = view.blocks.front();
      return {block.bytes, block.places, {}};
    }
    Plain plain;
    const std::size_t step = view.like ? row_of(view) : 4;
    for (const Block& block : view.blocks) {
      plain.made.resize(aligned(plain.made.size(), step));
      for (const Block::Place& place : block.places)
        plain.places.push_back({place.holder, plain.made.size() + place.offset});
      plain.made.insert(plain.made.end(), block.bytes.begin(), block.bytes.end());
    }
    if (view.like) plain.made.resize(aligned(plain.made.size(), step));
    plain.bytes = plain.made;
    return plain;
  }

  /// Bytes of an element of the compressed view.
  std::size_t row_of(const NewView& view) const {
    if (view.stride != 0) return view.stride;
    const std::size_t row = view.blocks.front().row;
    return row != 0 ? row : document_.views[*view.like].compressed->coding.stride;
  }

  /// False where the bytes can not be compressed as they were.
  bool put_stream(const NewView& view, const Plain& plain, const Compressed& like, Json& json) {
    Json& extension = json["extensions"][like.extension];
    if (view.untouched && (like.understood || keep_)) {
      const bool stays = keep_ && !stays_fallback(like.buffer);
      const std::size_t at = stays ? kept_at_[like.buffer] + like.offset : append(like.stream, 4);
      set_place(extension, 0, at, like.stream.size());
      return true;
    }
    const auto stream =
        compressed(plain.bytes, view.untouched ? like.coding.stride : row_of(view), like.coding, like.stream);
    if (!stream) return false;
    set_place(extension, 0, append(stream->bytes, 4), stream->bytes.size());
    extension["byteStride"] = stream->coding.stride;
    extension["count"] = stream->coding.count;
    extension["mode"] = name_of(stream->coding.mode);
    if (stream->coding.filter != Coding::Filter::none || extension.contains("filter")) {
      extension["filter"] = name_of(stream->coding.filter);
    }
    return true;
  }

  void finish(const NewView& view, const Plain& plain, Json json) {
    if (view.stride != 0) {
      json["byteStride"] = view.stride;
    } else {
      json.erase("byteStride");
    }
    if (!view.is_old && view.kind() == Content::Kind::vertices) json["target"] = 34962;
    if (!view.is_old && view.kind() == Content::Kind::indices) json["target"] = 34963;
    for (const Block::Place& place : plain.places) {
      Json& holder = place.holder.json();
      holder["bufferView"] = made_.size();
      if (place.offset != 0 || holder.contains("byteOffset")) holder["byteOffset"] = place.offset;
    }
    made_.push_back(std::move(json));
  }

  /// Whoever reads why a file grew wants to know by what.
  void count(const NewView& view, std::size_t plain, const Json& coded) {
    const BufferView* was = view.is_old ? &document_.views[*view.number] : nullptr;
    const bool was_coded = was != nullptr && was->compressed.has_value();
    std::uint64_t before = was == nullptr ? 0 : was_coded ? was->compressed->stream.size() : was->length;
    std::uint64_t after = plain;
    if (coded.is_object()) after = extension_of(coded, view_extension(view))->at("byteLength").get<std::uint64_t>();
    if (before == after && view.untouched) return;
    const char* what = coded.is_object() ? recompressed : was_coded ? uncompressed : changed;
    const auto found =
        std::find_if(out_.sizes.begin(), out_.sizes.end(), [&](const Sizes& sizes) { return sizes.what == what; });
    Sizes& sizes = found != out_.sizes.end() ? *found : out_.sizes.emplace_back(Sizes{what, 0, 0});
    sizes.before += before;
    sizes.after += after;
  }

  const std::string& view_extension(const NewView& view) const {
    return document_.views[*view.like].compressed->extension;
  }

  /// The first that is no fallback says what else there is to say of the one buffer.
  void set_main_buffer() {
    Json main = Json::object();
    for (std::size_t b = 0; b < document_.buffers.size(); ++b) {
      if (document_.buffers[b].fallback) continue;
      main = document_.json["buffers"][b];
      break;
    }
    json_["buffers"] = Json::array({std::move(main)});
  }

  std::size_t append(Bytes bytes, std::size_t alignment) {
    align(out_.bytes, alignment);
    const std::size_t at = out_.bytes.size();
    out_.bytes.insert(out_.bytes.end(), bytes.begin(), bytes.end());
    return at;
  }

  static std::size_t append_copy(Fallback& fallback, Bytes bytes, std::size_t alignment) {
    const std::size_t at = aligned(fallback.length, alignment);
    fallback.length = at + bytes.size();
    if (!fallback.there) return at;
    fallback.bytes.resize(at);
    fallback.bytes.insert(fallback.bytes.end(), bytes.begin(), bytes.end());
    return at;
  }

  static void align(std::vector<std::byte>& bytes, std::size_t to) { bytes.resize(aligned(bytes.size(), to)); }

  const Document& document_;
  Json& json_;
  const bool keep_;
  const bool compress_;
  std::vector<std::optional<std::size_t>> fallback_of_;  ///< by old buffer
  std::vector<std::size_t> kept_at_;                     ///< where the old buffers stay whole
  Json made_ = Json::array();
  LaidOut out_;
};

}  // namespace

void set_place(Json& json, std::size_t buffer, std::size_t offset, std::size_t length) {
  json["buffer"] = buffer;
  if (offset != 0 || json.contains("byteOffset")) json["byteOffset"] = offset;
  json["byteLength"] = length;
}

LaidOut placed(const Document& document, Json& json, const std::vector<NewView>& views, bool keep, bool compress) {
  return Placement(document, json, keep, compress).run(views);
}

}  // namespace foredraw::gltf
